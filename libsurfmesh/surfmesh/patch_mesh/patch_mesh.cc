// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch_mesh/patch_mesh.hh"

#include <utility>

#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

/// The edge from a node of a loop to the next one. A vertex at the boundary has its open halfedge,
/// which leads to the node before.
EdgeHandle segment_after(const PolyMesh& mesh, VertexHandle node) {
  return mesh.edge_handle(mesh.prev_halfedge_handle(mesh.halfedge_handle(node)));
}

void write_contours(const PatchBoundary& boundary, PolyMesh& mesh) {
  detach(mesh, keys::edge_contour);  // of a mesh that was finished before
  const auto contour_of = attach(mesh, keys::edge_contour, -1);
  int node = 0;
  for (const BoundaryLoop& loop : boundary.loops) {
    for (const BoundaryNode& at : loop) {
      mesh.property(contour_of, segment_after(mesh, VertexHandle(node++))) = at.contour;
    }
  }
}

}  // namespace

PatchMesh finish_patch(TriangulatedPatch patch) {
  evaluate_vertices(patch);
  PatchMesh result{std::move(patch.boundary), patch.delaunay->release()};
  PolyMesh& mesh = *result.mesh;
  for (const VertexHandle vh : mesh.vertices()) {
    mesh.set_point(vh, to_openmesh(patch.points[index(vh)]));
  }
  write_contours(result.boundary, mesh);
  return result;
}

PatchMesh finish_patch(PatchBoundary boundary, std::unique_ptr<PolyMesh> mesh,
                       const Surface& surface) {
  const auto uv = require(*mesh, keys::vertex_uv);
  for (const VertexHandle vh : mesh->vertices()) {
    mesh->set_point(vh,
                    to_openmesh(surface.evaluate(mesh->property(uv, vh), Order::Position).point));
  }
  write_contours(boundary, *mesh);
  return {std::move(boundary), std::move(mesh)};
}

TriangulatedPatch reopen_patch(PatchMesh patch, const Surface& surface, const MetricField& field) {
  TriangulatedPatch result;
  result.boundary = std::move(patch.boundary);
  result.delaunay = std::make_unique<DelaunayMesh>(std::move(patch.mesh));
  result.surface = &surface;
  result.field = &field;
  evaluate_vertices(result);
  return result;
}

std::vector<int> boundary_vertices(const PatchBoundary& boundary) {
  std::vector<int> vertices;
  for (const BoundaryLoop& loop : boundary.loops) {
    for (const BoundaryNode& node : loop) vertices.push_back(node.vertex);
  }
  return vertices;
}

}  // namespace surfmesh
