// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_command.hh"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <optional>

#include "output_paths.hh"
#include "progress.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/io/output_file.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  surfmesh mesh knob.obj -o knob.om --curvature 0.2 --hmax 5% --report knob.json\n"
    "  surfmesh mesh wave.json -o wave.obj --nodes 40000 --set smoothing=4 --quiet\n";

void check_paths(const std::string& input, const std::string& output, const std::string& report) {
  check_mesh_ending(output);
  check_writable(output);
  if (is_same_file(input, output)) {
    throw Error(ErrorCode::Io, fmt::format("{} is the input, it is not overwritten", output));
  }
  if (report.empty()) return;
  check_writable(report);
  if (is_same_file(input, report) || is_same_file(output, report)) {
    throw Error(ErrorCode::Io, fmt::format("{} is the input or the output, too", report));
  }
}

void stop_on_signal() {
  if (caught_signal() != 0) throw Error(ErrorCode::Cancelled, "stopped by a signal");
}

/// One run of the command, with the clocks of reading and writing.
class MeshRun {
 public:
  MeshRun(const CageOptions& cage_options, const Settings& settings)
      : cage_options_(cage_options), settings_(settings) {}

  void read(const std::string& path) {
    const double start = processor_seconds();
    input_ = load_model(path, cage_options_);
    for (const auto& [name, value] : settings_) set_option(input_.options, name, value);
    read_seconds_ = processor_seconds() - start;
    stop_on_signal();
  }

  /// Made where it is returned to: a mesh cannot be moved, and a copy takes time.
  MeshResult mesh(const std::string& path, Progress& progress) const {
    MeshResult result = mesh_model(input_.model, input_.sources, input_.options, &progress);
    result.report.input = path;
    result.report.seconds[Stage::Read] = read_seconds_;
    stop_on_signal();
    return result;
  }

  /// Write the mesh, and the report with its last clocks if it has a path. The report's file is
  /// made first: where it cannot be, there is no mesh either.
  void write(MeshResult& result, const std::string& mesh_path,
             const std::string& report_path) const {
    std::optional<OutputFile> report_file;
    if (!report_path.empty()) report_file.emplace(report_path);
    const double start = processor_seconds();
    write_mesh(result, mesh_path);
    result.report.seconds[Stage::Write] = processor_seconds() - start;
    result.report.wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (!report_file) return;
    report_file->write(to_json(result.report));
    report_file->commit();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  CageOptions cage_options_;
  const Settings& settings_;
  ModelInput input_;
  double read_seconds_ = 0;
};

}  // namespace

void print_notices(const Notices& notices) {
  for (const std::string& line : lines_of(notices)) fmt::print(stderr, "surfmesh: {}\n", line);
}

int tell_failure(const std::exception& error, Progress& progress) {
  progress.clear();
  if (caught_signal() != 0) {
    fmt::print(stderr, "surfmesh: stopped by a signal\n");
    return kKilledBySignal + caught_signal();
  }
  fmt::print(stderr, "surfmesh: error: {}\n", error.what());
  return kFailed;
}

void MeshCommand::add_to(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("mesh", "Mesh a control cage or a model file with triangles.");
  command->footer(kFooter);
  add_files(*command);
  using enum OptionGroup;
  add_flags(*command, named_, std::array{Sizes, ControlSpace, Meshing, Cages});
  add_scheme(*command, scheme_);
  add_set(*command, set_, "set any option by its name; beats the other flags and the model file");
}

void MeshCommand::add_files(CLI::App& command) {
  command
      .add_option("INPUT", input_,
                  fmt::format("control cage ({}) or model file (.json)", cage_endings()))
      ->required()
      ->type_name("");
  command
      .add_option("-o,--output", output_,
                  fmt::format("mesh to write: {}; .om keeps everything", mesh_endings()))
      ->required()
      ->type_name("FILE");
  command.add_option("--report", report_, "write the report as JSON")->type_name("FILE.json");
  command.add_flag("--quiet", is_quiet_, "print warnings and errors only");
}

int MeshCommand::run() const {
  catch_signals();
  Settings settings = named_;
  settings.insert(settings.end(), set_.begin(), set_.end());
  Progress progress(!is_quiet_ && is_terminal());
  try {
    check_paths(input_, output_, report_);
    MeshRun run(cage_options(scheme_, settings), settings);
    run.read(input_);
    MeshResult result = run.mesh(input_, progress);
    run.write(result, output_, report_);
    progress.clear();
    if (!is_quiet_) fmt::print("{}", to_text(result.report));
    print_notices(result.report.notices);
    return has_shortfall(result.report.notices) ? kFellShort : kDone;
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
