// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/run_context.hh"

#include <string>

#include "surfmesh/core/error.hh"

namespace surfmesh {

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
  }
  if (was_cancelled_) throw Error(ErrorCode::Cancelled, "the run was cancelled");
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
              "more than max_elements = " + std::to_string(max_elements_) + " triangles");
}

}  // namespace surfmesh
