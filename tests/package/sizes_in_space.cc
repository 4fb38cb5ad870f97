// SPDX-License-Identifier: BSD-3-Clause
// Load a cage with creases by angle, ask for a size near one of its vertices and for another in a
// group, and tell what the run has to say.
#include <cstdio>
#include <exception>

#include <surfmesh/surfmesh.hh>

int main(int argc, char** argv) try {
  if (argc != 3) return std::fprintf(stderr, "usage: sizes_in_space CAGE MESH\n"), 2;
  using surfmesh::Length, surfmesh::Size;
  // Options of cages, and the joining of formula patches, act where the model is made.
  auto input = surfmesh::load_model(argv[1], {.cages = {.crease_angle = 60}});
  input.options.sizing.sag = Length::percent(0.5);
  surfmesh::set_option(input.options, "hmax", "10%");  // by name, as the command line does
  input.options.output.normals = true;                 // before the run: it makes them

  auto& sources = input.sources;
  sources.near.push_back({.line = {surfmesh::Vec3(1, 0, 0.5)},
                          .wish = {Size::isotropic(Length::percent(1)), Length::units(0.2)}});
  for (const int patch : surfmesh::find_group(input.model, "grip")) {
    sources.everywhere.push_back({.patch = patch, .size = Size::isotropic(Length::percent(3))});
  }
  const auto result = surfmesh::mesh_model(input.model, sources, input.options);
  for (const surfmesh::Notice& notice : result.report.notices) {
    std::printf("%s: %s\n", name(notice.kind).data(), notice.text.c_str());
  }
  surfmesh::write_mesh(result, argv[2]);
  std::printf("%zu triangles\n", result.report.mesh.triangles);
  return has_shortfall(result.report.notices) ? 3 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
