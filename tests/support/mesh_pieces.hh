// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/pieces/mesh_piece.hh"

namespace surfmesh::testing {

/// Names of the patches of a strip in pieces.
inline const MeshNames kStripNames = {{"lower & left", "upper"}, {{"first", {1}}, {"all", {0, 1}}}};

/// A flat strip of `columns` x 2 squares, cut into triangles, as `count` pieces of equal width. The
/// ids go row by row through the whole strip; lower squares are of patch 0, upper ones of patch 1.
inline std::vector<MeshPiece> strip_in_pieces(int columns, int count) {
  std::vector<MeshPiece> pieces;
  const int width = columns / count;
  for (int p = 0; p < count; ++p) {
    MeshPiece& piece = pieces.emplace_back();
    for (int j = 0; j <= 2; ++j) {
      for (int i = p * width; i <= (p + 1) * width; ++i) {
        piece.points.emplace_back(i, j, 1.0 / (1 + i + j));
        piece.ids.push_back(j * (columns + 1) + i);
      }
    }
    const auto number = [width](int i, int j) { return j * (width + 1) + i; };
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < width; ++i) {
        piece.faces.add(std::vector{number(i, j), number(i + 1, j), number(i + 1, j + 1)});
        piece.faces.add(std::vector{number(i, j), number(i + 1, j + 1), number(i, j + 1)});
        piece.patches.insert(piece.patches.end(), 2, j);
      }
    }
    const auto share = [&](int other, int i) {
      piece.neighbours.push_back({other, {number(i, 0), number(i, 1), number(i, 2)}});
    };
    if (p > 0) share(p - 1, 0);
    if (p + 1 < count) share(p + 1, width);
  }
  return pieces;
}

}  // namespace surfmesh::testing
