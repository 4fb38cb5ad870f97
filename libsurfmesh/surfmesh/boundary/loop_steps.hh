// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/model/model.hh"

/// The loops of a patch segment by segment, and the poles in them.
namespace surfmesh {

/// One segment of a contour as a loop runs along it.
struct LoopStep {
  LoopEntry entry;
  std::size_t node = 0;     ///< of the contour, from which the step starts
  std::size_t segment = 0;  ///< of the contour
};

/// The steps of a loop in its direction; `segment_count` gives that of a contour by its index.
template <class SegmentCount>
std::vector<LoopStep> steps_along(const Model& model, const PatchLoop& loop,
                                  SegmentCount segment_count) {
  std::vector<LoopStep> steps;
  for (const LoopEntry& entry : loop) {
    const std::size_t count = segment_count(entry.contour);
    const bool is_forward = model.use(entry).is_forward;
    for (std::size_t i = 0; i < count; ++i) {
      if (is_forward) {
        steps.push_back({entry, i, i});
      } else {
        steps.push_back({entry, count - i, count - 1 - i});
      }
    }
  }
  return steps;
}

/// True if the step leads along a degenerate contour, from a pole to itself.
bool is_on_pole(const Model& model, const LoopStep& step);

/// Steps in a row that lie on a pole.
struct PoleRun {
  std::size_t first = 0;  ///< step
  std::size_t count = 0;
};

/// The poles of a closed loop; none if all its steps lie on poles. A run may go on at the beginning
/// of the list.
std::vector<PoleRun> pole_runs(const Model& model, const std::vector<LoopStep>& steps);

/// True if a loop of the patch has a pole.
bool has_pole(const Model& model, const Patch& patch);

}  // namespace surfmesh
