// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/assemble/piece.hh"
#include "surfmesh/boundary/patch_boundary.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh {

/// The mesh of a tile as plain arrays.
struct TilePart {
  int patch = -1;
  /// The numbers, as NodeNumbers gives them, of the vertices that other tiles may have, too,
  /// ascending: they come first. All others are its own.
  std::vector<int> shared;
  /// By vertex. Those of poles are unset, for the mesh of a tile ends before them.
  std::vector<Vec3> points;
  FaceList faces;  ///< of vertices of the part, in the direction that the result has

  std::size_t own_count() const { return points.size() - shared.size(); }
};

/// Look at the border of a tile as assemble() does. Own vertices have numbers behind all that
/// `numbers` counts. `is_turned` tells that the patch is turned over in the result.
/// Cost     O(m log m) of m elements at the border
detail::Piece surveyed(PatchMesh tile, const NodeNumbers& numbers, bool is_turned);

/// Take the faces of a tile, in the order and from the corner on that the result of assemble() has.
/// Pre      `shared_count` is that of the numbers with which it was surveyed
/// Cost     O(faces)
TilePart part_of(const detail::Piece& tile, int shared_count);

}  // namespace surfmesh
