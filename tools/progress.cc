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
  const bool is_due = stage != stage_ || done == total || Clock::now() - last_ >= kLeastInterval;
  stage_ = stage;
  done_ = done;
  total_ = total;
  if (is_due) show();
}

void Progress::at_work(std::size_t elements, int pass) {
  if (!is_shown_ || stage_.empty()) return;
  elements_ = elements;
  pass_ = pass;
  show();
}

/// "mesh 3/48, 120000 elements, pass 2, 1.4 s"
void Progress::show() {
  last_ = Clock::now();
  has_line_ = true;
  const double seconds = std::chrono::duration<double>(last_ - start_).count();
  const std::string elements =
      elements_ > 0 ? fmt::format(", {} elements", elements_) : std::string();
  const std::string pass = pass_ > 1 ? fmt::format(", pass {}", pass_) : std::string();
  tell(fmt::format("\r\x1b[K{} {}/{}{}{}, {:.1f} s", stage_, done_, total_, elements, pass,
                   seconds));
  std::fflush(stderr);
}

void Progress::clear() {
  if (!has_line_) return;
  tell("\r\x1b[K");
  has_line_ = false;
}

bool is_terminal() { return isatty(STDERR_FILENO) == 1; }

}  // namespace surfmesh
