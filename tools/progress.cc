// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hh"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace surfmesh {
namespace {

volatile std::sig_atomic_t signal_number = 0;

extern "C" void remember_signal(int number) { signal_number = number; }

/// More lines a second than these nobody reads.
constexpr std::chrono::milliseconds kLeastInterval{100};

}  // namespace

void catch_signals() {
  struct sigaction action = {};
  action.sa_handler = remember_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int caught_signal() { return signal_number; }

void Progress::progress(std::string_view stage, std::size_t done, std::size_t total) {
  if (!is_shown_) return;
  const Clock::time_point now = Clock::now();
  if (stage == stage_ && done != total && now - last_ < kLeastInterval) return;
  stage_ = stage;
  last_ = now;
  has_line_ = true;
  fmt::print(stderr, "\r\x1b[K{} {}/{}", stage, done, total);
  std::fflush(stderr);
}

void Progress::clear() {
  if (!has_line_) return;
  fmt::print(stderr, "\r\x1b[K");
  has_line_ = false;
}

bool is_terminal() { return isatty(STDERR_FILENO) == 1; }

}  // namespace surfmesh
