// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hh"

#include <algorithm>
#include <string>

#include "cad.hh"
#include "check_command.hh"
#include "completion_command.hh"
#include "control_command.hh"
#include "convert_command.hh"
#include "exit_status.hh"
#include "man_command.hh"
#include "mesh_command.hh"
#include "picture_command.hh"
#include "surfmesh/core/version.hh"
#include "view_command.hh"

namespace surfmesh {
namespace {

constexpr const char* kProgramFooter =
    "Examples:\n"
    "  surfmesh mesh cage.obj -o mesh.om        mesh the limit surface of a cage\n"
    "  surfmesh mesh part.step -o mesh.obj      mesh a part of a CAD program\n"
    "  surfmesh mesh model.json -o mesh.obj     mesh what a model file describes\n"
    "  surfmesh check mesh.om --model cage.obj  tell how good the mesh is\n"
    "  surfmesh convert mesh.om mesh.ply        write it in another format\n"
    "  surfmesh view mesh.om -o mesh.html       look at the mesh in a browser\n"
    "  surfmesh picture mesh.om -o mesh.png     draw it, for papers and pages\n"
    "  surfmesh control model.json -o sizes.vtu look at the sizes it asks for\n"
    "Exit status: 0 done; 1 not done; 2 wrong usage; 3 done, but something asked for was not\n"
    "  reached, or check found a fault; 130, 143 stopped by a signal\n"
    "surfmesh COMMAND --help lists the options of a command with their defaults.\n";

/// The version, and in a second line that of what reads CAD files, if something does.
std::string version_text() {
  std::string text = "surfmesh " SURFMESH_VERSION;
  const std::string cad = cad_library();
  if (!cad.empty()) text.append("\n").append(cad);
  return text;
}

}  // namespace

CommandLine::CommandLine()
    : app_("Mesh multi-patch parametric surfaces with elements that follow a metric.", "surfmesh") {
  app_.set_version_flag("--version", version_text());
  app_.footer(kProgramFooter);
  app_.require_subcommand(1);
  add<MeshCommand>();
  add<CheckCommand>();
  add<ConvertCommand>();
  add<ControlCommand>();
  add<PictureCommand>();
  add<ViewCommand>();
  add<CompletionCommand>();
  add<ManCommand>();
}

int CommandLine::run() const {
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [](const Entry& e) { return e.app->parsed(); });
  return entry == entries_.end() ? kWrongUsage : entry->run();
}

}  // namespace surfmesh
