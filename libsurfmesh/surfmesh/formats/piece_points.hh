// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/pieces/mesh_piece.hh"

namespace surfmesh {

/// Throws   Geometry, with the id of the vertex, if a position is not finite
void check_points(const MeshPiece& piece);

}  // namespace surfmesh
