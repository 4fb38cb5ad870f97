// SPDX-License-Identifier: BSD-3-Clause
#include "view_command.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <span>

#include "mesh_command.hh"
#include "output_paths.hh"
#include "outputs.hh"
#include "read_model.hh"
#include "standard_output.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/model/cad_input.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/quality/project_mesh.hh"
#include "surfmesh/quality/sag.hh"
#include "surfmesh/quality/statistics.hh"
#include "surfmesh/quality/surface_search.hh"
#include "view/page.hh"
#include "view/page_mesh.hh"
#include "view/viewer_script.hh"

namespace surfmesh {
namespace {

constexpr const char* kViewFooter =
    "A mesh is shown as it is, a CAD or model file is meshed first. A mesh is meshed as a cage\n"
    "with --mesh or any option of meshing.\n"
    "All options of \"surfmesh mesh\" are there for models. The page needs no network. Its script "
    "is\n"
    "made once, by tools/setup.sh --viewer.\n"
    "Examples:\n"
    "  surfmesh view part.om -o part.html                     show a mesh\n"
    "  surfmesh view part.om --model part.step -o part.html   with names, sag and control meshes\n"
    "  surfmesh view knob.obj --hmax 5% -o knob.html          mesh a cage and show the mesh\n";

/// The option as it was given, if it is one of meshing: a mesh that is there already is as it is.
/// The number of threads is that of the whole command.
std::optional<std::string> option_of_meshing(const Settings& named, const Settings& set) {
  const auto is_of_meshing = [](const auto& setting) {
    return find_option(setting.first).group == OptionGroup::Meshing &&
           setting.first != ranges::kThreads.name;
  };
  const auto by_flag = std::find_if(named.begin(), named.end(), is_of_meshing);
  if (by_flag != named.end()) {
    std::string flag = by_flag->first;
    std::replace(flag.begin(), flag.end(), '_', '-');
    return fmt::format("--{}", flag);
  }
  const auto by_set = std::find_if(set.begin(), set.end(), is_of_meshing);
  if (by_set != set.end()) return fmt::format("--set {}", by_set->first);
  return std::nullopt;
}

/// The distance from the surface, where the mesh does not have it from its run.
void add_sag(PolyMesh& mesh, const Model& model, Progress& progress) {
  if (find(mesh, keys::face_sag).is_valid()) return;
  progress.progress("compare", 0, 1);
  const std::vector<double> sag = estimate_sag(mesh, model, RunContext(&progress));
  mesh.property(attach(mesh, keys::face_sag)).data_vector() = sag;
}

/// Throws   InvalidInput where a face is on a patch that the model does not have
void check_patches(const PolyMesh& mesh, const Model& model, const std::string& mesh_path,
                   const std::string& model_path) {
  const auto patch_of = find(mesh, keys::face_patch);
  if (!patch_of.is_valid()) return;
  for (const FaceHandle fh : mesh.faces()) {
    const int patch = mesh.property(patch_of, fh);
    if (patch >= 0 && static_cast<std::size_t>(patch) < model.patches.size()) continue;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{} is no mesh of {}: face {} is on patch {}, and the model has {}",
                            mesh_path, model_path, fh.idx(), patch, model.patches.size()));
  }
}

}  // namespace

void ViewCommand::add_to(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "view", "Write a page that shows a mesh, or the mesh of a model, in a browser.");
  command->footer(kViewFooter);
  add_files(*command);
  using enum OptionGroup;
  add_flags(*command, named_, std::array{Sizes, ControlSpace, Meshing, Cages}, ShortHelp::None);
  add_scheme(*command, scheme_);
  add_set(*command, set_, "set any option by its name; beats the other flags and the model file");
}

void ViewCommand::add_files(CLI::App& command) {
  command
      .add_option("INPUT", input_,
                  fmt::format("mesh ({}), CAD file or model file (.json)", readable_mesh_endings()))
      ->required()
      ->type_name("");
  command.add_option("-o,--output", output_, "page to write: .html")->required()->type_name("FILE");
  command.add_option("--model", model_, "what INPUT is a mesh of: cage, CAD or model file")
      ->type_name("FILE");
  command.add_flag("--mesh", is_meshed_,
                   fmt::format("mesh a file of {}, which is a cage then", cage_endings()));
  command.add_flag("--quiet", is_quiet_, "print warnings and errors only");
  add_verbose(command, is_verbose_, "print every warning");
  command.parse_complete_callback([this] { check_usage(); });
}

Settings ViewCommand::settings() const {
  Settings settings = named_;
  settings.insert(settings.end(), set_.begin(), set_.end());
  return settings;
}

bool ViewCommand::asks_for_meshing() const {
  return is_meshed_ || !named_.empty() || !set_.empty() || scheme_ != Scheme::Auto;
}

/// True for what is meshed first.
bool ViewCommand::is_model() const {
  if (lower_case_ending(input_) == ".json" || has_cad_ending(input_)) return true;
  return model_.empty() && has_cage_ending(input_) && asks_for_meshing();
}

void ViewCommand::check_usage() const {
  if (is_meshed_ && !model_.empty()) {
    throw CLI::ValidationError("--mesh: a mesh with its --model is not meshed");
  }
  if (is_model() && !model_.empty()) {
    throw CLI::ValidationError(fmt::format("--model: {} is a model itself", input_));
  }
  if (const auto option = option_of_meshing(named_, set_); option && !model_.empty()) {
    throw CLI::ValidationError(fmt::format("{}: a mesh with its --model is not meshed", *option));
  }
  if (!is_model() && model_.empty() && asks_for_meshing()) {
    throw CLI::ValidationError(
        fmt::format("{} is a mesh, which is shown as it is: options of meshing are for models, or "
                    "go with --model",
                    input_));
  }
}

/// An .obj or .off file may be a mesh or a cage: say what it was taken for. Files of the other
/// formats mostly are what they are taken for.
void ViewCommand::tell_choice() const {
  const std::string ending = lower_case_ending(input_);
  const bool is_in_doubt = ending == ".obj" || ending == ".off";
  if (is_quiet_ || !(is_in_doubt || is_model()) || !has_cage_ending(input_) || !model_.empty()) {
    return;
  }
  tell(is_model()
           ? fmt::format("surfmesh: {} is meshed as a cage; to see the file itself, leave "
                         "out the options of meshing\n",
                         input_)
           : fmt::format("surfmesh: {} is shown as it is; to mesh it as a cage, add --mesh\n",
                         input_));
}

/// Write the page and tell what it is. Returns the exit status.
int ViewCommand::finish(const PageContents& contents, const std::string& script,
                        Progress& progress) const {
  int status = has_shortfall(contents.notices) ? kFellShort : kDone;
  progress.progress("write", 0, 1);
  Outputs outputs;
  const auto bytes = static_cast<double>(write_page(contents, script, outputs.add(output_)));
  outputs.commit(status);
  progress.clear();
  constexpr double megabyte = 1e6;
  if (!is_quiet_) {
    status = print_summary(
        fmt::format("{}: {} vertices, {} faces, {:.1f} MB\n", output_, contents.mesh.n_vertices(),
                    contents.mesh.n_faces(), bytes / megabyte),
        status);
  }
  print_notices(contents.notices, {.is_quiet = is_quiet_, .is_verbose = is_verbose_});
  return status;
}

int ViewCommand::view_model(const std::string& script, Progress& progress) const {
  const auto [input, given] = read_model(input_, scheme_, settings(), progress);
  check_not_overwritten(input.files, output_);
  if (input.options.sizing.sag) progress.expect_passes();
  const ControlSpaces control = make_control_spaces(input_, input, progress);
  MeshResult result = at_input(
      input_, [&] { return mesh_model(input.model, input.sources, input.options, &progress); });
  result.report.input = input_;
  result.report.files = input.files;
  result.report.given = given;
  throw_if_signalled();
  add_sag(result.mesh, input.model, progress);
  return finish({.title = std::filesystem::path(input_).filename().string(),
                 .model = input_,
                 .mesh = result.mesh,
                 .names = result.names,
                 .notices = result.report.notices,
                 .report = &result.report,
                 .control = &control},
                script, progress);
}

int ViewCommand::view_mesh(const std::string& script, Progress& progress) const {
  check_mesh_ending(input_);
  progress.progress("read", 0, 1);
  MeshFile file = read_mesh(input_);
  throw_if_signalled();
  ControlSpaces control;
  if (model_.empty()) {
    at_input(input_, [&] { check_patch_numbers(file.mesh, file.names); });
  } else {
    const ModelInput input = read_model(model_, scheme_, settings(), progress).input;
    check_not_overwritten(input.files, output_);
    control = make_control_spaces(model_, input, progress);
    const Model& model = input.model;
    if (has_parameters(file.mesh)) {
      check_patches(file.mesh, model, input_, model_);
    } else {
      progress.progress("compare", 0, 1);
      project_mesh(file.mesh, file.names.patches, model, SurfaceSearch(model),
                   RunContext(&progress));
    }
    file.names = mesh_names(model);
    add_sag(file.mesh, model, progress);
    append(model.notices, file.notices);
    append(control.notices, file.notices);
  }
  return finish({.title = std::filesystem::path(input_).filename().string(),
                 .model = model_,
                 .mesh = file.mesh,
                 .names = file.names,
                 .notices = file.notices,
                 .control = model_.empty() ? nullptr : &control},
                script, progress);
}

int ViewCommand::view(Progress& progress) const {
  const std::string ending = lower_case_ending(output_);
  if (ending != ".html" && ending != ".htm") {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: a page is written as .html", output_));
  }
  check_writable(output_);
  check_not_overwritten(std::array{std::filesystem::path(input_)}, output_);
  if (!is_model()) check_mesh_ending(input_);
  // Missed now, not after minutes of meshing.
  const std::string script = read_viewer_script(viewer_places());
  tell_choice();
  return is_model() ? view_model(script, progress) : view_mesh(script, progress);
}

int ViewCommand::run() const {
  catch_signals();
  Progress progress(!is_quiet_ && is_terminal(),
                    is_model() ? std::span<const StageWeight>(kViewModelStages) : kViewMeshStages);
  try {
    return view(progress);
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
