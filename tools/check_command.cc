// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "mesh_command.hh"
#include "read_model.hh"
#include "standard_output.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/pipeline/check_mesh.hh"

namespace surfmesh {
namespace {

constexpr const char* kCheckFooter =
    "Faults (exit status 3): non_manifold_edge, non_manifold_vertex, turned_neighbour (faces that\n"
    "  pass their edge in the same direction), degenerate_face, duplicate_face, duplicate_vertex,\n"
    "  unused_vertex; with --model: turned_face (against the normal of the surface),\n"
    "  corner_off_surface, open_edge, closed_edge, components, euler (not as in the model)\n"
    "Keys of the JSON text: mesh, model, clean, faults, notices, counts, open_edges,\n"
    "  self_intersections (no fault), closed, manifold, oriented, area, volume (null unless "
    "closed\n"
    "  and oriented), box, angles (degrees), edge_lengths, shape, stored_metric, fit (or null)\n"
    "Judged by the metric of an .om file; else, or with sizes, by that of a run; distance by "
    "--sag.\n"
    "Example:\n  surfmesh check knob.om --model knob.obj --json\n";

/// Sizes asked for on the command line judge a mesh; otherwise those that it was made by do. A sag
/// is a distance, no size.
JudgedBy judged_by(const Settings& settings) {
  const bool asks_for_sizes =
      std::any_of(settings.begin(), settings.end(), [](const auto& setting) {
        return find_option(setting.first).group == OptionGroup::Sizes &&
               setting.first != ranges::kSag.name;
      });
  return asks_for_sizes ? JudgedBy::SizesOfRun : JudgedBy::StoredMetric;
}

}  // namespace

void CheckCommand::add_to(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "check", "Describe a mesh, list its faults, and tell how it fits its model.");
  command->footer(kCheckFooter);
  command->add_option("MESH", mesh_, "mesh: " + readable_mesh_endings())->required()->type_name("");
  CLI::Option* model =
      command->add_option("--model", model_, "what it is a mesh of: cage, CAD file or model file")
          ->type_name("INPUT");
  using enum OptionGroup;
  std::vector<CLI::Option*> of_model = add_flags(*command, named_, std::array{Sizes, Cages});
  add_scheme(*command, scheme_);
  add_set(*command, set_, "set any option by its name; beats the other flags and the model file");
  for (const char* name : {"--scheme", "--set"}) of_model.push_back(command->get_option(name));
  for (CLI::Option* option : of_model) option->needs(model);
  command->add_flag("--json", is_json_, "print JSON text");
  add_verbose(*command, is_verbose_, "print all tables, and every warning");
}

MeshCheck CheckCommand::measure(Progress& progress) const {
  ModelInput input;
  Settings settings = named_;
  settings.insert(settings.end(), set_.begin(), set_.end());
  progress.progress("read", 0, 1);
  if (!model_.empty()) input = read_model(model_, scheme_, settings, progress).input;
  progress.progress("check", 0, 1);
  MeshCheck check = check_mesh(read_mesh_arrays(mesh_), &progress);
  check.mesh = mesh_;
  check.model = model_;
  // Read again: this is the mesh as it was mended, with all that the format knows of its corners.
  MeshFile mesh = read_mesh(mesh_);
  check.stored = measure_stored_metric(mesh.mesh);
  if (model_.empty()) return check;
  progress.progress("compare", 0, 1);
  append(input.model.notices, check.notices);
  check.patch_names = mesh_names(input.model).patches;
  add_fit(check, measure_fit(mesh, input, judged_by(settings), &progress));
  return check;
}

int CheckCommand::check(Progress& progress) const {
  check_readable_ending(mesh_);
  const MeshCheck check = measure(progress);
  progress.clear();
  print(is_json_ ? to_json(check) : to_text(check, text_style(is_verbose_)));
  print_notices(check.notices, {.is_verbose = is_verbose_});
  for (const MeshFault& fault : check.faults) {
    tell(fmt::format("surfmesh: fault: {}: {}, the first: {}\n", fault.kind, fault.count,
                     fault.places.front()));
  }
  return check.faults.empty() && !has_shortfall(check.notices) ? kDone : kFellShort;
}

int CheckCommand::run() const {
  catch_signals();
  Progress progress(is_terminal(), kCheckStages);
  try {
    return check(progress);
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
