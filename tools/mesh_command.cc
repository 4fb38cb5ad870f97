// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_command.hh"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <new>
#include <vector>

#include "output_paths.hh"
#include "outputs.hh"
#include "progress.hh"
#include "read_model.hh"
#include "standard_output.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// Share of the length of an edge by which an end may move in a file without a word.
constexpr double kToldRounding = 1e-3;

constexpr const char* kFooter =
    "Examples:\n"
    "  surfmesh mesh knob.obj -o knob.om --curvature 0.2 --hmax 5% --report knob.json\n";

/// Output and report are empty for none.
void check_paths(const std::string& input, const std::string& output, const std::string& report) {
  const std::array inputs = {std::filesystem::path(input)};
  for (const std::string& path : {output, report}) {
    if (path.empty()) continue;
    check_writable(path);
    check_not_overwritten(inputs, path);
  }
  if (!output.empty()) check_mesh_ending(output);
  if (!output.empty() && !report.empty() && is_same_file(output, report)) {
    throw Error(ErrorCode::Io, fmt::format("{} is the output, too", report));
  }
}

int status_of(const Report& report) { return has_shortfall(report.notices) ? kFellShort : kDone; }

/// One run of the command, with the clocks of reading and writing.
class MeshRun {
 public:
  void read(const std::string& path, Scheme scheme, const Settings& settings, Progress& progress) {
    const double start = processor_seconds();
    model_ = read_model(path, scheme, settings, progress);
    if (model_.input.options.sizing.sag) progress.expect_passes();
    read_seconds_ = processor_seconds() - start;
  }

  /// Throws   Io where a mesh or a report would replace a file that was read
  void check_outputs(const std::string& mesh_path, const std::string& report_path) const {
    for (const std::string& path : {mesh_path, report_path}) {
      if (!path.empty()) check_not_overwritten(model_.input.files, path);
    }
  }

  /// Made where it is returned to: a mesh cannot be moved, and a copy takes time.
  MeshResult mesh(const std::string& path, Progress& progress) const {
    const ModelInput& input = model_.input;
    MeshResult result = at_input(
        path, [&] { return mesh_model(input.model, input.sources, input.options, &progress); });
    describe(path, result.report);
    throw_if_signalled();
    return result;
  }

  Report estimate(const std::string& path, Progress& progress) const {
    const ModelInput& input = model_.input;
    Report report = at_input(
        path, [&] { return estimate_mesh(input.model, input.sources, input.options, &progress); });
    describe(path, report);
    throw_if_signalled();
    return report;
  }

  /// Write the report of an estimate.
  void write(Report& report, const std::string& path) const {
    report.wall_seconds = seconds_so_far();
    if (path.empty()) return;
    Outputs outputs;
    outputs.add(path).write(to_json(report));
    outputs.commit(status_of(report));
  }

  /// Write the mesh, and the report with its last clocks if it has a path.
  void write(MeshResult& result, const std::string& mesh_path,
             const std::string& report_path) const {
    result.report.output = mesh_path;
    Outputs outputs;
    {
      const StageClock clock(result.report.seconds[Stage::Write]);
      const SerialClock serial_clock(result.report.serial_seconds);
      write_files(result, mesh_path, outputs);
    }
    result.report.wall_seconds = seconds_so_far();
    if (!report_path.empty()) outputs.add(report_path).write(to_json(result.report));
    outputs.commit(status_of(result.report));
  }

 private:
  /// Write the mesh and the file that belongs beside it.
  void write_files(MeshResult& result, const std::string& mesh_path, Outputs& outputs) const {
    tell_rounding(result, mesh_path);
    append(unused_options(result.mesh, mesh_path, result.report.options.output),
           result.report.notices);
    append(changed_names(result.mesh, mesh_path, result.names), result.report.notices);
    append(stale_companion(result.mesh, mesh_path), result.report.notices);
    OutputFile& mesh_file = outputs.add(mesh_path);
    write_mesh(result, mesh_file);
    mesh_file.finish();
    if (const auto beside = companion_of(result.mesh, mesh_path)) {
      check_not_overwritten(model_.input.files, *beside);
      OutputFile& companion = outputs.add(*beside);
      write_companion(result.mesh, mesh_path, companion);
      companion.finish();
    }
  }

  static void tell_rounding(MeshResult& result, const std::string& path) {
    const Rounding rounding = rounding_of(result.mesh, path);
    if (!(rounding.share > kToldRounding)) return;
    result.report.notices.push_back(warning(
        NoticeKind::RoundedPositions,
        fmt::format("{} holds positions in single precision: vertices move by up to {:.3g}, "
                    "{:.2g} % of the length of an edge; .obj and .ply keep all digits, and "
                    "so would a model nearer to the origin",
                    path, rounding.greatest_move, 100 * rounding.share)));
  }

  /// What the run was asked for.
  void describe(const std::string& path, Report& report) const {
    report.input = path;
    report.files = model_.input.files;
    report.given = model_.given;
    report.seconds[Stage::Read] = read_seconds_;
  }

  double seconds_so_far() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  ReadModel model_;
  double read_seconds_ = 0;
};

}  // namespace

void print_notices(const Notices& notices, bool is_verbose) {
  const auto print_lines = [](const Notices& some) {
    for (const std::string& line : lines_of(some)) tell(fmt::format("surfmesh: {}\n", line));
  };
  if (!is_verbose) return print_lines(notices);
  for (const Notice& notice : notices) print_lines({notice});
}

TextStyle text_style(bool is_verbose) {
  return {.is_long = is_verbose, .has_unicode = shows_unicode(STDOUT_FILENO)};
}

int tell_failure(const std::exception& error, Progress& progress) {
  progress.clear();
  if (caught_signal() != 0) {
    tell("surfmesh: stopped by a signal\n");
    return kKilledBySignal + caught_signal();
  }
  const bool is_full = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  tell(fmt::format("surfmesh: error: {}\n", is_full ? "out of memory" : error.what()));
  return kFailed;
}

void MeshCommand::add_to(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "mesh", "Mesh a cage, a CAD file or a model file with triangles or quads.");
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
                  "cage: .obj .off .ply .stl .om; CAD: .step .igs .brep; model: .json")
      ->required()
      ->type_name("");
  command
      .add_option("-o,--output", output_,
                  fmt::format("mesh to write: {}; .om keeps everything", mesh_endings()))
      ->type_name("FILE");
  command.add_flag("--dry-run", is_dry_run_, "estimate the number of elements; needs no --output");
  command.parse_complete_callback([this] {
    if (output_.empty() && !is_dry_run_) throw CLI::RequiredError("--output");
  });
  command.add_option("--report", report_, "write the report as JSON")->type_name("FILE.json");
  command.add_flag("--quiet", is_quiet_, "print warnings and errors only");
  add_verbose(command, is_verbose_, "print all tables, and every warning");
}

/// Print what the run has made. Returns the exit status.
int MeshCommand::finish(const Report& report, const std::string& summary,
                        Progress& progress) const {
  progress.clear();
  int status = status_of(report);
  if (!is_quiet_) status = print_summary(summary, status);
  print_notices(report.notices, is_verbose_);
  return status;
}

int MeshCommand::run() const {
  catch_signals();
  Settings settings = named_;
  settings.insert(settings.end(), set_.begin(), set_.end());
  Progress progress(!is_quiet_ && is_terminal(),
                    is_dry_run_ ? std::span<const StageWeight>(kControlStages) : kMeshStages);
  try {
    const std::string output = is_dry_run_ ? std::string() : output_;
    check_paths(input_, output, report_);
    MeshRun run;
    run.read(input_, scheme_, settings, progress);
    run.check_outputs(output, report_);
    if (is_dry_run_) {
      Report report = run.estimate(input_, progress);
      run.write(report, report_);
      return finish(report, estimate_text(report, text_style(is_verbose_)), progress);
    }
    MeshResult result = run.mesh(input_, progress);
    progress.progress("write", 0, 1);
    run.write(result, output_, report_);
    return finish(result.report, to_text(result.report, text_style(is_verbose_)), progress);
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
