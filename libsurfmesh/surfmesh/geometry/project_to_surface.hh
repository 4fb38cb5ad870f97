// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// A point of a surface, as seen from a point in space.
struct SurfaceFoot {
  Uv uv;
  double distance = kUnset;  ///< from the point, in model units
};

/// Find the point of a surface nearest to a point in space, near a guess and within the domain.
///
/// Where the surface is singular (a pole) the parameter that has no effect keeps its guess.
///
/// Error    for a point on the surface the distance is a few roundings of its coordinates (test
///          ProjectToSurface.*); for a point at distance d from a surface of curvature k, the
///          result is good if k d is below 1/2
/// Cost     for a point on the surface with a fair guess 2 to 4 evaluations of first order
/// Pre      the domain is a rectangle
SurfaceFoot project_to_surface(const Surface& surface, const Vec3& point, Uv guess);

/// Find the points of a surface that are nearer to a point in space than all points around them,
/// the nearest first.
///
/// On a seam, the points of both sides are found. A point that is near only between four of the 33
/// × 33 samples of the domain may be missed.
///
/// Cost     1,089 evaluations, and some tens for each point found
/// Pre      the domain is a rectangle
std::vector<SurfaceFoot> find_near_points(const Surface& surface, const Vec3& point);

}  // namespace surfmesh
