// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <string>
#include <string_view>
#include <vector>

namespace surfmesh::testing {

/// A program on a terminal of its own, whose output is kept.
class PseudoTerminal {
 public:
  /// Run a line of the shell in a window of so many columns.
  PseudoTerminal(const std::string& line, unsigned short columns) {
    winsize size = {.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    process_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (process_ != 0) return;
    execl("/bin/sh", "sh", "-c", ("exec " + line).c_str(), nullptr);
    _exit(127);
  }
  ~PseudoTerminal() {
    if (process_ > 0) wait();
    if (terminal_ >= 0) close(terminal_);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void resize(unsigned short columns) const {
    const winsize size = {.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    ioctl(terminal_, TIOCSWINSZ, &size);
  }

  void send(int signal) const { kill(process_, signal); }

  /// Wait until the output has this text after `from`, for at most half a minute. Returns whether
  /// it came.
  bool wait_for(std::string_view text, std::size_t from = 0) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (output_.find(text, std::min(from, output_.size())) == std::string::npos) {
      if (std::chrono::steady_clock::now() > end || !read_some()) return false;
    }
    return true;
  }

  /// Read the rest and wait for the end. Returns the exit status.
  int wait() {
    while (read_some()) {
    }
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  const std::string& output() const { return output_; }

 private:
  /// False at the end of the output.
  bool read_some() {
    pollfd ready = {.fd = terminal_, .events = POLLIN, .revents = 0};
    if (poll(&ready, 1, 1000) == 0) return true;
    char buffer[4096];
    const ssize_t size = read(terminal_, buffer, sizeof buffer);
    if (size <= 0) return false;
    output_.append(buffer, static_cast<std::size_t>(size));
    return true;
  }

  int terminal_ = -1;
  pid_t process_ = 0;
  std::string output_;
};

/// What a terminal shows after an output: its lines, without those that are empty. It knows what
/// our program uses, carriage return, line feed, and clearing to the end of the line or screen.
inline std::vector<std::string> shown_lines(std::string_view output) {
  std::vector<std::string> lines(1);
  std::size_t column = 0;
  while (!output.empty()) {
    std::string_view::size_type taken = 1;
    std::string& line = lines.back();
    if (output.starts_with("\x1b[J") || output.starts_with("\x1b[K")) {
      line.resize(std::min(column, line.size()));
      taken = 3;
    } else if (output.front() == '\r') {
      column = 0;
    } else if (output.front() == '\n') {
      lines.emplace_back();
      column = 0;
    } else {
      line.resize(std::max(line.size(), column + 1), ' ');
      line[column++] = output.front();
    }
    output.remove_prefix(taken);
  }
  std::erase(lines, "");
  return lines;
}

}  // namespace surfmesh::testing
