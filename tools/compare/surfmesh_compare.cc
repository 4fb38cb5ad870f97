// SPDX-License-Identifier: BSD-3-Clause
// Compares surfmesh with the meshers that people use today, as far as they are installed: the same
// metric, the same judge, in turn, in one run. Run by tools/compare.sh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/cage_comparison.hh"
#include "compare/chart.hh"
#include "compare/plane_comparison.hh"
#include "compare/remesh_comparison.hh"
#include "compare/remesh_text.hh"
#include "compare/report_text.hh"
#include "compare/run_process.hh"
#include "compare/triangle_file.hh"
#include "exit_status.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh::compare {
namespace {

struct Arguments {
  std::filesystem::path output = "out/compare";
  Settings settings;
  std::set<std::string> parts;  ///< of the comparison; all if it is empty

  bool has(const char* part) const { return parts.empty() || parts.count(part) > 0; }
};

constexpr const char *kPlane = "plane", *kCages = "cages", *kRemeshing = "remeshing";

constexpr int kMostRounds = 99;

void add_to(CLI::App& app, Arguments& arguments) {
  Settings& settings = arguments.settings;
  app.add_option("-o,--output", arguments.output, "directory of the results")
      ->capture_default_str();
  app.add_option("--rounds", settings.rounds, "runs of each tool")
      ->check(CLI::Range(1, kMostRounds))
      ->capture_default_str();
  app.add_flag("--quick", settings.is_quick, "leave out what takes long");
  app.add_option("--only", arguments.parts, "parts of the comparison, instead of all")
      ->check(CLI::IsMember({kPlane, kCages, kRemeshing}));
  app.add_option("--time-limit", settings.time_limit, "seconds after which a run is stopped")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--source", settings.source, "directory of the repository")->required();
  app.add_option("--program", settings.surfmesh, "the program surfmesh")->required();
}

/// "0.1.0" of "surfmesh 0.1.0".
std::string surfmesh_version(const Settings& settings) {
  constexpr double kTimeLimit = 20;
  const ProcessRun run = run_process({settings.surfmesh, "--version"}, settings.work, kTimeLimit);
  if (!failure_of(run).empty()) {
    throw Error(ErrorCode::Io, fmt::format("{} cannot be run", settings.surfmesh.string()));
  }
  const std::size_t blank = run.log.find(' ');
  const std::size_t begin = blank == run.log.npos ? 0 : blank + 1;
  return run.log.substr(begin, run.log.find('\n', begin) - begin);
}

void make_directories(Arguments& arguments) {
  std::error_code error;
  std::filesystem::create_directories(arguments.output / "work", error);
  if (error) {
    throw Error(ErrorCode::Io, fmt::format("cannot make the directory {}: {}",
                                           (arguments.output / "work").string(), error.message()));
  }
  Settings& settings = arguments.settings;
  settings.work = std::filesystem::absolute(arguments.output / "work");
  settings.source = std::filesystem::absolute(settings.source);
  settings.surfmesh = std::filesystem::absolute(settings.surfmesh);
}

void write_results(const Comparison& comparison, const std::filesystem::path& output) {
  write_file(output / "compare.md", markdown(comparison));
  // Names of files need not be UTF-8: what is not becomes a replacement character.
  const std::string text =
      to_json(comparison).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
      "\n";
  write_file(output / "compare.json", text);
  write_file(output / "compare_speed.svg", speed_chart(comparison.cases));
  write_file(output / "compare_quality.svg", quality_chart(comparison.cases));
}

void tell_peers(const Comparison& comparison) {
  bool is_any = false;
  for (const Peer& peer : comparison.peers) {
    is_any = is_any || !peer.program.empty();
    fmt::print(stderr, "{}: {}\n", peer.name,
               peer.program.empty() ? "not found" : peer.version + ", " + peer.program.string());
  }
  if (!is_any) {
    fmt::print(stderr,
               "no other mesher was found in PATH: there is nothing to compare with, only "
               "surfmesh is run\n");
  }
}

void compare_cases(const Arguments& arguments, Comparison& comparison) {
  const auto add = [&](CaseResult result) {
    fmt::print("{}: {}\n\n{}\n", result.name, result.about, case_table(result));
    comparison.cases.push_back(std::move(result));
  };
  const Settings& settings = arguments.settings;
  if (arguments.has(kPlane)) {
    for (const PlaneCase& plane : plane_cases(settings.is_quick)) {
      add(compare_plane(plane, comparison.peers, settings));
    }
  }
  if (!arguments.has(kCages)) return;
  for (const std::string& cage : cage_names()) {
    add(compare_cage(cage, comparison.peers, settings));
  }
}

void compare_remeshings(const Arguments& arguments, Comparison& comparison) {
  const Settings& settings = arguments.settings;
  for (const RemeshTruth& truth : remesh_truths(settings)) {
    const RemeshJudge judge(truth.file);
    for (const RemeshInput& input : remesh_inputs(settings.is_quick)) {
      const RemeshResult& result = comparison.remeshing.emplace_back(
          compare_remeshing(truth, judge, input, comparison.peers, settings));
      fmt::print("{}: {}\n\n{}\n", result.name, result.about, remesh_table(result));
      write_results(comparison, arguments.output);  // it is a long way to the end
    }
  }
}

void run(Arguments arguments) {
  make_directories(arguments);
  Settings& settings = arguments.settings;
  settings.tell = [](const std::string& text) { fmt::print(stderr, "{}\n", text); };
  Comparison comparison;
  comparison.machine = this_machine();
  comparison.surfmesh_version = surfmesh_version(settings);
  comparison.peers = find_peers(settings.work);
  comparison.rounds = settings.rounds;
  comparison.time_limit = settings.time_limit;
  write_results(comparison, arguments.output);  // an error here should not come after an hour
  tell_peers(comparison);
  compare_cases(arguments, comparison);
  if (arguments.has(kRemeshing)) compare_remeshings(arguments, comparison);
  comparison.machine.load_after = load_now();
  write_results(comparison, arguments.output);
  fmt::print("Results lie in {}\n", std::filesystem::absolute(arguments.output).string());
}

}  // namespace
}  // namespace surfmesh::compare

int main(int argc, char** argv) {
  using namespace surfmesh::compare;
  Arguments arguments;
  CLI::App app("Compare surfmesh with other meshers that are installed.");
  add_to(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? surfmesh::kDone : surfmesh::kWrongUsage;
  }
  try {
    run(arguments);
    return surfmesh::kDone;
  } catch (const std::exception& error) {
    fmt::print(stderr, "surfmesh_compare: error: {}\n", error.what());
    return surfmesh::kFailed;
  }
}
