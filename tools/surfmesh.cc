// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "check_command.hh"
#include "convert_command.hh"
#include "mesh_command.hh"

namespace {

/// CLI11 has many codes; the documentation has one for wrong usage.
int exit_status(const CLI::App& app, const CLI::ParseError& error) {
  return app.exit(error) == 0 ? surfmesh::kDone : surfmesh::kWrongUsage;
}

int run(int argc, char** argv) {
  CLI::App app("Mesh multi-patch parametric surfaces with elements that follow a metric.",
               "surfmesh");
  app.set_version_flag("--version", "surfmesh " SURFMESH_VERSION);
  app.require_subcommand(1);
  surfmesh::MeshCommand mesh;
  mesh.add_to(app);
  surfmesh::CheckCommand check;
  check.add_to(app);
  surfmesh::ConvertCommand convert;
  convert.add_to(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return exit_status(app, error);
  }
  if (app.got_subcommand("check")) return check.run();
  if (app.got_subcommand("convert")) return convert.run();
  return mesh.run();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surfmesh: error: %s\n", error.what());
    return surfmesh::kFailed;
  }
}
