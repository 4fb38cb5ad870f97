// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Make the limit surface over each face of a cage; null for faces that have none (holes, and by
/// BoundaryRule::None the faces at the boundary).
///
/// All faces must be quads (domain: the unit square) or, under Loop, triangles (domain: the unit
/// triangle): see refine_once. Corner i of the domain is vertex i of the face, parameters run
/// evenly along sides, so two faces give the same point at the same share of their common edge.
///
/// singular_points() of a surface are the corners at which it is not one polynomial: irregular
/// valence, ends of sharp creases, semi-sharp tags. Nearer to them than `reach` = 2^-(level-1) the
/// derivatives of OpenSubdiv are those of its approximation, and first ones may vanish; there the
/// position is that of the point asked for, but all derivatives are taken at distance `reach` from
/// the corner in the same direction (at the corner itself: on the diagonal). They jump there.
///
/// Units    parameters have no dimension, an edge of a face is 1 long
/// Error    positions 1e-5 of the cage's size at level 8, 2e-4 at level 6, at extraordinary
///          vertices only (test LimitSurface.LevelsAgreeWithinTheirBounds)
/// Cost     regular Catmull-Clark faces 1 µs and 0.5 kB, others up to 40 µs and 12 kB. Evaluating
///          takes the same time at all levels
/// Throws   InvalidInput for a cage that cannot be subdivided, or with faces of the wrong size;
///          InvalidOption for an approximation level outside of 1 to 10
/// Source   Pixar's OpenSubdiv 3.5, Bfr
std::vector<std::shared_ptr<const Surface>> make_limit_surfaces(const Cage& cage, Scheme scheme,
                                                                int approximation_level = 8);

}  // namespace surfmesh
