// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_command.hh"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <new>
#include <vector>

#include "mesh_in_pieces.hh"
#include "mesh_input.hh"
#include "mpi_launcher.hh"
#include "output_paths.hh"
#include "outputs.hh"
#include "progress.hh"
#include "standard_output.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/exchange/serial_exchange.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// Share of the length of an edge by which an end may move in a file without a word.
constexpr double kToldRounding = 1e-3;

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

/// Each of several processes would make the whole mesh.
void tell_if_started_by_mpirun() {
  if (processes_by_mpirun() < 2 || rank_by_mpirun() != 0) return;
  tell(
      fmt::format("surfmesh: warning: mpirun has started {} processes, of which each makes the "
                  "whole mesh: surfmesh-mpi shares the work among them\n",
                  processes_by_mpirun()));
}

/// One run of the command.
class MeshRun {
 public:
  void read(const MeshArguments& arguments, Progress& progress) {
    input_.read(arguments, progress);
    const std::string output = arguments.is_dry_run ? std::string() : arguments.output;
    input_.check_not_replaced(std::array{output, arguments.report});
  }

  /// Made where it is returned to: a mesh cannot be moved, and a copy takes time.
  MeshResult mesh(const std::string& path, Progress& progress) const {
    const ModelInput& input = input_.input();
    MeshResult result = at_input(
        path, [&] { return mesh_model(input.model, input.sources, input.options, &progress); });
    input_.describe(path, result.report);
    throw_if_signalled();
    return result;
  }

  Report estimate(const MeshArguments& arguments, Progress& progress) const {
    const ModelInput& input = input_.input();
    Report report = at_input(arguments.input, [&] {
      if (arguments.ranks == 0) {
        return estimate_mesh(input.model, input.sources, input.options, &progress);
      }
      return estimate_pieces(input.model, input.sources, input.options, pieces_options(arguments),
                             arguments.ranks, &progress);
    });
    input_.describe(arguments.input, report);
    throw_if_signalled();
    return report;
  }

  /// Write the report of an estimate.
  void write(Report& report, const std::string& path) const {
    report.wall_seconds = input_.seconds_so_far();
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
    result.report.wall_seconds = input_.seconds_so_far();
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
      check_not_overwritten(input_.input().files, *beside);
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

  MeshInput input_;
};

}  // namespace

void print_notices(const Notices& notices, Verbosity verbosity) {
  const auto print_lines = [](const Notices& some) {
    for (const std::string& line : lines_of(some)) tell(fmt::format("surfmesh: {}\n", line));
  };
  Notices told = notices;
  if (verbosity.is_quiet) {
    std::erase_if(told, [](const Notice& a) { return a.severity == Severity::Information; });
  }
  if (!verbosity.is_verbose) return print_lines(told);
  for (const Notice& notice : told) print_lines({notice});
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

/// Print what the run has made. Returns the exit status.
int MeshCommand::finish(const Report& report, const std::string& summary,
                        Progress& progress) const {
  progress.clear();
  int status = status_of(report);
  if (!arguments_.is_quiet) status = print_summary(summary, status);
  print_notices(report.notices, arguments_.verbosity());
  return status;
}

int MeshCommand::run() const {
  if (!arguments_.pieces.empty()) {
    SerialExchange exchange;
    return mesh_in_pieces(arguments_, exchange);
  }
  tell_if_started_by_mpirun();
  catch_signals();
  const bool is_dry_run = arguments_.is_dry_run;
  const std::string& input = arguments_.input;
  Progress progress(!arguments_.is_quiet && is_terminal(),
                    is_dry_run ? std::span<const StageWeight>(kControlStages) : kMeshStages);
  try {
    check_paths(input, is_dry_run ? std::string() : arguments_.output, arguments_.report);
    MeshRun run;
    run.read(arguments_, progress);
    const TextStyle style = text_style(arguments_.is_verbose);
    if (is_dry_run) {
      Report report = run.estimate(arguments_, progress);
      run.write(report, arguments_.report);
      return finish(report, estimate_text(report, style), progress);
    }
    MeshResult result = run.mesh(input, progress);
    progress.progress("write", 0, 1);
    run.write(result, arguments_.output, arguments_.report);
    return finish(result.report, to_text(result.report, style), progress);
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
