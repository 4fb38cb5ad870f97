// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/copy_values.hh"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/assemble/placed_piece.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {
namespace {

void copy_points(const Piece& piece, const CommonVertices& common, const ResultArrays& result) {
  const PolyMesh& mesh = *piece.source.mesh;
  for (const VertexHandle vh : mesh.vertices()) {
    const int vertex = piece.vertices(vh);
    if (common.is_on_contour(vertex) || !common.is_written_by(piece.number, vertex)) continue;
    result.point[static_cast<std::size_t>(vertex)] = mesh.point(vh);
  }
}

void copy_corners(const Piece& piece, const ResultArrays& result) {
  const PolyMesh& mesh = *piece.source.mesh;
  const auto& uv = mesh.property(require(mesh, keys::vertex_uv)).data_vector();
  const auto& metric = mesh.property(require(mesh, keys::vertex_metric)).data_vector();
  const PlacedPiece placed(piece);
  placed.for_each_side([&](HalfedgeHandle heh) {
    const std::size_t to = index(placed.place(heh)), tip = index(placed.tip(heh));
    result.uv[to] = uv[tip];
    result.metric[to] = metric[tip];
  });
  placed.for_each_loose_face([&](const LooseFace& face, std::span<const HalfedgeHandle> sides) {
    for (std::size_t k = 0; k < face.count; ++k) {
      const CornerValue& tip = face.corners[k + 1 == face.count ? 0 : k + 1].value;
      result.uv[index(sides[k])] = tip.uv;
      result.metric[index(sides[k])] = tip.metric;
    }
  });
}

}  // namespace

void copy_values(const Piece& piece, const CommonVertices& common, const ResultArrays& result) {
  copy_points(piece, common, result);
  copy_corners(piece, result);
  const auto first_face = result.patch.begin() + piece.first_face;
  std::fill(first_face, first_face + piece.face_count, piece.source.boundary.patch);
}

void release_values(PolyMesh& mesh) {
  detach(mesh, keys::vertex_uv);
  detach(mesh, keys::vertex_metric);
  detach(mesh, keys::edge_contour);
  detach(mesh, keys::edge_constrained);
  mesh.property(mesh.points_property_handle()).data_vector() = std::vector<PolyMesh::Point>();
}

}  // namespace surfmesh::detail
