// SPDX-License-Identifier: BSD-3-Clause
#include "compare/run_process.hh"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "surfmesh/core/error.hh"

namespace surfmesh::compare {
namespace {

constexpr const char* kLog = "run.log";
constexpr int kNoSuchProgram = 127;  // as shells have it

/// Become the program; only what may be done between fork and exec.
[[noreturn]] void become(char* const* arguments, const char* directory) {
  setpgid(0, 0);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // do not outlive the comparison
#endif
  if (chdir(directory) != 0) _exit(kNoSuchProgram);
  const int log = open(kLog, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const int nothing = open("/dev/null", O_RDONLY);
  if (log >= 0 && nothing >= 0) {
    dup2(nothing, STDIN_FILENO);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    execvp(arguments[0], arguments);
  }
  _exit(kNoSuchProgram);
}

double seconds(const timeval& time) {
  constexpr double kMicrosecond = 1e-6;
  return static_cast<double>(time.tv_sec) + kMicrosecond * static_cast<double>(time.tv_usec);
}

/// Wait for the end of a process and set all but the log. Polls, as there is no wait with a limit.
void wait_for(pid_t process, double time_limit, ProcessRun& run) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kPause{5};
  const auto start = Clock::now();
  const auto end = start + std::chrono::duration<double>(time_limit);
  int status = 0;
  rusage usage = {};
  for (pid_t ended = 0; ended == 0;) {
    ended = wait4(process, &status, run.is_timed_out ? 0 : WNOHANG, &usage);
    if (ended < 0 && errno == EINTR) ended = 0;
    if (ended < 0) throw Error(ErrorCode::Io, "the end of another process cannot be seen");
    if (ended != 0) break;
    if (Clock::now() > end) {
      run.is_timed_out = true;
      kill(-process, SIGKILL);
    } else {
      std::this_thread::sleep_for(kPause);
    }
  }
  run.clock_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  run.processor_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  if (WIFEXITED(status)) run.status = WEXITSTATUS(status);
}

}  // namespace

ProcessRun run_process(const Command& command, const std::filesystem::path& directory,
                       double time_limit) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  std::error_code error;
  std::filesystem::remove(directory / kLog, error);  // that of another run
  setenv("OMP_NUM_THREADS", "1", 1);
  const pid_t process = fork();
  if (process < 0) throw Error(ErrorCode::Io, "cannot start another process");
  if (process == 0) become(arguments.data(), directory.c_str());
  setpgid(process, process);  // by both, so that it holds before either goes on
  ProcessRun run;
  wait_for(process, time_limit, run);
  std::ifstream log(directory / kLog, std::ios::binary);
  run.log.assign(std::istreambuf_iterator<char>(log), std::istreambuf_iterator<char>());
  return run;
}

std::string failure_of(const ProcessRun& run) {
  if (run.is_timed_out) return "stopped at the time limit";
  if (run.signal != 0) return fmt::format("crashed (signal {})", run.signal);
  if (run.status != 0) return fmt::format("failed (exit status {})", run.status);
  return "";
}

std::string command_line(const Command& command) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=%+,-";
  std::string line;
  for (const std::string& word : command) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace surfmesh::compare
