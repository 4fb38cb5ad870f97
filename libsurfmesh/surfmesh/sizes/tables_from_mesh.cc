// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/tables_from_mesh.hh"

#include <map>

#include "surfmesh/core/properties.hh"
#include "surfmesh/quality/corners_beyond.hh"

namespace surfmesh {

std::vector<TableSource> tables_from_mesh(const PolyMesh& mesh) {
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto patch_of = require(mesh, keys::face_patch);
  const auto metric_of = require(mesh, keys::corner_metric);
  const detail::CornersBeyond is_beyond(mesh);
  std::map<int, std::vector<TableNode>> nodes;
  for (const VertexHandle vh : mesh.vertices()) {
    // Corners of one patch follow each other around the vertex.
    int last_patch = -1;
    Uv last_uv;
    for (const HalfedgeHandle corner : mesh.vih_range(vh)) {
      if (mesh.is_boundary(corner) || is_beyond(corner)) continue;
      const int patch = mesh.property(patch_of, mesh.face_handle(corner));
      const Uv uv = mesh.property(uv_of, corner);
      if (patch == last_patch && uv == last_uv) continue;
      last_patch = patch;
      last_uv = uv;
      nodes[patch].push_back({uv, {}, mesh.property(metric_of, corner)});
    }
  }
  std::vector<TableSource> tables;
  for (auto& [patch, list] : nodes) tables.push_back({patch, std::move(list), std::nullopt});
  return tables;
}

}  // namespace surfmesh
