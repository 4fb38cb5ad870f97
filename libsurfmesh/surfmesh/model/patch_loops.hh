// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/loop_checks.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// The curve of a contour use as a loop runs through it. Its range is that of t.
inline LoopCurve loop_curve(const Model& model, const LoopEntry& entry) {
  const ContourUse& use = model.use(entry);
  return {model.contour(entry).name, use.curve, use.is_forward, {}};
}

/// The curves of a loop.
inline LoopCurves loop_curves(const Model& model, const PatchLoop& loop) {
  LoopCurves curves;
  for (const LoopEntry& entry : loop) curves.push_back(loop_curve(model, entry));
  return curves;
}

/// The curves of all loops of a patch.
inline std::vector<LoopCurves> loop_curves(const Model& model, const Patch& patch) {
  std::vector<LoopCurves> curves;
  for (const PatchLoop& loop : patch.loops) curves.push_back(loop_curves(model, loop));
  return curves;
}

}  // namespace surfmesh
