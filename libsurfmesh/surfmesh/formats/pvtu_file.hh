// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/io/output_file.hh"
#include "surfmesh/pieces/mesh_piece.hh"

namespace surfmesh {

/// Write a piece of a mesh as .vtu, with its numbers behind the XML, raw, the least
/// significant byte first.
///
/// Points have `GlobalNodeIds`, their numbers in the whole mesh, which VTK knows as global ids.
/// Cells have `patch`, and `group`, the first group of the patch or -1, if there are groups. The
/// names are those of write_vtu. Further arrays of the grid as a whole tell which points are in
/// other pieces, too: of those in the piece `neighbour_pieces[k]`, `neighbour_vertices` holds the
/// points from `neighbour_offsets[k]` up to, without it, `neighbour_offsets[k + 1]`; the other
/// piece lists the same points in the same order. All integers but the ids are of 32 bits.
///
/// Throws   Io; Geometry for a position that is not finite
/// Cost     37 bytes a triangle in the file, 41 with groups, and 10 ns; no copy of the piece
void write_vtu_piece(const MeshPiece& piece, const MeshNames& names, OutputFile& file);

/// Write the .pvtu file of such pieces, by their paths from its folder. The names tell whether
/// there are groups.
/// Throws   Io
void write_pvtu(std::span<const std::string> pieces, const MeshNames& names, OutputFile& file);

}  // namespace surfmesh
