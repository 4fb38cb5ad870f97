// SPDX-License-Identifier: BSD-3-Clause
#include "convert_command.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh_command.hh"
#include "output_paths.hh"
#include "outputs.hh"
#include "settings.hh"
#include "standard_output.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/quality/patch_measures.hh"

namespace surfmesh {
namespace {

constexpr const char* kConvertFooter =
    "Patches of the faces are kept with their names and groups, as .obj has them in `g GROUP... "
    "PATCH`.\n"
    "What the format of OUT cannot hold is told in warnings.\n"
    "Example:\n  surfmesh convert knob.om knob.ply\n";

/// What was written, and in the long form a line for each patch.
std::string summary_of(const MeshFile& file, const std::string& path, bool is_verbose) {
  std::string text =
      fmt::format("{}: {} vertices, {} faces\n", path, file.mesh.n_vertices(), file.mesh.n_faces());
  if (!is_verbose) return text;
  for (const PatchMeasure& patch : measure_patches(file.mesh, file.names)) {
    text += fmt::format("{:>10} faces, area {:<11.4g} {}\n",
                        patch.triangles + patch.quads + patch.polygons, patch.area, patch.name);
  }
  return text;
}

}  // namespace

void ConvertCommand::add_to(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("convert", "Write a mesh in another format, chosen by the ending.");
  command->footer(kConvertFooter);
  command->add_option("IN", input_, fmt::format("mesh to read: {}", readable_mesh_endings()))
      ->required()
      ->type_name("");
  command->add_option("OUT", output_, fmt::format("mesh to write: {}", mesh_endings()))
      ->required()
      ->type_name("");
  command->add_flag("--normals", options_.normals,
                    fmt::format("write the normals of the corners, which an .om file may have ({})",
                                corner_value_endings()));
  command->add_flag("--uv", options_.uv, "write the parameters (u,v) of the corners, likewise");
  command->add_flag("--texture", options_.texture,
                    "write the texture coordinates of the corners, likewise");
  std::vector<std::string> versions;
  for (const OptionWord& word : ranges::kMsh.words) versions.emplace_back(word.word);
  command
      ->add_option_function<std::string>(
          "--msh",
          [this](const std::string& word) {
            const double value = ranges::kMsh.read(word).value();
            options_.msh = static_cast<MshVersion>(value);
          },
          "version of .msh files, binary or text")
      ->check(CLI::IsMember(versions))
      ->option_text(fmt::format("{}={}", fmt::join(versions, "|"), versions.front()));
  command->add_flag("--quiet", is_quiet_, "print warnings and errors only");
  add_verbose(*command, is_verbose_, "print the faces of each patch, and every warning");
}

int ConvertCommand::convert() const {
  check_mesh_ending(output_);
  check_writable(output_);
  check_not_overwritten(std::array{std::filesystem::path(input_)}, output_);
  const MeshFile file = read_mesh(input_);
  Outputs outputs;
  write_mesh(file.mesh, outputs.add(output_), file.names, options_);
  if (const auto beside = companion_of(file.mesh, output_)) {
    check_not_overwritten(std::array{std::filesystem::path(input_)}, *beside);
    write_companion(file.mesh, output_, outputs.add(*beside));
  }
  outputs.commit(kDone);
  int status = kDone;
  if (!is_quiet_) {
    status = print_summary(summary_of(file, output_, is_verbose_), status);
  }
  print_notices(file.notices, {.is_quiet = is_quiet_, .is_verbose = is_verbose_});
  print_notices(unused_options(file.mesh, output_, options_),
                {.is_quiet = is_quiet_, .is_verbose = is_verbose_});
  print_notices(stale_companion(file.mesh, output_),
                {.is_quiet = is_quiet_, .is_verbose = is_verbose_});
  for (const std::string& unread : file.unread) {
    tell(fmt::format("surfmesh: warning: the {} of {} are left out\n", unread, input_));
  }
  for (const std::string& lost : what_is_lost(file.mesh, output_, file.names, options_)) {
    tell(fmt::format("surfmesh: warning: {} does not hold {}\n", output_, lost));
  }
  return status;
}

int ConvertCommand::run() const {
  catch_signals();
  Progress progress(false);
  try {
    return convert();
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
