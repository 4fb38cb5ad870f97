// SPDX-License-Identifier: BSD-3-Clause
// Mesh a bent plate that is trimmed: its outer loop follows two of its sides and a contour that
// cuts off a corner; a round contour is a hole.
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <numbers>

#include <surfmesh/surfmesh.hh>

int main() try {
  const auto bent = [](auto u, auto v) { return std::array{u, v, 0.1 * u * u}; };
  const auto cut = std::make_shared<surfmesh::SegmentCurve>(surfmesh::Uv{4, 0}, surfmesh::Uv{0, 3});
  const auto circle = std::make_shared<surfmesh::CallableCurve>([](double t) {
    const double angle = -2 * std::numbers::pi * t;  // clockwise: the plate is on the left
    return surfmesh::Uv{1 + 0.5 * std::cos(angle), 1 + 0.5 * std::sin(angle)};
  });
  const surfmesh::Model model = surfmesh::model_from_patches(
      {{.name = "plate",
        .surface = surfmesh::make_callable_surface({0, 4, 0, 3}, bent),
        .loops = {{"plate:v0", "cut", "-plate:u0"}, {"hole"}}}},
      {{.name = "cut", .on = {{"plate", cut}}}, {.name = "hole", .on = {{"plate", circle}}}});

  surfmesh::PipelineOptions options;
  options.sizing.hmax = surfmesh::Length::units(0.15);
  const auto [mesh, names, report] = surfmesh::mesh_model(model, {}, options);
  std::printf("%zu triangles, Euler number %ld\n", report.mesh.triangles, report.mesh.euler);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
