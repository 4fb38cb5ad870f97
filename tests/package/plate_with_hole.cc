// SPDX-License-Identifier: BSD-3-Clause
// Mesh a bent plate that is trimmed: an outer loop of straight contours in (u,v), and a round hole.
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <numbers>

#include "surfmesh/geometry/build_model.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/pipeline/mesh_model.hh"

int main() try {
  const auto bent = [](auto u, auto v) { return std::array{u, v, 0.1 * u * u}; };
  const auto circle = [](double t) {
    const double angle = 2 * std::numbers::pi * t;
    return surfmesh::Uv{1 + 0.5 * std::cos(angle), 1 + 0.5 * std::sin(angle)};
  };
  surfmesh::Model model;
  const int plate = add_patch(model, "plate", surfmesh::make_callable_surface({0, 4, 0, 3}, bent));
  add_loop(model, plate, surfmesh::polygon_curves("side", {{0, 0}, {4, 0}, {3, 2}, {0, 3}}));
  add_loop(model, plate, {{"hole", std::make_shared<surfmesh::CallableCurve>(circle)}});
  complete_model(model);

  surfmesh::PipelineOptions options;
  options.sizing.hmax = {0.15, false};
  const auto [mesh, report] = surfmesh::mesh_model(model, {}, options);
  std::printf("%zu triangles, Euler number %ld\n", report.mesh.triangles, report.mesh.euler);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
