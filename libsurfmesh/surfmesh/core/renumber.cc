// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/renumber.hh"

#include <algorithm>
#include <limits>

namespace surfmesh {
namespace {

/// The connectivity of a halfedge.
struct Links {
  VertexHandle tip;
  HalfedgeHandle next;
  FaceHandle face;  ///< invalid at an open halfedge
};

template <class Handle>
Handle renumbered(Handle handle, const std::vector<int>& new_number) {
  return handle.is_valid() ? Handle(new_number[index(handle)]) : handle;
}

HalfedgeHandle renumbered_halfedge(HalfedgeHandle heh, const std::vector<int>& new_edge) {
  if (!heh.is_valid()) return heh;  // of a vertex without edges
  return HalfedgeHandle(2 * new_edge[static_cast<std::size_t>(heh.idx() / 2)] + heh.idx() % 2);
}

/// Turn a key of each element into its number in the order of the keys, where those of equal keys
/// keep their order: a sort by counting.
void number_by(std::vector<int>& keys, std::size_t key_count) {
  std::vector<int> next(key_count + 1, 0);
  for (const int key : keys) ++next[static_cast<std::size_t>(key) + 1];
  for (std::size_t k = 1; k < next.size(); ++k) next[k] += next[k - 1];
  for (int& key : keys) key = next[static_cast<std::size_t>(key)]++;
}

}  // namespace

Numbering number_along(const PolyMesh& mesh, const std::vector<int>& vertex_order) {
  Numbering numbering;
  numbering.vertex.resize(mesh.n_vertices());
  for (std::size_t i = 0; i < vertex_order.size(); ++i) {
    numbering.vertex[static_cast<std::size_t>(vertex_order[i])] = static_cast<int>(i);
  }
  // Edges lie in memory one after the other, so that faces take their least vertex from them, too.
  numbering.edge.resize(mesh.n_edges());
  numbering.face.assign(mesh.n_faces(), std::numeric_limits<int>::max());
  for (std::size_t e = 0; e < numbering.edge.size(); ++e) {
    const HalfedgeHandle one(static_cast<int>(2 * e)), other(static_cast<int>(2 * e + 1));
    const int key = std::min(numbering.vertex[index(mesh.to_vertex_handle(one))],
                             numbering.vertex[index(mesh.to_vertex_handle(other))]);
    numbering.edge[e] = key;
    for (const HalfedgeHandle heh : {one, other}) {
      const FaceHandle fh = mesh.face_handle(heh);
      if (!fh.is_valid()) continue;
      int& face_key = numbering.face[index(fh)];
      face_key = std::min(face_key, key);
    }
  }
  number_by(numbering.edge, mesh.n_vertices());
  number_by(numbering.face, mesh.n_vertices());
  return numbering;
}

void renumber(PolyMesh& mesh, const Numbering& numbering) {
  std::vector<Links> links(mesh.n_halfedges());
  for (std::size_t h = 0; h < links.size(); ++h) {
    const HalfedgeHandle heh(static_cast<int>(h));
    const HalfedgeHandle place = renumbered_halfedge(heh, numbering.edge);
    links[index(place)] = {renumbered(mesh.to_vertex_handle(heh), numbering.vertex),
                           renumbered_halfedge(mesh.next_halfedge_handle(heh), numbering.edge),
                           renumbered(mesh.face_handle(heh), numbering.face)};
  }
  std::vector<HalfedgeHandle> of_vertex(mesh.n_vertices()), of_face(mesh.n_faces());
  for (std::size_t v = 0; v < of_vertex.size(); ++v) {
    of_vertex[static_cast<std::size_t>(numbering.vertex[v])] = renumbered_halfedge(
        mesh.halfedge_handle(VertexHandle(static_cast<int>(v))), numbering.edge);
  }
  for (std::size_t f = 0; f < of_face.size(); ++f) {
    of_face[static_cast<std::size_t>(numbering.face[f])] =
        renumbered_halfedge(mesh.halfedge_handle(FaceHandle(static_cast<int>(f))), numbering.edge);
  }
  for (std::size_t h = 0; h < links.size(); ++h) {
    const HalfedgeHandle heh(static_cast<int>(h));
    mesh.set_vertex_handle(heh, links[h].tip);
    mesh.set_next_halfedge_handle(heh, links[h].next);
    mesh.set_face_handle(heh, links[h].face);
  }
  for (std::size_t v = 0; v < of_vertex.size(); ++v) {
    mesh.set_halfedge_handle(VertexHandle(static_cast<int>(v)), of_vertex[v]);
  }
  for (std::size_t f = 0; f < of_face.size(); ++f) {
    mesh.set_halfedge_handle(FaceHandle(static_cast<int>(f)), of_face[f]);
  }
}

}  // namespace surfmesh
