// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/number_piece.hh"

#include <cstddef>
#include <unordered_map>
#include <utility>

namespace surfmesh {
namespace {

void number_shared(const PieceNumbers& numbers, const SharedNumbers& shared, MeshPiece& mesh) {
  for (std::size_t i = 0; i < numbers.shared.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(numbers.shared_vertices[i]);
    const int number = numbers.shared[i];
    mesh.ids[vertex] = shared.id(number);
    if (shared.is_on_contour(number)) mesh.points[vertex] = shared.point(number);
  }
}

void number_own(const PieceNumbers& numbers, const std::vector<std::int64_t>& first_own,
                MeshPiece& mesh) {
  for (const PieceNumbers::Run& run : numbers.runs) {
    for (int k = 0; k < run.count; ++k) {
      mesh.ids[static_cast<std::size_t>(run.first_vertex + k)] = first_own[run.tile] + k;
    }
  }
}

/// The neighbours of a piece with its own vertices in place of their shared numbers.
std::vector<SharedWithPiece> neighbours_of(int piece, const SharedNumbers& shared,
                                           const PieceNumbers& numbers) {
  std::unordered_map<int, int> vertex_of;
  for (std::size_t i = 0; i < numbers.shared.size(); ++i) {
    vertex_of.emplace(numbers.shared[i], numbers.shared_vertices[i]);
  }
  std::vector<SharedWithPiece> neighbours = shared.neighbours(piece);
  for (SharedWithPiece& neighbour : neighbours) {
    for (int& vertex : neighbour.vertices) vertex = vertex_of.at(vertex);
  }
  return neighbours;
}

}  // namespace

std::vector<std::int64_t> first_own_ids(const std::vector<TileSummary>& tiles,
                                        const SharedNumbers& shared) {
  std::vector<std::int64_t> first = {shared.count()};
  for (const TileSummary& tile : tiles) first.push_back(first.back() + tile.own_vertices);
  return first;
}

MeshPiece numbered(PieceBuilder builder, int piece, const SharedNumbers& shared,
                   const std::vector<std::int64_t>& first_own) {
  MeshPiece mesh = std::move(builder.piece());
  const PieceNumbers& numbers = builder.numbers();
  mesh.ids.resize(mesh.points.size());
  number_shared(numbers, shared, mesh);
  number_own(numbers, first_own, mesh);
  mesh.neighbours = neighbours_of(piece, shared, numbers);
  return mesh;
}

}  // namespace surfmesh
