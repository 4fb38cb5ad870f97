// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch_mesh/triangulated_patch.hh"

#include <Eigen/Geometry>

namespace surfmesh {

void evaluate_vertices(TriangulatedPatch& patch) {
  patch.points.reserve(patch.delaunay->n_vertices());
  patch.normals.reserve(patch.delaunay->n_vertices());
  for (std::size_t v = patch.points.size(); v < patch.delaunay->n_vertices(); ++v) {
    const Uv uv = patch.delaunay->uv(VertexHandle(static_cast<int>(v)));
    const Jet jet = patch.surface->evaluate(uv, Order::First);
    patch.points.push_back(jet.point);
    patch.normals.push_back(jet.du.cross(jet.dv));
  }
}

bool split_chord(TriangulatedPatch& patch, EdgeHandle eh, double share) {
  DelaunayMesh& delaunay = *patch.delaunay;
  const PolyMesh& mesh = delaunay.mesh();
  const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
  const Uv place = lerp(delaunay.uv(mesh.from_vertex_handle(heh)),
                        delaunay.uv(mesh.to_vertex_handle(heh)), share);
  for (const HalfedgeHandle side : {heh, mesh.opposite_halfedge_handle(heh)}) {
    const Uv origin = delaunay.uv(mesh.from_vertex_handle(side));
    const Uv tip = delaunay.uv(mesh.to_vertex_handle(side));
    const Uv apex = delaunay.uv(mesh.to_vertex_handle(mesh.next_halfedge_handle(side)));
    if (orient2d(place, tip, apex) <= 0 || orient2d(place, apex, origin) <= 0) return false;
  }
  QueryHint hint;
  const VertexHandle vh = delaunay.split_edge(eh, place);
  delaunay.metric(vh) = patch.field->at(place, hint);
  return true;
}

}  // namespace surfmesh
