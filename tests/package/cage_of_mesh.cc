// SPDX-License-Identifier: BSD-3-Clause
// Make a cage of an OpenMesh mesh with float points, its creases from an edge property, and mesh
// its limit surface: a cube whose upper face is sharp.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <cstdio>
#include <exception>
#include <vector>

#include <surfmesh/surfmesh.hh>

using Cube = OpenMesh::PolyMesh_ArrayKernelT<>;  // its points are three floats

Cube make_cube() {
  Cube cube;
  std::vector<OpenMesh::VertexHandle> v;
  for (int i = 0; i < 8; ++i) {
    v.push_back(cube.add_vertex({i & 1 ? 1.f : -1.f, i & 2 ? 1.f : -1.f, i & 4 ? 1.f : -1.f}));
  }
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) cube.add_face(v[f[0]], v[f[1]], v[f[2]], v[f[3]]);
  return cube;
}

int main() try {
  Cube cube = make_cube();
  OpenMesh::EProp<float> sharpness(cube, "sharpness");
  for (const auto edge : cube.edges()) {
    sharpness[edge] = cube.calc_edge_midpoint(edge)[2] > 0.5f ? 10.f : 0.f;  // 10 is infinite
  }
  const auto cage = surfmesh::cage_from_mesh(cube, {.creases = "sharpness"});
  const auto [mesh, names, report] = surfmesh::mesh_model(surfmesh::model_from_cage(cage));
  std::printf("%zu patches, %zu triangles\n", report.mesh.patches, report.mesh.triangles);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
