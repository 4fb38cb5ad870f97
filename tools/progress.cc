// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hh"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "standard_output.hh"

namespace surfmesh {
namespace {

/// Between two drawings. A run that is over sooner shows nothing.
constexpr std::chrono::milliseconds kInterval{125};

/// Back to the first column, and clear what is behind and below it.
constexpr const char* kWipe = "\r\x1b[J";

/// Start a thread that gets no signals: these are to interrupt what the others wait for.
template <class Body>
std::thread thread_without_signals(Body body) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(body));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace

Progress::Progress(bool is_shown, std::span<const StageWeight> stages)
    : is_shown_(is_shown),
      has_bar_(is_shown && !is_dumb_terminal()),
      has_unicode_(is_shown && shows_unicode(STDERR_FILENO)),
      share_(stages) {
  if (has_bar_) drawer_ = thread_without_signals([this] { draw_until_cleared(); });
}

void Progress::progress(std::string_view stage, std::size_t done, std::size_t total) {
  if (!is_shown_) return;
  const std::lock_guard lock(mutex_);
  const bool is_new = share_.stage() != stage;
  share_.progress(stage, done, total);
  if (is_new && !has_bar_ && share_.stage() == stage) tell_stage();
}

void Progress::at_work(std::size_t elements, int /*pass*/) {
  if (!is_shown_) return;
  const std::lock_guard lock(mutex_);
  share_.at_work(elements);
}

void Progress::expect_passes() {
  const std::lock_guard lock(mutex_);
  share_.expect_passes();
}

/// With the number of its units, which are patches or contours.
void Progress::tell_stage() {
  if (is_cleared_) return;
  tell(share_.total() > 1 ? fmt::format("surfmesh: {} ({})\n", share_.stage(), share_.total())
                          : fmt::format("surfmesh: {}\n", share_.stage()));
}

void Progress::draw_until_cleared() {
  std::unique_lock lock(mutex_);
  while (!has_ended_.wait_for(lock, kInterval, [this] { return is_cleared_; })) draw();
}

void Progress::draw() {
  if (share_.stage().empty() || caught_signal() != 0) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  // The last column stays free: a cursor behind it would be in the next line. It goes back to the
  // first one, which is where the line begins also after a terminal became narrower and wrapped it.
  const std::size_t width = std::max<std::size_t>(terminal_width(STDERR_FILENO), 2) - 1;
  set_terminal_wipe(kWipe);
  tell(fmt::format("{}{}\r", kWipe, progress_line(share_, seconds, width, has_unicode_)));
}

void Progress::clear() {
  {
    const std::lock_guard lock(mutex_);
    is_cleared_ = true;
  }
  has_ended_.notify_all();
  if (drawer_.joinable()) drawer_.join();
  wipe_terminal();
}

}  // namespace surfmesh
