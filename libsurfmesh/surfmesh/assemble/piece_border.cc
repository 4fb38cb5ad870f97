// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/piece_border.hh"

#include <algorithm>
#include <utility>

#include "surfmesh/assemble/loose_faces.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {
namespace {

template <class Handle>
void sort_once(std::vector<Handle>& handles) {
  std::sort(handles.begin(), handles.end());
  handles.erase(std::unique(handles.begin(), handles.end()), handles.end());
}

/// The nodes of the loops.
template <class Visit>
void for_each_node(const Piece& piece, Visit visit) {
  for (std::size_t v = 0; v < piece.vertices.border_count(); ++v) {
    visit(VertexHandle(static_cast<int>(v)));
  }
}

/// The faces with a side between two nodes that are one vertex of the result, ascending.
std::vector<FaceHandle> collapsed_faces(const Piece& piece) {
  const PolyMesh& mesh = *piece.source.mesh;
  std::vector<FaceHandle> faces;
  for_each_node(piece, [&](VertexHandle node) {
    for (const HalfedgeHandle heh : mesh.voh_range(node)) {
      if (piece.vertices(mesh.to_vertex_handle(heh)) != piece.vertices(node)) continue;
      if (!mesh.is_boundary(heh)) faces.push_back(mesh.face_handle(heh));
    }
  });
  sort_once(faces);
  return faces;
}

/// The edges at the border of the mesh and at faces that are not copied, ascending.
std::vector<EdgeHandle> edges_at_border(const Piece& piece,
                                        const std::vector<FaceHandle>& collapsed) {
  const PolyMesh& mesh = *piece.source.mesh;
  std::vector<EdgeHandle> edges;
  edges.reserve(piece.vertices.border_count());
  for_each_node(piece, [&](VertexHandle node) {
    const HalfedgeHandle heh = mesh.halfedge_handle(node);  // the open one
    if (mesh.is_boundary(heh)) edges.push_back(mesh.edge_handle(heh));
  });
  for (const FaceHandle fh : collapsed) {
    for (const EdgeHandle eh : mesh.fe_range(fh)) edges.push_back(eh);
  }
  sort_once(edges);
  return edges;
}

/// The side of an edge that belongs to a face which is copied.
HalfedgeHandle copied_side(const PolyMesh& mesh, EdgeHandle eh,
                           const std::vector<FaceHandle>& collapsed) {
  for (const unsigned k : {0u, 1u}) {
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, k);
    const bool is_copied =
        !mesh.is_boundary(heh) &&
        !std::binary_search(collapsed.begin(), collapsed.end(), mesh.face_handle(heh));
    if (is_copied) return heh;
  }
  return HalfedgeHandle();
}

void add_sides_of_edges(Piece& piece) {
  const PolyMesh& mesh = *piece.source.mesh;
  const auto contour_of = require(mesh, keys::edge_contour);
  for (const BorderEdge& edge : piece.border_edges) {
    if (!edge.side.is_valid()) continue;
    int from = piece.vertices(mesh.from_vertex_handle(edge.side));
    int to = piece.vertices(mesh.to_vertex_handle(edge.side));
    if (piece.is_turned) std::swap(from, to);
    piece.sides.push_back(
        {from, to, mesh.property(contour_of, edge.edge), piece.source.boundary.patch});
  }
}

void add_sides_of_loose_faces(Piece& piece) {
  for (const LooseFace& face : piece.loose_faces) {
    for (std::size_t k = 0; k < face.count; ++k) {
      const LooseCorner& corner = face.corners[k];
      const LooseCorner& next = face.corners[k + 1 == face.count ? 0 : k + 1];
      piece.sides.push_back(
          {corner.vertex, next.vertex, corner.contour, piece.source.boundary.patch});
    }
  }
}

}  // namespace

void survey_border(Piece& piece) {
  const std::vector<FaceHandle> collapsed = collapsed_faces(piece);
  for (const EdgeHandle eh : edges_at_border(piece, collapsed)) {
    piece.border_edges.push_back({eh, copied_side(*piece.source.mesh, eh, collapsed)});
  }
  make_loose_faces(piece, collapsed);
  add_sides_of_edges(piece);
  add_sides_of_loose_faces(piece);
}

}  // namespace surfmesh::detail
