// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hh"
#include "standard_output.hh"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace surfmesh {
namespace {

/// More lines a second than these nobody reads.
constexpr std::chrono::milliseconds kLeastInterval{100};

}  // namespace

void Progress::progress(std::string_view stage, std::size_t done, std::size_t total) {
  if (!is_shown_) return;
  const Clock::time_point now = Clock::now();
  if (stage == stage_ && done != total && now - last_ < kLeastInterval) return;
  stage_ = stage;
  last_ = now;
  has_line_ = true;
  tell(fmt::format("\r\x1b[K{} {}/{}", stage, done, total));
  std::fflush(stderr);
}

void Progress::clear() {
  if (!has_line_) return;
  tell("\r\x1b[K");
  has_line_ = false;
}

bool is_terminal() { return isatty(STDERR_FILENO) == 1; }

}  // namespace surfmesh
