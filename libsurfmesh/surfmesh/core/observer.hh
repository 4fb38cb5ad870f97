// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Receives the progress of a run; the library itself never prints.
class Observer {
 public:
  virtual ~Observer() = default;

  /// A stage has finished `done` of `total` units (patches, contours); called with 0 when the stage
  /// begins.
  virtual void progress(std::string_view stage, std::size_t done, std::size_t total) = 0;

  /// Asked between units of work; true ends the run with an Error of code Cancelled.
  virtual bool is_cancelled() { return false; }
};

}  // namespace surfmesh
