// SPDX-License-Identifier: BSD-3-Clause
#include "compare/remesh_comparison.hh"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "compare/tool_runs.hh"
#include "compare/triangle_file.hh"
#include "pictures/median.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh::compare {
namespace {

constexpr std::array kAllSizes = {RemeshSizes::Half, RemeshSizes::Same, RemeshSizes::Fivefold,
                                  RemeshSizes::Curvature};

/// Edges at which faces meet at more degrees are sharp for the other tools: surfmesh begins there.
constexpr const char* kSharpAngle = "40";

/// The distance that Mmgs gets where sizes come from curvature, as a share of the diagonal.
constexpr double kHausdorff = 0.001;

constexpr int kSmooth = 30000;  ///< triangles of a smooth input from which more is expected

/// Lengths of sides to those of the input.
double factor(RemeshSizes sizes) {
  if (sizes == RemeshSizes::Half) return 0.5;
  return sizes == RemeshSizes::Fivefold ? 5 : 1;
}

/// The option by which surfmesh makes an input, with sides of a length as a share of the diagonal.
Command sizes_of_input(const RemeshInput& input, double length) {
  if (!input.is_adaptive) return {"--size", fmt::format("{:.6g}%", 100 * length)};
  constexpr double kCurvature = 12;  // so that the first run is not far off
  return {"--curvature", fmt::format("{:.6g}", kCurvature * length)};
}

/// Writes <name>.off in two runs: the count of the first tells the sizes, as it is inverse to their
/// square.
void make_input(const RemeshTruth& truth, const std::string& name, const RemeshInput& input,
                const Settings& settings) {
  const std::string output = name + ".off";
  double length = 0.02;
  constexpr int kRuns = 2;
  for (int i = 0; i < kRuns; ++i) {
    Command options = sizes_of_input(input, length);
    options.insert(options.end(), {"--surface", "limit"});
    const ToolTask task = surfmesh_task(settings, truth.file, output, options);
    ProcessRun run;
    const std::string failure = run_once(settings, task, run);
    if (!failure.empty()) throw Error(ErrorCode::Io, fmt::format("{}: {}", name, failure));
    const TriangleMesh mesh = read_triangles(settings.work / output);
    length *= std::sqrt(static_cast<double>(mesh.triangles.size()) / input.triangles);
  }
}

/// What the tasks of one group share.
struct Group {
  std::string input;  ///< without its ending
  RemeshSizes sizes;
  double length;    ///< of sides, model units; without a meaning for sizes from curvature
  double diagonal;  ///< of the model
};

ToolTask surfmesh_remesh_task(const Settings& settings, const Group& group, bool is_quads) {
  Command options = {"--surface", "interpolate"};
  if (group.sizes != RemeshSizes::Curvature) {
    options.insert(options.end(), {"--size", fmt::format("{:.6g}", group.length)});
  }
  if (is_quads) options.push_back("--quads");
  // A file without groups: the patches of this surface are not those of the cage.
  const std::string output =
      fmt::format("{}.{}.surfmesh{}.off", group.input, name(group.sizes), is_quads ? ".quads" : "");
  return surfmesh_task(settings, group.input + ".off", output, options);
}

ToolTask mmgs_task(const Peer& peer, const Group& group) {
  const std::string output = fmt::format("{}.{}.mmgs.mesh", group.input, name(group.sizes));
  const bool is_uniform = group.sizes != RemeshSizes::Curvature;
  return {
      peer.name,
      {peer.program, "-in", group.input + ".mesh", "-out", output, is_uniform ? "-hsiz" : "-hausd",
       fmt::format("{:.6g}", is_uniform ? group.length : kHausdorff * group.diagonal), "-ar",
       kSharpAngle, "-v", "1"},
      output};
}

/// A program that is called with input, output, length and angle.
ToolTask wrapper_task(const Peer& peer, const Group& group) {
  const std::string output =
      fmt::format("{}.{}.{}.off", group.input, name(group.sizes), peer.program.filename().string());
  return {peer.name,
          {peer.program, group.input + ".off", output, fmt::format("{:.6g}", group.length),
           kSharpAngle},
          output};
}

/// Nothing for a peer that was not found or does not remesh with these sizes.
std::optional<ToolTask> peer_task(const Peer& peer, const Group& group) {
  if (peer.program.empty()) return std::nullopt;
  if (peer.kind == PeerKind::Mmgs) return mmgs_task(peer, group);
  const bool is_wrapper = peer.kind == PeerKind::Pmp || peer.kind == PeerKind::Cgal;
  if (!is_wrapper || group.sizes == RemeshSizes::Curvature) return std::nullopt;
  return wrapper_task(peer, group);
}

void add_rows(const Settings& settings, const RemeshJudge& judge, const Group& group,
              const std::vector<Peer>& peers, RemeshResult& result) {
  std::vector<ToolTask> tasks = {surfmesh_remesh_task(settings, group, false),
                                 surfmesh_remesh_task(settings, group, true)};
  for (const Peer& peer : peers) {
    if (auto task = peer_task(peer, group)) tasks.push_back(std::move(*task));
  }
  const auto runs = run_in_turn(settings, group.input + ", " + name(group.sizes), tasks);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    RemeshRow row{group.sizes, i == 1, runs[i]};
    try {
      if (row.run.failure.empty()) row.mesh = judge.judge(settings.work / tasks[i].output);
    } catch (const std::exception& error) {
      row.run.failure = fmt::format("its mesh cannot be judged: {}", error.what());
    }
    result.rows.push_back(std::move(row));
  }
}

/// A place of a row, for a sentence.
std::string place(const RemeshRow& row) {
  return fmt::format("{}, {}", name(row.sizes), row.is_quads ? "quads" : "triangles");
}

/// Where triangles are larger than the faces of the input, these may not show in their number.
bool has_wrong_count(const RemeshResult& result, const RemeshRow& row) {
  if (row.sizes != RemeshSizes::Fivefold || row.is_quads) return false;
  constexpr double kFarOff = 0.1;
  const double ideal = ideal_count(result, row.sizes);
  return std::abs(static_cast<double>(row.mesh.faces) - ideal) > kFarOff * ideal;
}

/// What one mesh of surfmesh lacks, whatever others do.
void add_missed_of(const RemeshResult& result, const RemeshRow& row,
                   std::vector<std::string>& missed) {
  const auto miss = [&](const std::string& what) { missed.push_back(place(row) + ": " + what); };
  if (!row.run.failure.empty()) return miss(row.run.failure);
  const double faces = result.input.facets.mean, share = wanted_share(result);
  if (row.mesh.vertices.mean > share * faces) {
    miss(fmt::format("vertices {:.2f} of the input's distance", row.mesh.vertices.mean / faces));
  }
  // An adaptive input has short sides where its surface is curved.
  const bool is_adaptive = result.wanted.is_adaptive;
  if (!is_adaptive && row.sizes == RemeshSizes::Half && row.mesh.facets.mean > 0.5 * faces) {
    miss(fmt::format("faces {:.2f} of the input's distance", row.mesh.facets.mean / faces));
  }
  if (has_wrong_count(result, row)) {
    miss(fmt::format("{} faces, {:.0f} are ideal", row.mesh.faces, ideal_count(result, row.sizes)));
  }
  if (row.mesh.turned > result.input.turned) miss(fmt::format("{} turned", row.mesh.turned));
  if (row.mesh.crossings > result.input.crossings) {
    miss(fmt::format("{} crossings", row.mesh.crossings));
  }
  if (!row.mesh.has_topology_of(result.input)) miss("the topology is not that of the input");
  // Longer sides cut curved creases more; good ones have up to √2 of the length asked for.
  const double cut = std::max(1.0, 2 * factor(row.sizes) * factor(row.sizes));
  if (!is_adaptive && row.sizes != RemeshSizes::Curvature &&
      row.mesh.features > cut * std::max(result.input.features, result.input.facets.max)) {
    miss(fmt::format("features off by {:.3f} % of the diagonal", 100 * row.mesh.features));
  }
}

/// What a mesh of surfmesh lacks beside that of another tool with the same sizes.
void add_missed_beside(const RemeshRow& row, const RemeshRow& peer,
                       std::vector<std::string>& missed) {
  const auto miss = [&](const char* what, double of, double to) {
    missed.push_back(fmt::format("{}: {} {:.3g}, {} of {}", place(row), what, of,
                                 fmt::format("{:.3g}", to), peer.run.tool));
  };
  const RemeshJudgement &mine = row.mesh, &other = peer.mesh;
  // What the tables show as equal is.
  constexpr double kShown = 0.005, kShownMean = 0.0005;
  if (mine.least_quality < other.least_quality - kShown) {
    miss("least quality", mine.least_quality, other.least_quality);
  }
  if (mine.mean_quality < other.mean_quality - kShownMean) {
    miss("mean quality", mine.mean_quality, other.mean_quality);
  }
  if (mine.facets.mean > other.facets.mean) {
    miss("distance in %", 100 * mine.facets.mean, 100 * other.facets.mean);
  }
  const auto time = ratio(row.run.processor_seconds, peer.run.processor_seconds);
  if (time && time->median > 0.5) {
    miss("seconds", median(row.run.processor_seconds), median(peer.run.processor_seconds));
  }
}

}  // namespace

std::vector<RemeshTruth> remesh_truths(const Settings& settings) {
  const auto models = settings.source / "models";
  const auto shared = settings.source.parent_path() / "shared/models";
  std::vector<RemeshTruth> truths = {
      {"torus", models / "torus.obj", true},
      {"cube", models / "cube.obj", true},
      {"barrel", settings.source / "tools/compare/cases/barrel.obj", false},
      {"knob", models / "knob.obj", false}};
  if (!settings.is_quick) {
    truths.insert(truths.end(),
                  {{"spot", shared / "spot_control_mesh.obj", true},
                   {"semi_sharp_cube", shared / "opensubdiv/catmark_cube_creases1.obj", false},
                   {"pawn", shared / "opensubdiv/catmark_pawn.obj", false},
                   {"car", shared / "opensubdiv/catmark_car.obj", false}});
  }
  std::erase_if(truths,
                [](const RemeshTruth& truth) { return !std::filesystem::exists(truth.file); });
  return truths;
}

std::vector<RemeshInput> remesh_inputs(bool is_quick) {
  if (is_quick) return {{2000, false}};
  return {{2000, false}, {8000, false}, {kSmooth, false}, {8000, true}};
}

std::string name(RemeshSizes sizes) {
  switch (sizes) {
    case RemeshSizes::Half:
      return "half";
    case RemeshSizes::Same:
      return "same";
    case RemeshSizes::Fivefold:
      return "fivefold";
    case RemeshSizes::Curvature:
      return "curvature";
  }
  return "";
}

double wanted_share(const RemeshResult& result) {
  return result.is_smooth && result.wanted.triangles >= kSmooth ? 0.25 : 0.5;
}

double ideal_count(const RemeshResult& result, RemeshSizes sizes) {
  if (sizes == RemeshSizes::Curvature) return 0;
  const double length = factor(sizes) * result.input.mean_edge;
  return result.input.area / (std::sqrt(3.0) / 4 * length * length);
}

std::vector<std::string> missed_aims(const RemeshResult& result) {
  std::vector<std::string> missed;
  for (const RemeshRow& row : result.rows) {
    if (row.run.tool != "surfmesh") continue;
    add_missed_of(result, row, missed);
    if (!row.run.failure.empty() || row.is_quads || row.sizes == RemeshSizes::Curvature) continue;
    for (const RemeshRow& peer : result.rows) {
      const bool is_peer = peer.sizes == row.sizes && peer.run.tool != "surfmesh";
      if (is_peer && peer.run.failure.empty()) add_missed_beside(row, peer, missed);
    }
  }
  return missed;
}

RemeshResult compare_remeshing(const RemeshTruth& truth, const RemeshJudge& judge,
                               const RemeshInput& input, const std::vector<Peer>& peers,
                               const Settings& settings) {
  const std::string name =
      fmt::format("{}_{}{}", truth.name, input.triangles, input.is_adaptive ? "_adaptive" : "");
  make_input(truth, name, input, settings);
  write_medit(read_triangles(settings.work / (name + ".off")), settings.work / (name + ".mesh"));
  RemeshResult result{
      name,
      fmt::format("about {} triangles {} on the limit surface of {}", input.triangles,
                  input.is_adaptive ? "by curvature" : "of one size",
                  truth.file.filename().string()),
      truth.is_smooth, input};
  result.input = judge.judge(settings.work / (name + ".off"));
  for (const RemeshSizes sizes : kAllSizes) {
    add_rows(settings, judge,
             {name, sizes, factor(sizes) * result.input.mean_edge, judge.diagonal()}, peers,
             result);
  }
  return result;
}

}  // namespace surfmesh::compare
