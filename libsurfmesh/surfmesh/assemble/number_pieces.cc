// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/number_pieces.hh"

#include <fmt/format.h>

#include <limits>
#include <span>
#include <utility>

#include "surfmesh/core/error.hh"

namespace surfmesh::detail {
namespace {

void check_counts_of(const std::vector<PatchMesh>& patches, const NodeNumbers& numbers) {
  auto vertices = static_cast<std::size_t>(numbers.count());
  std::size_t edges = 0;
  for (const PatchMesh& patch : patches) {
    vertices += patch.mesh->n_vertices();
    edges += patch.mesh->n_edges();
  }
  check_counts_of_mesh(vertices, edges);
}

}  // namespace

void check_counts_of_mesh(std::size_t vertices, std::size_t edges) {
  constexpr std::size_t most_vertices = std::numeric_limits<int>::max();
  constexpr std::size_t most_edges = most_vertices / 2;
  if (vertices <= most_vertices && edges <= most_edges) return;
  throw Error(ErrorCode::Limit,
              fmt::format("a mesh of {} vertices and {} edges is too large for one half-edge mesh, "
                          "which can have {} and {}; pieces of it are smaller (--pieces; "
                          "mesh_pieces)",
                          vertices, edges, most_vertices, most_edges));
}

std::vector<Piece> take_pieces(std::vector<PatchMesh> patches, const PatchOrientation& orientation,
                               const NodeNumbers& numbers) {
  check_counts_of(patches, numbers);
  std::vector<Piece> pieces;
  pieces.reserve(patches.size());
  int first_own = numbers.count();
  for (PatchMesh& patch : patches) {
    const int number = static_cast<int>(pieces.size());
    const bool is_turned = orientation.is_turned[patch.patch()] != 0;
    const PieceVertices vertices(patch.boundary, patch.mesh->n_vertices(), first_own);
    first_own = vertices.end_of_own();
    pieces.push_back({number, std::move(patch), is_turned, vertices});
  }
  return pieces;
}

ElementCounts number_elements(std::vector<Piece>& pieces) {
  ElementCounts counts;
  for (Piece& piece : pieces) {
    piece.first_edge = static_cast<int>(counts.edges);
    piece.first_face = static_cast<int>(counts.faces);
    counts.edges += static_cast<std::size_t>(piece.copied_edge_count());
    counts.faces += static_cast<std::size_t>(piece.face_count);
  }
  if (!pieces.empty()) {
    counts.vertices = static_cast<std::size_t>(pieces.back().vertices.end_of_own());
  }
  return counts;
}

std::vector<BorderSide> sides_of(const std::vector<Piece>& pieces) {
  std::vector<BorderSide> sides;
  for (const Piece& piece : pieces) {
    sides.insert(sides.end(), piece.sides.begin(), piece.sides.end());
  }
  return sides;
}

std::vector<HalfedgeHandle> give_halfedges(const GluedSides& glued, std::size_t first_edge,
                                           std::vector<Piece>& pieces) {
  std::vector<HalfedgeHandle> halfedges(glued.side_count);
  int next = 2 * static_cast<int>(first_edge);
  for (const auto& [first, second] : glued.edges) {
    halfedges[static_cast<std::size_t>(first)] = HalfedgeHandle(next);
    if (second >= 0) halfedges[static_cast<std::size_t>(second)] = HalfedgeHandle(next + 1);
    next += 2;
  }
  std::span<const HalfedgeHandle> rest(halfedges);
  for (Piece& piece : pieces) {
    piece.halfedges = rest.first(piece.sides.size());
    rest = rest.subspan(piece.sides.size());
  }
  return halfedges;
}

}  // namespace surfmesh::detail
