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

/// Puts the parts of tiles together to one piece of a mesh.
class PieceBuilder {
 public:
  /// Take memory for the vertices and faces of a number of parts, so that none is moved as they
  /// come.
  void reserve(const std::vector<const TilePart*>& parts);

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
