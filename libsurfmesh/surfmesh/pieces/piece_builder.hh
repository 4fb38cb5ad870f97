// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "surfmesh/pieces/mesh_piece.hh"
#include "surfmesh/pieces/tile_part.hh"

namespace surfmesh {

/// The vertices of a piece by their numbers.
struct PieceNumbers {
  /// Vertices that follow each other, the own ones of a tile.
  struct Run {
    std::size_t tile;
    int first_vertex;
    int count;
  };

  std::vector<int> shared_vertices;  ///< the vertices of the piece that other tiles may have, too
  std::vector<int> shared;           ///< their numbers, as NodeNumbers gives them
  std::vector<Run> runs;
};

/// The vertices and corners of faces that plain arrays of a piece can count, in 32 bits.
/// Throws   Limit if there are more
void check_counts_of_piece(std::size_t vertices, std::size_t corners);

/// Puts the parts of tiles together to one piece of a mesh.
class PieceBuilder {
 public:
  /// Make room for all parts at once, so that they need not be there twice.
  /// Throws   as check_counts_of_piece
  void reserve(std::size_t vertices, std::size_t faces, std::size_t corners);

  /// Add a part, with the number of its tile. Shared vertices may be there already.
  void add(std::size_t tile, TilePart part);

  /// The piece without ids of its vertices and neighbours.
  MeshPiece& piece() { return piece_; }

  const PieceNumbers& numbers() const { return numbers_; }

 private:
  int vertex_of(int number, const Vec3& point);

  MeshPiece piece_;
  PieceNumbers numbers_;
  std::unordered_map<int, int> vertices_;  ///< of the piece, by their shared numbers
};

}  // namespace surfmesh
