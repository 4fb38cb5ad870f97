// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/assemble/piece.hh"

namespace surfmesh::detail {

/// Find what of a piece is not a copy of its mesh, and which of its sides are glued to others.
///
/// Writes   border_edges, collapsed, loose_faces, face_count and sides of the piece
/// Cost     O(m log m) of m elements at its border; none for those inside
void survey_border(Piece& piece);

}  // namespace surfmesh::detail
