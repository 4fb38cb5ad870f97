// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/close_slits.hh"

#include <algorithm>

#include "surfmesh/core/topology.hh"

namespace surfmesh {
namespace {

/// The halfedge of an open edge that has no face.
HalfedgeHandle open_halfedge(const PolyMesh& mesh, EdgeHandle eh) {
  const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
  return mesh.is_boundary(heh) ? heh : mesh.opposite_halfedge_handle(heh);
}

/// The other edge of the slit that an open edge is on; invalid if the hole there is larger.
EdgeHandle across_slit(const PolyMesh& mesh, EdgeHandle eh) {
  const HalfedgeHandle heh = open_halfedge(mesh, eh), next = mesh.next_halfedge_handle(heh);
  return mesh.next_halfedge_handle(next) == heh ? mesh.edge_handle(next) : EdgeHandle();
}

/// Give the face of `freed` to the open halfedge of `kept`.
void glue(PolyMesh& mesh, EdgeHandle kept, EdgeHandle freed) {
  const HalfedgeHandle heir = open_halfedge(mesh, kept);
  const HalfedgeHandle side = mesh.opposite_halfedge_handle(open_halfedge(mesh, freed));
  const FaceHandle fh = mesh.face_handle(side);
  mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(side), heir);
  mesh.set_next_halfedge_handle(heir, mesh.next_halfedge_handle(side));
  mesh.set_face_handle(heir, fh);
  if (mesh.halfedge_handle(fh) == side) mesh.set_halfedge_handle(fh, heir);
  for (const HalfedgeHandle heh : {heir, mesh.opposite_halfedge_handle(heir)}) {
    mesh.set_halfedge_handle(mesh.from_vertex_handle(heh), heh);
  }
}

}  // namespace

std::size_t close_slits(PolyMesh& mesh, const std::vector<EdgeHandle>& open_edges) {
  std::size_t count = mesh.n_edges();
  // Backwards, so that no edge that is still to come gets another number.
  for (auto it = open_edges.rbegin(); it != open_edges.rend(); ++it) {
    const EdgeHandle other = across_slit(mesh, *it);
    const bool is_slit =
        other < *it && std::binary_search(open_edges.begin(), open_edges.end(), other);
    if (!is_slit) continue;
    glue(mesh, other, *it);
    const EdgeHandle last(static_cast<int>(--count));
    if (last != *it) detail::renumber_element(mesh, last, *it);
  }
  const std::size_t closed = mesh.n_edges() - count;
  mesh.resize(mesh.n_vertices(), count, mesh.n_faces());
  return closed;
}

}  // namespace surfmesh
