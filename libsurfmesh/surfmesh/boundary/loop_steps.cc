// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/loop_steps.hh"

#include <algorithm>

namespace surfmesh {

bool is_on_pole(const Model& model, const LoopStep& step) {
  return model.contour(step.entry).is_degenerate;
}

std::vector<PoleRun> pole_runs(const Model& model, const std::vector<LoopStep>& steps) {
  const std::size_t n = steps.size();
  const auto is_pole = [&](std::size_t i) { return is_on_pole(model, steps[i % n]); };
  std::vector<PoleRun> runs;
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_pole(i) || is_pole(i + n - 1)) continue;
    PoleRun& run = runs.emplace_back(PoleRun{i, 1});
    while (is_pole(i + run.count)) ++run.count;
  }
  return runs;
}

bool has_pole(const Model& model, const Patch& patch) {
  return std::any_of(patch.loops.begin(), patch.loops.end(), [&](const PatchLoop& loop) {
    return std::any_of(loop.begin(), loop.end(),
                       [&](const LoopEntry& entry) { return model.contour(entry).is_degenerate; });
  });
}

}  // namespace surfmesh
