// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/split_face.hh"

namespace surfmesh {

void split_face(const PolyMesh& mesh, std::span<const int> face,
                std::vector<std::array<int, 3>>& triangles) {
  const auto distance = [&](std::size_t i, std::size_t j) {
    return (mesh.point(VertexHandle(face[i])) - mesh.point(VertexHandle(face[j]))).sqrnorm();
  };
  if (face.size() == 4 && distance(1, 3) < distance(0, 2)) {
    triangles.push_back({face[0], face[1], face[3]});
    triangles.push_back({face[1], face[2], face[3]});
    return;
  }
  for (std::size_t k = 2; k < face.size(); ++k) {
    triangles.push_back({face[0], face[k - 1], face[k]});
  }
}

std::size_t count_faces_above(const PolyMesh& mesh, std::size_t corners) {
  std::size_t count = 0;
  for (const FaceHandle fh : mesh.faces()) count += mesh.valence(fh) > corners ? 1 : 0;
  return count;
}

}  // namespace surfmesh
