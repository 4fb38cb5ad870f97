// SPDX-License-Identifier: BSD-3-Clause
// Mesh patches that are C++ functions: half a tube and a lid, with sizes on the tube and at a
// point. The sides that they share are found; derivatives are exact without being written down.
#include <array>
#include <cstdio>
#include <exception>
#include <numbers>

#include <surfmesh/surfmesh.hh>

int main() try {
  using std::numbers::pi;
  const auto tube = [](auto u, auto v) { return std::array{cos(u), sin(u), v}; };
  const auto lid = [](auto u, auto v) { return std::array{v * cos(u), v * sin(u), 0 * u}; };
  const surfmesh::Model model =
      surfmesh::model_from_patches({{"tube", surfmesh::make_callable_surface({0, pi, 0, 2}, tube)},
                                    {"lid", surfmesh::make_callable_surface({0, pi, 0, 1}, lid)}});

  const auto fine = surfmesh::Size::isotropic(surfmesh::Length::units(0.05));
  surfmesh::Sources sources;
  sources.everywhere.push_back(
      {.patch = 0,
       .size = {surfmesh::Length::share(0.02), surfmesh::Length::share(0.1)}});  // of the diagonal
  sources.at.push_back({.patch = 1, .at = {pi / 2, 0.5}, .size = fine});
  surfmesh::PipelineOptions options;
  options.sizing.grade = 1.3;

  const auto [mesh, names, report] = surfmesh::mesh_model(model, sources, options);
  for (const surfmesh::Contour& contour : model.contours) {
    if (contour.uses.size() > 1) std::printf("shared: %s\n", contour.name.c_str());
  }
  std::printf("%zu triangles, Euler number %ld\n", report.mesh.triangles, report.mesh.euler);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
