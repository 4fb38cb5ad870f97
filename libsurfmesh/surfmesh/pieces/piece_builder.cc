// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/piece_builder.hh"

#include <fmt/format.h>

#include <cstddef>
#include <limits>
#include <vector>

#include "surfmesh/core/error.hh"

namespace surfmesh {

void check_counts_of_piece(std::size_t vertices, std::size_t corners) {
  constexpr std::size_t most = std::numeric_limits<int>::max();
  if (vertices <= most && corners <= most) return;
  throw Error(ErrorCode::Limit,
              fmt::format("a piece of {} vertices and {} corners of faces is too large, for it can "
                          "have {} of each; more pieces are smaller (--piece-count; "
                          "PiecesOptions::pieces)",
                          vertices, corners, most));
}

void PieceBuilder::reserve(std::size_t vertices, std::size_t faces, std::size_t corners) {
  check_counts_of_piece(vertices, corners);
  piece_.points.reserve(vertices);
  piece_.faces.reserve(faces, corners);
  piece_.patches.reserve(faces);
}

void PieceBuilder::add(std::size_t tile, TilePart part) {
  std::vector<int> shared;
  for (std::size_t i = 0; i < part.shared.size(); ++i) {
    shared.push_back(vertex_of(part.shared[i], part.points[i]));
  }
  const auto shared_count = static_cast<int>(part.shared.size());
  const auto first_own = static_cast<int>(piece_.points.size());
  numbers_.runs.push_back({tile, first_own, static_cast<int>(part.own_count())});
  piece_.points.insert(piece_.points.end(), part.points.begin() + shared_count, part.points.end());
  std::vector<int> corners;
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    corners.clear();
    for (const int v : part.faces[f]) {
      corners.push_back(v < shared_count ? shared[static_cast<std::size_t>(v)]
                                         : first_own + v - shared_count);
    }
    piece_.faces.add(corners);
  }
  piece_.patches.insert(piece_.patches.end(), part.faces.size(), part.patch);
}

int PieceBuilder::vertex_of(int number, const Vec3& point) {
  const auto [found, is_new] =
      vertices_.try_emplace(number, static_cast<int>(piece_.points.size()));
  if (is_new) {
    numbers_.shared.push_back(number);
    numbers_.shared_vertices.push_back(found->second);
    piece_.points.push_back(point);
  }
  return found->second;
}

}  // namespace surfmesh
