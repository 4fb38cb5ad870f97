// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "surfmesh/core/error.hh"

namespace surfmesh {

/// Told of the progress of a run; the library itself never prints.
class Observer {
 public:
  virtual ~Observer() = default;

  /// A stage has finished `done` of `total` units (patches, contours); called at its begin with 0.
  virtual void progress(std::string_view stage, std::size_t done, std::size_t total) = 0;

  /// Asked between units of work; true ends the run with an Error of code Limit.
  virtual bool is_cancelled() { return false; }
};

/// Steps of a loop (insertions, vertices) between two questions whether it is cancelled: some
/// milliseconds.
inline constexpr std::size_t kStepsBetweenCancellation = 4096;

/// End a run that its observer has cancelled.
/// Throws   Limit
inline void throw_if_cancelled(Observer* observer) {
  if (observer && observer->is_cancelled()) throw Error(ErrorCode::Limit, "cancelled");
}

}  // namespace surfmesh
