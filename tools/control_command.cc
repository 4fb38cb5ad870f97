// SPDX-License-Identifier: BSD-3-Clause
#include "control_command.hh"

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "mesh_command.hh"
#include "output_paths.hh"
#include "outputs.hh"
#include "progress.hh"
#include "read_model.hh"
#include "standard_output.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/pipeline/write_control.hh"

namespace surfmesh {
namespace {

constexpr const char* kControlFooter =
    "In a .vtu file points hold uv, the two sizes, the size tensor and the radii; faces the\n"
    "  patch and the class of interpolation. ParaView shows the tensors with its filter Tensor "
    "Glyph.\n"
    "Example:\n  surfmesh control wave.json -o wave.vtu --nodes 2500 --interpolation auto\n";

std::vector<ControlPicture> pictures_of(const Model& model, const ControlSpaces& control) {
  std::vector<ControlPicture> pictures;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    pictures.push_back(
        {model.patches[p].name, &control.spaces[p]->mesh(), model.patches[p].surface.get()});
  }
  return pictures;
}

/// What was written, and in the long form a line for each patch.
std::string summary_of(const std::vector<ControlPicture>& pictures, const std::string& path,
                       bool is_verbose) {
  std::size_t nodes = 0, faces = 0;
  std::string patches;
  for (const ControlPicture& picture : pictures) {
    nodes += picture.mesh->n_vertices();
    faces += picture.mesh->n_faces();
    if (!is_verbose) continue;
    patches += fmt::format("{:>10} nodes {:>10} faces  {}\n", picture.mesh->n_vertices(),
                           picture.mesh->n_faces(), picture.patch);
  }
  return fmt::format("{}: {} nodes, {} faces\n{}", path, nodes, faces, patches);
}

}  // namespace

void ControlCommand::add_to(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("control", "Write the control meshes of a model, to look at its sizes.");
  command->footer(kControlFooter);
  command
      ->add_option("INPUT", input_,
                   "cage: .obj .off .ply .stl .om; CAD: .step .igs .brep; model: .json")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", output_, "file to write: .vtu or .obj")
      ->required()
      ->type_name("FILE");
  command->add_flag("--quiet", is_quiet_, "print warnings and errors only");
  add_verbose(*command, is_verbose_, "print the nodes of each patch, and every warning");
  using enum OptionGroup;
  add_flags(*command, named_, std::array{Sizes, ControlSpace, Cages});
  add_scheme(*command, scheme_);
  add_set(*command, set_, "set any option by its name; beats the other flags and the model file");
}

int ControlCommand::write_control_meshes(Progress& progress) const {
  check_control_ending(output_);
  check_writable(output_);
  check_not_overwritten(std::array{std::filesystem::path(input_)}, output_);
  Settings settings = named_;
  settings.insert(settings.end(), set_.begin(), set_.end());
  const ModelInput input = read_model(input_, scheme_, settings, progress).input;
  check_not_overwritten(input.files, output_);
  const ControlSpaces control = make_control_spaces(input_, input, progress);
  const std::vector<ControlPicture> pictures = pictures_of(input.model, control);
  Notices notices = input.model.notices;
  append(control.notices, notices);
  int status = has_shortfall(notices) ? kFellShort : kDone;
  progress.progress("write", 0, 1);
  Outputs outputs;
  write_control(pictures, outputs.add(output_));
  outputs.commit(status);
  progress.clear();
  if (!is_quiet_) status = print_summary(summary_of(pictures, output_, is_verbose_), status);
  print_notices(notices, {.is_quiet = is_quiet_, .is_verbose = is_verbose_});
  return status;
}

int ControlCommand::run() const {
  catch_signals();
  Progress progress(!is_quiet_ && is_terminal(), kControlStages);
  try {
    return write_control_meshes(progress);
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
