// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/mesh_arrays.hh"

#include <utility>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/shared_vertices.hh"

namespace surfmesh {
namespace {

/// Call `visit` with each corner of each face, as the halfedge that leads to it, and its number in
/// `faces`. Threads share the faces.
template <class Visit>
void share_corners(const PolyMesh& mesh, const FaceList& faces, Visit visit) {
  share_ranges(faces.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) {
      std::size_t corner = faces.first_corner(f);
      for_each_corner(mesh, FaceHandle(static_cast<int>(f)),
                      [&](HalfedgeHandle heh) { visit(heh, corner++); });
    }
  });
}

/// The values of a property of the corners; none if the mesh does not have it.
template <class Value>
void add_values(const PolyMesh& mesh, const PropertyKey<HalfedgeHandle, Value>& key,
                const FaceList& faces, std::vector<Value>& values) {
  const auto handle = find(mesh, key);
  if (!handle.is_valid()) return;
  values.resize(faces.corner_count());
  share_corners(mesh, faces, [&](HalfedgeHandle heh, std::size_t corner) {
    values[corner] = mesh.property(handle, heh);
  });
}

void add_corners(const PolyMesh& mesh, MeshArrays& arrays) {
  if (const auto contour_of = find(mesh, keys::edge_contour); contour_of.is_valid()) {
    arrays.contours.resize(arrays.faces.corner_count());
    share_corners(mesh, arrays.faces, [&](HalfedgeHandle heh, std::size_t corner) {
      const EdgeHandle side = mesh.edge_handle(mesh.next_halfedge_handle(heh));
      arrays.contours[corner] = mesh.property(contour_of, side);
    });
  }
  add_values(mesh, keys::corner_uv, arrays.faces, arrays.uvs);
  add_values(mesh, keys::corner_metric, arrays.faces, arrays.metrics);
  add_values(mesh, keys::corner_beyond, arrays.faces, arrays.beyond);
  add_values(mesh, keys::corner_normal, arrays.faces, arrays.normals);
}

void add_faces(const PolyMesh& mesh, const SharedVertices& vertices, FaceList& faces) {
  std::vector<std::size_t> sizes(mesh.n_faces());
  share_ranges(sizes.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) {
      for_each_corner(mesh, FaceHandle(static_cast<int>(f)), [&](HalfedgeHandle) { ++sizes[f]; });
    }
  });
  faces.assign(sizes);
  share_corners(mesh, faces, [&](HalfedgeHandle heh, std::size_t corner) {
    faces.vertices()[corner] = vertices.number(mesh.to_vertex_handle(heh).idx());
  });
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
  add_faces(mesh, vertices, arrays.faces);
  const auto patch_of = find(mesh, keys::face_patch);
  if (patch_of.is_valid()) arrays.patches = mesh.property(patch_of).data_vector();
  if (parts == ArrayParts::FacesAndCorners) add_corners(mesh, arrays);
  return arrays;
}

}  // namespace surfmesh
