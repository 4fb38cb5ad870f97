// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/domain.hh"

/// Checks of the loops of one patch in its parameters, apart for their tests.
namespace surfmesh {

/// A contour use as a loop runs through it.
struct LoopCurve {
  std::string name;  ///< of the contour, for messages
  std::shared_ptr<const Curve> curve;
  bool is_along = true;  ///< from t = 0 to t = 1
  CurveRange range;      ///< for messages

  /// The point at the share s of the way through the loop's run of it.
  Uv at(double s) const { return curve->evaluate(is_along ? s : 1 - s); }
};

using LoopCurves = std::vector<LoopCurve>;

/// Twice the area that the loop encloses, from samples: positive if it runs counter-clockwise.
double signed_area(const LoopCurves& loop);

/// A place of a loop that is outside of the domain by more than rounding, in words; nothing if it
/// is inside everywhere.
std::optional<std::string> find_point_outside(const LoopCurves& loop, const Domain& domain);

/// The place where two of these loops, or one and itself, cross, in words.
///
/// Curves are compared as polylines, which are made finer where they cross. Curves that touch or
/// overlap without crossing are not found.
/// Cost     O(n log n) for n samples, 64 a curve
std::optional<std::string> crossing(const std::vector<LoopCurves>& loops);

/// Two contours, or parts of one, that come near without crossing, and where.
struct NearParts {
  std::string a;
  std::string b;
  Uv at_a;
  Uv at_b;
};

/// Parts of loops that are nearer to each other than `share` of the extent of all loops, u and v
/// measured by themselves: of each two contours the nearest ones. Parts of one loop are compared if
/// they are a quarter of a contour or more, and more than six times the gap, apart along it.
/// Cost     O(n log n) for n samples, 64 a curve, and 100 evaluations for each two that seem near
std::vector<NearParts> near_parts(const std::vector<LoopCurves>& loops, double share);

}  // namespace surfmesh
