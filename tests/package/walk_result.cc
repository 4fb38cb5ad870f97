// SPDX-License-Identifier: BSD-3-Clause
// Mesh a cage and walk the result: area of each patch, and distance of corners from the surface.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <vector>

#include <surfmesh/surfmesh.hh>

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: walk_result CAGE\n"), 2;
  const surfmesh::Model model = surfmesh::model_from_cage(surfmesh::read_cage(argv[1]));
  surfmesh::PipelineOptions options;
  options.sizing.curvature = 0.2;                      // elements of 0.2 × radius of curvature,
  options.sizing.hmax = surfmesh::Length::percent(5);  // at most 5 % of the model's diagonal
  const auto [mesh, names, report] = surfmesh::mesh_model(model, {}, options);

  const auto patch_of = require(mesh, surfmesh::keys::face_patch);
  const auto uv_of = require(mesh, surfmesh::keys::corner_uv);
  const auto beyond = find(mesh, surfmesh::keys::corner_beyond);
  std::vector<double> areas(model.patches.size());
  double distance = 0;
  for (const auto face : mesh.faces()) {
    const auto patch = static_cast<std::size_t>(mesh.property(patch_of, face));
    areas[patch] += mesh.calc_sector_area(face.halfedge());
    for (const auto corner : face.halfedges()) {  // a corner is the tip of its halfedge
      // Of a face that lies on several patches some corners are beyond its own.
      if (beyond.is_valid() && mesh.property(beyond, corner) != 0) continue;
      const auto jet = model.patches[patch].surface->evaluate(mesh.property(uv_of, corner),
                                                              surfmesh::Order::Position);
      distance =
          std::max(distance, (jet.point - surfmesh::to_eigen(mesh.point(corner.to()))).norm());
    }
  }
  for (std::size_t i = 0; i < areas.size(); ++i) std::printf("patch %zu: area %.4f\n", i, areas[i]);
  std::printf("%zu triangles, greatest distance %.1e\n", report.mesh.triangles, distance);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
