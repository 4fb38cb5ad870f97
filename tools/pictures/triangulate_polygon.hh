// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Divide a polygon in space that is nearly flat, but need not be convex, into triangles of its
/// corners.
///
/// Ear clipping, the ear with the shortest cut first: a convex quad is cut at its shorter diagonal.
/// Where no ear is left, as in a polygon that crosses itself, the rest is a fan.
///
/// Cost     O(n³)
std::vector<std::array<int, 3>> triangulate_polygon(const std::vector<Vec3>& corners);

}  // namespace surfmesh
