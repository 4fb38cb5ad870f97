// SPDX-License-Identifier: BSD-3-Clause
// Build a model by hand: a floor and a wall behind it that share an edge.
#include <surfmesh/surfmesh.hh>

#include <cstdio>
#include <memory>

using namespace surfmesh;

/// A straight contour with one patch on its left.
LoopEntry add_edge(Model& model, int patch, int start, int end, Uv a, Uv b) {
  Contour& contour = model.contours.emplace_back();
  contour.start = start;
  contour.end = end;
  contour.uses.push_back({patch, std::make_shared<SegmentCurve>(a, b)});
  return {static_cast<int>(model.contours.size()) - 1, 0};
}

int main() {
  Model model;
  model.vertices.resize(6);  // finish() takes positions from the contours
  model.patches.resize(2);
  const auto floor = [](auto u, auto v) { return std::array{u, -v, 0.0 * u}; };
  const auto wall = [](auto u, auto v) { return std::array{u, 0.0 * u, v}; };
  model.patches[0].surface = make_callable_surface({0, 1, 0, 1}, floor);
  model.patches[1].surface = make_callable_surface({0, 1, 0, 1}, wall);
  const int shared = add_edge(model, 0, 0, 1, {0, 0}, {1, 0}).contour;  // v = 0 of both patches
  model.contours[0].uses.push_back({1, model.contours[0].uses[0].curve});
  for (const int p : {0, 1}) {
    const int c = 2 + 2 * p, d = 3 + 2 * p;  // the corners (1,1) and (0,1)
    model.patch(p).loops = {{{shared, p},
                             add_edge(model, p, 1, c, {1, 0}, {1, 1}),
                             add_edge(model, p, c, d, {1, 1}, {0, 1}),
                             add_edge(model, p, d, 0, {0, 1}, {0, 0})}};
  }
  finish(model);
  const MeshResult result = mesh_model(model);
  std::printf("%zu triangles\n", result.report.mesh.triangles);
}
