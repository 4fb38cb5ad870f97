// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Make the limit surface of each face of a cage; null for faces that have none (holes, and faces
/// at the boundary with BoundaryRule::None).
///
/// All faces must be quads (domain: the unit square) or, for Loop, triangles (domain: the unit
/// triangle): see refine_once. Corner i of the domain is vertex i of the face. Parameters run
/// evenly along sides, so two faces give the same point at the same share of their common edge. All
/// are CageSurfaces: they tell their places on the cage.
///
/// singular_points() of a surface are the corners where it is not one polynomial: irregular
/// valence, ends of sharp creases, semi-sharp tags. Nearer to them than `reach` = 2^-(level-1),
/// OpenSubdiv has only the derivatives of its approximation, and the first ones may vanish. There
/// the position is exact, but all derivatives are those at distance `reach` from the corner in the
/// same direction (at the corner itself: on the diagonal). Derivatives jump at that distance.
///
/// Units    parameters have no dimension; an edge of a face has length 1
/// Error    positions 1e-5 of the cage's size at level 8, 2e-4 at level 6, at extraordinary
///          vertices only (test LimitSurface.LevelsAgreeWithinTheirBounds)
/// Cost     1 µs and 0.5 kB for regular Catmull-Clark faces, up to 40 µs and 12 kB for others.
///          Evaluation takes the same time at all levels
/// Throws   InvalidInput for a cage that cannot be subdivided or has faces of the wrong size;
///          InvalidOption for an approximation level outside 1 to 10
/// Source   Pixar's OpenSubdiv 3.5, Bfr
std::vector<std::shared_ptr<const Surface>> make_limit_surfaces(const Cage& cage, Scheme scheme,
                                                                int approximation_level = 8);

}  // namespace surfmesh
