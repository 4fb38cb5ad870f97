// SPDX-License-Identifier: BSD-3-Clause
// Build a model by hand, as a reader of CAD files would: a floor and a wall that share an edge.
#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include <surfmesh/geometry/plane_surface.hh>
#include <surfmesh/surfmesh.hh>

using surfmesh::Uv, surfmesh::Vec3;

/// A contour that one patch has on its left, straight in (u,v).
surfmesh::LoopEntry add_edge(surfmesh::Model& model, int patch, int start, int end, Uv a, Uv b) {
  surfmesh::Contour& contour = model.contours.emplace_back();
  contour.name = "edge" + std::to_string(model.contours.size());
  contour.start = start;
  contour.end = end;
  contour.uses.push_back({patch, std::make_shared<surfmesh::SegmentCurve>(a, b)});
  return {static_cast<int>(model.contours.size()) - 1, 0};
}

int main() try {
  surfmesh::Model model;
  model.vertices.resize(6);  // finish() takes positions from the contours
  const auto plane = [](const Vec3& up) {
    return std::make_shared<surfmesh::PlaneSurface>(Vec3::Zero(), Vec3::UnitX(), up,
                                                    surfmesh::Domain{0, 1, 0, 1});
  };
  model.patches.resize(2);
  model.patches[0].name = "floor";
  model.patches[0].surface = plane(Vec3::UnitY());
  model.patches[1].name = "wall";
  model.patches[1].surface = plane(Vec3::UnitZ());
  const auto shared = add_edge(model, 0, 0, 1, {0, 0}, {1, 0});  // v = 0 of both patches
  model.contours[0].uses.push_back({1, model.contours[0].uses[0].curve});
  for (const int p : {0, 1}) {
    const int c = 2 + 2 * p, d = 3 + 2 * p;  // the corners (1,1) and (0,1)
    model.patch(p).loops = {{{shared.contour, p},
                             add_edge(model, p, 1, c, {1, 0}, {1, 1}),
                             add_edge(model, p, c, d, {1, 1}, {0, 1}),
                             add_edge(model, p, d, 0, {0, 1}, {0, 0})}};
  }
  finish(model);
  const auto result = surfmesh::mesh_model(model);
  std::printf("%zu triangles, Euler number %ld\n", result.report.mesh.triangles,
              result.report.mesh.euler);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
