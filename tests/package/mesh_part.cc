// SPDX-License-Identifier: BSD-3-Clause
// Mesh a part of a CAD program: STEP, IGES or BREP.
#include <cstdio>
#include <exception>

#include <surfmesh/surfmesh.hh>
#include <surfmesh_cad/read_cad.hh>

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: mesh_part PART\n"), 2;
  const surfmesh::Model model = surfmesh::read_cad(argv[1]);
  for (const surfmesh::Notice& notice : model.notices) std::printf("%s\n", notice.text.c_str());
  const surfmesh::MeshResult result = surfmesh::mesh_model(model);
  std::printf("%zu patches, %zu triangles, Euler number %ld\n", model.patches.size(),
              result.report.mesh.triangles, result.report.mesh.euler);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
