// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/file_writer.hh"

#include <fmt/format.h>

#include <cmath>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/shared_vertices.hh"

namespace surfmesh {

void check_finite(const OpenMesh::Vec3d& point, VertexHandle vh) {
  if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2])) return;
  throw Error(ErrorCode::Geometry, fmt::format("the position of vertex {} is ({}, {}, {})",
                                               vh.idx(), point[0], point[1], point[2]));
}

void write_points(const PolyMesh& mesh, std::string_view first_word, FileWriter& writer) {
  const SharedVertices vertices(mesh);
  for (const VertexHandle vh : mesh.vertices()) {
    if (!vertices.is_first(vh)) continue;
    const OpenMesh::Vec3d& point = mesh.point(vh);
    check_finite(point, vh);
    if (first_word.empty()) {
      writer.number('\n', point[0]);
    } else {
      writer.text("\n");
      writer.text(first_word);
      writer.number(' ', point[0]);
    }
    writer.number(' ', point[1]);
    writer.number(' ', point[2]);
  }
}

}  // namespace surfmesh
