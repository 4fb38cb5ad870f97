// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/run_context.hh"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// The observer is told of elements at most four times a second.
constexpr std::chrono::milliseconds kLeastInterval{250};

}  // namespace

std::string_view name(ElementKind kind) {
  return kind == ElementKind::Triangles ? "triangles" : "quads";
}

double elements_per_triangle(ElementKind kind) {
  return kind == ElementKind::Triangles ? 1 : std::numbers::sqrt3 / 4;
}

void RunContext::tell(std::string_view stage, std::size_t done, std::size_t total) const {
  if (!observer_) return;
  {
    const std::lock_guard lock(mutex_);
    observer_->progress(stage, done, total);
  }
  throw_if_cancelled();
}

void RunContext::throw_if_cancelled() const {
  if (!observer_) return;
  {
    const std::lock_guard lock(mutex_);
    if (!was_cancelled_) was_cancelled_ = observer_->is_cancelled();
    tell_at_work();
  }
  if (was_cancelled_) throw Error(ErrorCode::Cancelled, "the run was cancelled");
}

/// Counts of other threads change meanwhile, so that their sum may be a little wrong.
void RunContext::tell_at_work() const {
  const Clock::time_point now = Clock::now();
  if (now - told_ < kLeastInterval) return;
  told_ = now;
  const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(elements_) + unfinished_;
  observer_->at_work(static_cast<std::size_t>(std::max<std::ptrdiff_t>(count, 0)), pass_);
}

std::size_t RunContext::elements_left() const {
  const std::size_t count = elements_;
  if (count >= max_elements_) throw_too_many_elements();
  return max_elements_ - count;
}

void RunContext::add_elements(std::size_t count) const {
  if ((elements_ += count) > max_elements_) throw_too_many_elements();
}

void RunContext::throw_too_many_elements() const {
  throw Error(ErrorCode::Limit,
              fmt::format("more than max_elements = {} {}", max_elements_, name(kind_)));
}

}  // namespace surfmesh
