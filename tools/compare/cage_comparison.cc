// SPDX-License-Identifier: BSD-3-Clause
#include "compare/cage_comparison.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/tool_runs.hh"
#include "compare/triangle_file.hh"
#include "surfmesh/io/output_file.hh"
#include "surfmesh/pipeline/load_model.hh"

namespace surfmesh::compare {
namespace {

/// Runs that seek the option of a peer. The distance is nearly a power of it, so that few do.
constexpr int kTrials = 4;

/// Share of the wish that the search aims at: below, as it may not be exceeded.
constexpr double kAim = 0.96;

/// The setting changes by this factor at most between two runs.
constexpr double kGreatestStep = 2;

/// A distance above the wish that is more than this share of the best so far gains nothing.
constexpr double kStuck = 0.8;

/// Seconds by the clock of one run of the search.
constexpr double kTrialTimeLimit = 30;

constexpr const char* kNotReached = "the sag was not reached with any size that was tried";

/// A peer whose sag follows from one number.
struct SagTask {
  std::function<ToolTask(double setting)> at;
  double setting;  ///< to begin with
  double power;    ///< of the setting, that the distance follows
};

/// A cage with what the runs need of it.
struct Cage {
  std::string name;
  std::filesystem::path file;
  double diagonal;
};

std::string percent(double share) { return fmt::format("{}%", 100 * share); }

SagTask mmgs_task(const Peer& peer, const Cage& cage) {
  const auto at = [peer, cage](double distance) {
    const std::string output = cage.name + ".mmgs.mesh";
    return ToolTask{peer.name,
                    {peer.program, "-in", cage.name + ".dense.mesh", "-out", output, "-hausd",
                     fmt::format("{:.4g}", distance), "-v", "1"},
                    output};
  };
  return {at, kWantedSag * cage.diagonal, 1};
}

/// Sizes come from curvature alone: so many elements to a full turn.
SagTask gmsh_task(const Peer& peer, const Cage& cage) {
  const auto at = [peer, cage](double elements) {
    const std::string output = cage.name + ".gmsh.msh", count = fmt::format("{:.0f}", elements);
    ToolTask task{
        peer.name,
        {peer.program, "-2", cage.name + ".geo", "-setnumber", "Mesh.MeshSizeFromCurvature", count,
         "-setnumber", "Mesh.MinimumElementsPerTwoPi", count, "-algo", "front2d", "-nt", "1",
         "-format", "msh2", "-o", output},
        output};
    task.told_seconds = [](const ProcessRun& run) { return told_seconds(PeerKind::Gmsh, run.log); };
    return task;
  };
  constexpr double kElements = 40;
  return {at, kElements, -2};
}

/// The judge reads no .msh and no .mesh files.
std::filesystem::path as_obj(const Settings& settings, const std::filesystem::path& output) {
  std::filesystem::path path = settings.work / output;
  if (path.extension() == ".obj") return path;
  const TriangleMesh mesh = read_triangles(path);
  write_obj(mesh, path.replace_extension(".obj"));
  return path;
}

void judge(const Settings& settings, const Cage& cage, const ToolTask& task, ToolResult& result) {
  if (!result.failure.empty()) return;
  try {
    const auto mesh = as_obj(settings, task.output);
    const ProcessRun run =
        run_process({settings.surfmesh, "check", mesh, "--model", cage.file, "--json"},
                    settings.work, settings.time_limit);
    set_from_check(run.log.substr(std::min(run.log.find('{'), run.log.size())), cage.diagonal,
                   result);
  } catch (const std::exception& error) {
    result.failure = fmt::format("its mesh cannot be judged: {}", error.what());
  }
}

/// One run of the search.
struct Trial {
  ToolTask task;
  double distance;  ///< as a share of the diagonal; infinite if there is no mesh
};

Trial try_once(const Settings& settings, const Cage& cage, const ToolTask& task) {
  Settings shorter = settings;
  shorter.time_limit = std::min(settings.time_limit, kTrialTimeLimit);
  ProcessRun run;
  ToolResult result;
  result.failure = run_once(shorter, task, run);
  judge(shorter, cage, task, result);
  constexpr double kNever = std::numeric_limits<double>::infinity();
  return {task, result.failure.empty() ? result.distance : kNever};
}

/// True for the greater distance within the wish, otherwise for the smaller one.
bool is_better(double distance, double than) {
  if (distance <= kWantedSag && than <= kWantedSag) return distance > than;
  return distance < than;
}

/// The task whose distance is just within the wish or, if none is, that with the least distance.
///
/// Ends early where a finer mesh is no nearer: of some surfaces a tool loses the creases.
ToolTask seek(const Settings& settings, const Cage& cage, const SagTask& sag) {
  double setting = sag.setting;
  Trial best = {sag.at(setting), std::numeric_limits<double>::infinity()};
  for (int i = 0; i < kTrials; ++i) {
    settings.tell(fmt::format("{}: {} with {:.4g}", cage.name, best.task.tool, setting));
    const Trial trial = try_once(settings, cage, sag.at(setting));
    settings.tell(fmt::format("  distance {:.4f} %", 100 * trial.distance));
    if (!std::isfinite(trial.distance) || !(trial.distance > 0)) break;
    const bool is_stuck = trial.distance > kWantedSag && trial.distance > kStuck * best.distance;
    if (is_better(trial.distance, best.distance)) best = trial;
    const bool is_met = best.distance <= kWantedSag && best.distance >= kAim * kAim * kWantedSag;
    if (is_stuck || is_met) break;
    const double factor = std::pow(kAim * kWantedSag / trial.distance, 1 / sag.power);
    setting *= std::clamp(factor, 1 / kGreatestStep, kGreatestStep);
  }
  return best.task;
}

/// Files of a mesh of the cage that is far finer than what is asked for: .obj, .stl and .mesh.
void write_dense(const Settings& settings, const Cage& cage) {
  const std::string name = cage.name + ".dense";
  constexpr double kDenseSag = 0.05 * kWantedSag, kShortest = 0.1 * kWantedSag;
  for (const char* ending : {".stl", ".obj"}) {
    const ToolTask task = surfmesh_task(
        settings, cage.file, name + ending,
        {"--sag", percent(kDenseSag), "--hmin", percent(kShortest), "--stretch", "1"});
    ProcessRun run;
    const std::string failure = run_once(settings, task, run);
    if (!failure.empty()) settings.tell(fmt::format("{}: {}", name, failure));
  }
  if (!std::filesystem::exists(settings.work / (name + ".obj"))) return;
  write_medit(read_triangles(settings.work / (name + ".obj")), settings.work / (name + ".mesh"));
  write_file(settings.work / (cage.name + ".geo"),
             fmt::format("Merge \"{}.stl\";\nClassifySurfaces{{40*Pi/180, 1, 1, Pi}};\n"
                         "CreateGeometry;\nMesh.MeshSizeExtendFromBoundary = 0;\n"
                         "Mesh.MeshSizeFromPoints = 0;\n",
                         name));
}

std::vector<SagTask> peer_tasks(const std::vector<Peer>& peers, const Cage& cage) {
  std::vector<SagTask> tasks;
  for (const Peer& peer : peers) {
    if (peer.program.empty()) continue;
    if (peer.kind == PeerKind::Mmgs) tasks.push_back(mmgs_task(peer, cage));
    if (peer.kind == PeerKind::Gmsh) tasks.push_back(gmsh_task(peer, cage));
  }
  return tasks;
}

std::string fault_names(const nlohmann::json& faults) {
  std::string names;
  for (const auto& fault : faults) {
    const std::string name = fault.is_string() ? fault.get<std::string>() : fault.value("kind", "");
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

}  // namespace

std::vector<std::string> cage_names() { return {"knob", "torus", "vault"}; }

void set_from_check(const std::string& json_text, double diagonal, ToolResult& result) {
  const auto json = nlohmann::json::parse(json_text, nullptr, false);
  try {
    result.mesh.triangles = json.at("counts").at("triangles").get<std::size_t>();
    result.mesh.least_quality = json.at("shape").at("min").get<double>();
    result.mesh.mean_quality = json.at("shape").at("mean").get<double>();
    result.distance = json.at("fit").at("distance").at("max").get<double>() / diagonal;
    result.remark = fault_names(json.at("faults"));
    if (result.distance > kWantedSag) {
      result.remark += (result.remark.empty() ? "" : "; ") + std::string(kNotReached);
    }
  } catch (const nlohmann::json::exception&) {
    result.failure = "its mesh cannot be judged: surfmesh check tells no distance";
  }
}

CaseResult compare_cage(const std::string& name, const std::vector<Peer>& peers,
                        const Settings& settings) {
  const auto file = settings.source / "models" / (name + ".obj");
  const Cage cage{name, file, load_model(file).model.diagonal};
  std::vector<ToolTask> tasks = {
      surfmesh_task(settings, file, name + ".surfmesh.obj", {"--sag", percent(kWantedSag)})};
  const std::vector<SagTask> of_peers = peer_tasks(peers, cage);
  if (!of_peers.empty()) write_dense(settings, cage);
  for (const SagTask& sag : of_peers) tasks.push_back(seek(settings, cage, sag));
  CaseResult result{name, fmt::format("models/{}.obj with a sag of {}", name, percent(kWantedSag)),
                    true, run_in_turn(settings, name, tasks)};
  for (std::size_t i = 0; i < tasks.size(); ++i) judge(settings, cage, tasks[i], result.tools[i]);
  return result;
}

}  // namespace surfmesh::compare
