// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Sharpness from which on OpenSubdiv takes a crease for a sharp edge.
inline constexpr double kSharp = 10;

/// Make a sharp crease of each edge of two faces that meet at more than an angle: that between
/// their normals, degrees, 0 where they lie in a plane.
///
/// The normal of a polygon that is not plane is that of its area. Faces that pass the edge in the
/// same direction are taken as seen from one side. Edges of one face or of more than two stay as
/// they are, and so do faces without area.
/// Pre      the vertices of faces exist
/// Cost     O(n log n) for n face corners
void add_creases(double degrees, Cage& cage);

/// Make a crease along a chain of vertices. A crease that is there becomes sharper, never less.
///
/// Throws   InvalidInput for a vertex that is not there, or two that follow each other and are not
///          the ends of an edge
void add_crease(const std::vector<int>& vertices, double sharpness, Cage& cage);

/// Make a crease of the edges at the border of a group, between a face of it and one that is not.
///
/// Throws   InvalidInput if there is no group of this name, or no such edge
void add_crease_around(const std::string& group, double sharpness, Cage& cage);

}  // namespace surfmesh
