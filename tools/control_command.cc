// SPDX-License-Identifier: BSD-3-Clause
#include "control_command.hh"

#include <fmt/format.h>

#include <array>

#include "mesh_command.hh"
#include "output_paths.hh"
#include "progress.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/set_option.hh"
#include "surfmesh/pipeline/write_control.hh"

namespace surfmesh {
namespace {

constexpr const char* kFooter =
    "In a .vtu file points hold uv, the two sizes, the size tensor and the radii; faces the\n"
    "patch and the class of interpolation. ParaView shows the tensors with its filter Tensor "
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

}  // namespace

void ControlCommand::add_to(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "control", "Write the control meshes of a cage or a model file, to look at the sizes.");
  command->footer(kFooter);
  command
      ->add_option("INPUT", input_,
                   fmt::format("control cage ({}) or model file (.json)", cage_endings()))
      ->required()
      ->type_name("");
  command->add_option("-o,--output", output_, "file to write: .vtu or .obj")
      ->required()
      ->type_name("FILE");
  command->add_flag("--quiet", is_quiet_, "print warnings and errors only");
  using enum OptionGroup;
  add_flags(*command, named_, std::array{Sizes, ControlSpace, Cages});
  add_scheme(*command, scheme_);
  add_set(*command, set_, "set any option by its name; beats the other flags and the model file");
}

int ControlCommand::write_control_meshes(Progress& progress) const {
  check_control_ending(output_);
  check_writable(output_);
  if (is_same_file(input_, output_)) {
    throw Error(ErrorCode::Io, fmt::format("{} is the input, it is not overwritten", output_));
  }
  Settings settings = named_;
  settings.insert(settings.end(), set_.begin(), set_.end());
  ModelInput input = load_model(input_, cage_options(scheme_, settings));
  for (const auto& [name, value] : settings) set_option(input.options, name, value);
  ControlSpaces control;
  with_threads(input.options.threads, [&] {
    control = make_control_spaces(input.model, input.sources,
                                  resolve(input.options.sizing, input.model.diagonal),
                                  input.options.control, RunContext(&progress));
  });
  const std::vector<ControlPicture> pictures = pictures_of(input.model, control);
  write_control(pictures, output_);
  progress.clear();
  std::size_t nodes = 0, faces = 0;
  for (const ControlPicture& picture : pictures) {
    nodes += picture.mesh->n_vertices();
    faces += picture.mesh->n_faces();
  }
  if (!is_quiet_) fmt::print("{}: {} nodes, {} faces\n", output_, nodes, faces);
  Notices notices = input.model.notices;
  append(control.notices, notices);
  print_notices(notices);
  return has_shortfall(notices) ? kFellShort : kDone;
}

int ControlCommand::run() const {
  catch_signals();
  Progress progress(!is_quiet_ && is_terminal());
  try {
    return write_control_meshes(progress);
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
