// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/assemble/piece.hh"

namespace surfmesh::detail {

/// What the corner at the pole holds in the face of a fan that begins at node `i` of its ring. The
/// metric is singular at a pole: that of the face's first and last node of the ring is taken.
CornerValue value_at_pole(const PoleFan& fan, std::size_t i, const Metric& first,
                          const Metric& last);

/// Make the faces of a piece that are no copies of those of its mesh: what is left of faces of
/// which corners are one vertex of the result, and the fans around poles.
///
/// Writes   loose_faces, collapsed and face_count of the piece
/// Pre      `collapsed` are the faces that have such corners, ascending
void make_loose_faces(Piece& piece, const std::vector<FaceHandle>& collapsed);

}  // namespace surfmesh::detail
