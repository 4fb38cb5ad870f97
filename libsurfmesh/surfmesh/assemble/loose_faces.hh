// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/assemble/piece.hh"

namespace surfmesh::detail {

/// Make the faces of a piece that are no copies of those of its mesh: what is left of faces of
/// which corners are one vertex of the result, and the fans around poles.
///
/// Writes   loose_faces, collapsed and face_count of the piece
/// Pre      `collapsed` are the faces that have such corners, ascending
void make_loose_faces(Piece& piece, const std::vector<FaceHandle>& collapsed);

}  // namespace surfmesh::detail
