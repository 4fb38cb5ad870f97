// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// The vertices that a piece of a mesh has in common with another one.
struct SharedWithPiece {
  int piece = -1;             ///< the other one
  std::vector<int> vertices;  ///< of this piece, ascending by their ids: both list them alike
};

/// A piece of a mesh that is never in one place, as plain arrays.
///
/// Vertices that copies stand for in a half-edge mesh, where three and more patches meet, are one.
struct MeshPiece {
  std::vector<Vec3> points;
  std::vector<std::int64_t> ids;            ///< by vertex, in the whole mesh, counted from 0
  FaceList faces;                           ///< of vertices of this piece: triangles, or quads
  std::vector<int> patches;                 ///< by face, index in Model::patches
  std::vector<SharedWithPiece> neighbours;  ///< ascending by piece
};

}  // namespace surfmesh
