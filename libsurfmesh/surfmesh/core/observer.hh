// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "surfmesh/core/error.hh"

namespace surfmesh {

/// Receives the progress of a run; the library itself never prints.
class Observer {
 public:
  virtual ~Observer() = default;

  /// A stage has finished `done` of `total` units (patches, contours); called with 0 when the stage
  /// begins.
  virtual void progress(std::string_view stage, std::size_t done, std::size_t total) = 0;

  /// Asked between units of work; true ends the run with an Error of code Limit.
  virtual bool is_cancelled() { return false; }
};

/// Loop steps (insertions, vertices) between two checks for cancellation: a few milliseconds.
inline constexpr std::size_t kStepsBetweenCancellation = 4096;

/// End a run that its observer has cancelled.
/// Throws   Limit
inline void throw_if_cancelled(Observer* observer) {
  if (observer && observer->is_cancelled()) throw Error(ErrorCode::Limit, "cancelled");
}

}  // namespace surfmesh
