// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {

/// A part of a side between two model vertices that follow each other on it.
struct SidePiece {
  int side = -1;
  int part = 0;          ///< number of the part on its side
  bool is_whole = true;  ///< the only part
  int start = -1;        ///< vertex at the lower parameter
  int end = -1;          ///< vertex at the higher parameter
  SideLine line;
};

/// Sides divided at vertices.
struct SplitSides {
  std::vector<Vec3> vertices;
  std::vector<SidePiece> pieces;  ///< by side, then by growing parameter
};

/// Find the vertices of the model, and divide each side at the vertices that lie on it.
///
/// Ends of sides within the tolerance of each other are one vertex, transitively; it has the
/// position of the first of them in the order of sides. A vertex that is another place than an end
/// of the side, or than a vertex that divides it before, but within about four tolerances along the
/// side, does not divide it: so no piece is that short, unless it is a whole side. Sets
/// is_degenerate of the sides.
///
/// Cost     O(n log n) for n sides that are short against the model
SplitSides split_sides(std::vector<PatchSide>& sides, double tolerance);

}  // namespace surfmesh
