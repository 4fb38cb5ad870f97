// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Sharpness from which on OpenSubdiv takes a crease for a sharp edge.
inline constexpr double kSharp = 10;

/// An edge of two faces and how much they turn there.
struct EdgeTurn {
  std::array<int, 2> ends = {-1, -1};  ///< vertices, the lower one first
  std::array<int, 2> faces = {-1, -1};
  double angle = 0;  ///< between the normals of the faces, radians
};

/// The edges of two faces, and the angles at which these meet; see add_creases.
///
/// Cost     O(n log n) for n face corners
std::vector<EdgeTurn> edge_turns(const Cage& cage);

/// Make a sharp crease of each edge of two faces that meet at more than an angle: that between
/// their normals, degrees, 0 where they lie in a plane.
///
/// The normal of a polygon that is not plane is that of its area. Faces that pass the edge in the
/// same direction are taken as seen from one side. Edges of one face or of more than two stay as
/// they are, and so do faces without area.
/// Pre      the vertices of faces exist
/// Cost     O(n log n) for n face corners
void add_creases(double degrees, Cage& cage);

/// The edges of which add_creases makes creases, by their vertices, the lower one first.
std::vector<std::array<int, 2>> edges_above(double degrees, const Cage& cage);

/// Tells for each face whether it is a hole. Numbers of faces that do not exist are ignored.
std::vector<char> marks_of_holes(const Cage& cage);

/// The edges at which the surface of a cage ends or is cut: of one face that is no hole, or of more
/// than two faces; by their vertices, the lower one first.
///
/// Cost     O(n log n) for n face corners
std::vector<std::array<int, 2>> border_edges(const Cage& cage);

/// Make sharp creases of edges.
/// Pre      they are edges of the cage
void add_creases(const std::vector<std::array<int, 2>>& edges, Cage& cage);

/// Make a crease along a chain of vertices. A crease that is there becomes sharper, never less.
///
/// Throws   InvalidInput for a vertex that is not there, or two that follow each other and are not
///          the ends of an edge
void add_crease(const std::vector<int>& vertices, double sharpness, Cage& cage);

/// The same for several chains.
void add_creases(const std::vector<std::vector<int>>& chains, double sharpness, Cage& cage);

/// Make a crease of the edges at the border of a group, between a face of it and one that is not.
///
/// Throws   InvalidInput if there is no group of this name, or no such edge
void add_crease_around(const std::string& group, double sharpness, Cage& cage);

}  // namespace surfmesh
