// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <utility>

#include "cad.hh"
#include "check_command.hh"
#include "control_command.hh"
#include "convert_command.hh"
#include "mesh_command.hh"
#include "signals.hh"
#include "standard_output.hh"
#include "surfmesh/core/version.hh"
#include "usage.hh"
#include "view_command.hh"

namespace {

int tell_wrong_usage(const CLI::App& app, const std::string& fault) {
  std::fprintf(stderr, "surfmesh: error: %s\n%s tells more\n", fault.c_str(),
               surfmesh::help_line(app).c_str());
  return surfmesh::kWrongUsage;
}

/// CLI11 has many codes; the documentation has one for wrong usage.
int exit_status(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {  // --help, --version
    std::ostringstream text;
    app.exit(error, text);
    surfmesh::print(text.str());
    return surfmesh::kDone;
  }
  return tell_wrong_usage(app, surfmesh::usage_fault(app, error));
}

constexpr const char* kFooter =
    "Examples:\n"
    "  surfmesh mesh cage.obj -o mesh.om        mesh the limit surface of a cage\n"
    "  surfmesh mesh part.step -o mesh.obj      mesh a part of a CAD program\n"
    "  surfmesh mesh model.json -o mesh.obj     mesh what a model file describes\n"
    "  surfmesh check mesh.om --model cage.obj  tell how good the mesh is\n"
    "  surfmesh convert mesh.om mesh.ply        write it in another format\n"
    "  surfmesh control model.json -o sizes.vtu look at the sizes it asks for\n"
    "  surfmesh view mesh.om -o mesh.html       look at the mesh in a browser\n"
    "Exit status: 0 done; 1 not done; 2 wrong usage; 3 done, but something asked for was not\n"
    "  reached, or check found a fault; 130, 143 stopped by a signal\n"
    "surfmesh COMMAND --help lists the options of a command with their defaults.\n";

/// The version, and in a second line that of what reads CAD files, if something does.
std::string version_text() {
  std::string text = "surfmesh " SURFMESH_VERSION;
  const std::string cad = surfmesh::cad_library();
  if (!cad.empty()) text.append("\n").append(cad);
  return text;
}

int run(int argc, char** argv) {
  CLI::App app("Mesh multi-patch parametric surfaces with elements that follow a metric.",
               "surfmesh");
  app.set_version_flag("--version", version_text());
  app.footer(kFooter);
  app.require_subcommand(1);
  surfmesh::MeshCommand mesh;
  mesh.add_to(app);
  surfmesh::CheckCommand check;
  check.add_to(app);
  surfmesh::ConvertCommand convert;
  convert.add_to(app);
  surfmesh::ControlCommand control;
  control.add_to(app);
  surfmesh::ViewCommand view;
  view.add_to(app);
  auto arguments = surfmesh::with_switch_values({argv + 1, argv + argc});
  if (const std::string fault = surfmesh::one_dash_fault(app, arguments); !fault.empty()) {
    return tell_wrong_usage(app, fault);
  }
  if (const std::string fault = surfmesh::command_fault(app, arguments); !fault.empty()) {
    return tell_wrong_usage(app, fault);
  }
  try {
    std::reverse(arguments.begin(), arguments.end());  // as the parser takes them
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return exit_status(app, error);
  }
  if (app.got_subcommand("check")) return check.run();
  if (app.got_subcommand("convert")) return convert.run();
  if (app.got_subcommand("control")) return control.run();
  if (app.got_subcommand("view")) return view.run();
  return mesh.run();
}

}  // namespace

int main(int argc, char** argv) {
  surfmesh::keep_closed_streams_closed();
  surfmesh::take_errors_for_signals();
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surfmesh: error: %s\n", error.what());
    return surfmesh::kFailed;
  }
}
