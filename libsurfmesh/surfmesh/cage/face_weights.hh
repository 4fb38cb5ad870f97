// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/cage/cage_surface.hh"

namespace surfmesh {

/// The shares that the corners of a face of a cage have in what is at a place on it.
///
/// Barycentric coordinates in a triangle, bilinear weights in a quad. The quarter of a polygon is
/// bilinear between its corner, the middles of two sides and the mean of all corners. So values are
/// linear along sides, and agree where two faces meet. Corners whose side to the next one is a
/// point, or was welded, have no share.
///
/// Returns  a weight for each corner of the face as given, with the sum 1
/// Throws   InvalidInput for a place of no face of the cage
/// Cost     O(corners), 30 ns for a triangle
std::vector<double> face_weights(const Cage& cage, const CagePlace& place);

/// The corners of a face that are left when only `count` are: first those go that have the vertex
/// of the next one, then those that are nearest to it. Ascending.
///
/// Pre      the face exists
std::vector<int> kept_corners(const Cage& cage, int face, int count);

}  // namespace surfmesh
