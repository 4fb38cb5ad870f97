// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/curvature.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Faces at a vertex from which on each is narrower than an element: on a cone, elements of a
/// quarter of the radius of curvature are 25 around.
inline constexpr std::size_t kWideFan = 25;

/// A vertex of a cage with so many patches that elements are wider than these, as a patch near it
/// sees it.
///
/// The limit surface has ripples there: each face is a bump. Bumps of a hundred faces are as high
/// as those of twenty, so curvature grows with the square of their number, and elements that
/// followed it with its cube. But the mean curvature over a face is that of the shape that the cage
/// shows, because the bumps begin and end at the edges that lead to the vertex.
struct WideFan {
  Vec3 centre;
  /// By cell of the patch, rows along u: the greatest curvature around the vertex that counts,
  /// times the distance from it. Infinite for cells that are far away, where all counts.
  std::vector<double> turns;
};

/// Find the wide fans that each patch of a model belongs to or is near, by patch.
///
/// What counts is twice the mean over a cell, and at least the curvature of a cone of 45°.
///
/// Cost     O(n log n) for a vertex of n patches; 10 evaluations for each cell near it, and one for
///          other cells of the same patches
std::vector<std::vector<WideFan>> wide_fans(const Model& model);

/// Limit the curvature around a vertex to `turn` divided by the distance from it. Curvature towards
/// the vertex is kept; what lies between counts by the square of its cosine.
///
/// Pre      k are the principal curvatures of the jet
PrincipalCurvatures without_ripples(const PrincipalCurvatures& k, const Jet& jet,
                                    const Vec3& centre, double turn);

}  // namespace surfmesh
