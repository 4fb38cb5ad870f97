// SPDX-License-Identifier: BSD-3-Clause
// Copy the result into a mesh type of the application: float points, normals and texture
// coordinates.
#include <cstdio>
#include <exception>

#include <surfmesh/surfmesh.hh>

struct OwnTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D);
};
using OwnMesh = OpenMesh::TriMesh_ArrayKernelT<OwnTraits>;

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: copy_to_own_mesh CAGE\n"), 2;
  const auto model = surfmesh::model_from_cage(surfmesh::read_cage(argv[1]));
  OwnMesh mesh;
  surfmesh::copy_result(surfmesh::mesh_model(model).mesh, mesh);

  const auto contour_of = require(mesh, surfmesh::keys::edge_contour);  // others: see properties.hh
  float length = 0;
  for (const auto edge : mesh.edges()) {
    if (mesh.property(contour_of, edge) >= 0) length += mesh.calc_edge_length(edge);
  }
  const auto corner = mesh.halfedge_handle(mesh.face_handle(0));
  const auto vertex = mesh.to_vertex_handle(corner);
  std::printf("%zu faces, %.3f of contours\n", mesh.n_faces(), length);
  std::printf("a vertex with normal (%.2f, %.2f, %.2f) and texture at (%.2f, %.2f)\n",
              mesh.normal(vertex)[0], mesh.normal(vertex)[1], mesh.normal(vertex)[2],
              mesh.texcoord2D(corner)[0], mesh.texcoord2D(corner)[1]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
