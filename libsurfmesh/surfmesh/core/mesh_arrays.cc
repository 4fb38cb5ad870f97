// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/mesh_arrays.hh"

#include <utility>

#include "surfmesh/core/properties.hh"
#include "surfmesh/core/shared_vertices.hh"

namespace surfmesh {
namespace {

/// The values of the corners of all faces, by `value` of the halfedge that leads to each.
template <class Value, class ValueOf>
std::vector<Value> corner_values(const PolyMesh& mesh, std::size_t count, ValueOf value) {
  std::vector<Value> values;
  values.reserve(count);
  for (const FaceHandle fh : mesh.faces()) {
    for_each_corner(mesh, fh, [&](HalfedgeHandle heh) { values.push_back(value(heh)); });
  }
  return values;
}

/// The values of a property of the corners; none if the mesh does not have it.
template <class Value>
void add_values(const PolyMesh& mesh, const PropertyKey<HalfedgeHandle, Value>& key,
                std::size_t count, std::vector<Value>& values) {
  const auto handle = find(mesh, key);
  if (!handle.is_valid()) return;
  values = corner_values<Value>(mesh, count,
                                [&](HalfedgeHandle heh) { return mesh.property(handle, heh); });
}

void add_corners(const PolyMesh& mesh, MeshArrays& arrays) {
  const std::size_t count = arrays.faces.corner_count();
  if (const auto contour_of = find(mesh, keys::edge_contour); contour_of.is_valid()) {
    arrays.contours = corner_values<int>(mesh, count, [&](HalfedgeHandle heh) {
      return mesh.property(contour_of, mesh.edge_handle(mesh.next_halfedge_handle(heh)));
    });
  }
  add_values(mesh, keys::corner_uv, count, arrays.uvs);
  add_values(mesh, keys::corner_metric, count, arrays.metrics);
  add_values(mesh, keys::corner_beyond, count, arrays.beyond);
  add_values(mesh, keys::corner_normal, count, arrays.normals);
}

}  // namespace

MeshArrays mesh_arrays(const PolyMesh& mesh, MeshNames names, ArrayParts parts) {
  MeshArrays arrays;
  arrays.names = std::move(names);
  const SharedVertices vertices(mesh);
  arrays.points.reserve(vertices.count());
  for (const VertexHandle vh : mesh.vertices()) {
    if (vertices.is_first(vh)) arrays.points.push_back(to_eigen(mesh.point(vh)));
  }
  arrays.faces.reserve(mesh.n_faces(), mesh.n_halfedges());
  std::vector<int> face;
  for (const FaceHandle fh : mesh.faces()) {
    face.clear();
    for_each_vertex_of(mesh, fh, [&](int vertex) { face.push_back(vertices.number(vertex)); });
    arrays.faces.add(face);
  }
  const auto patch_of = find(mesh, keys::face_patch);
  if (patch_of.is_valid()) arrays.patches = mesh.property(patch_of).data_vector();
  if (parts == ArrayParts::FacesAndCorners) add_corners(mesh, arrays);
  return arrays;
}

}  // namespace surfmesh
