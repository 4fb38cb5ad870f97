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

  /// The run is at work, on the `pass`th mesh of it (a sag takes several; 0 before the first),
  /// which has `elements` so far, those of patches that are not finished included. Called a few
  /// times a second, also within a patch.
  virtual void at_work(std::size_t /*elements*/, int /*pass*/) {}

  /// Asked between units of work; true ends the run with an Error of code Cancelled.
  virtual bool is_cancelled() { return false; }
};

}  // namespace surfmesh
