// SPDX-License-Identifier: BSD-3-Clause
#include "compare/plane_comparison.hh"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "compare/background.hh"
#include "compare/exact_metric.hh"
#include "compare/plane_judge.hh"
#include "compare/tool_runs.hh"

namespace surfmesh::compare {
namespace {

/// BAMG stops at so many vertices; it reserves the memory at once. The longest case has 500,000.
constexpr const char* kMostBamgVertices = "1500000";

/// Share of the area of the domain by which that of a mesh may differ: files have 12 digits.
constexpr double kSameArea = 1e-8;

ToolTask gmsh_task(const Peer& peer, const PlaneCase& plane) {
  const std::string output = plane.name + ".gmsh.msh";
  // BAMG's algorithm is the one in Gmsh that takes tensors.
  return {peer.name,
          {peer.program, "-2", plane.name + ".geo", "-bgm", plane.name + ".view.msh", "-algo",
           plane.is_isotropic ? "front2d" : "bamg", "-nt", "1", "-format", "msh2", "-o", output},
          output};
}

ToolTask bamg_task(const Peer& peer, const PlaneCase& plane) {
  const std::string grid = plane.name + ".grid", output = plane.name + ".bamg.mesh";
  return {peer.name,
          {peer.program, "-b", grid + ".mesh", "-M", grid + ".mtr", "-o", output, "-nbv",
           kMostBamgVertices, "-noKeepBackVertices", "-v", "4"},
          output};
}

ToolTask mmg_task(const Peer& peer, const PlaneCase& plane) {
  const std::string grid = plane.name + ".grid", output = plane.name + ".mmg2d.mesh";
  return {peer.name,
          {peer.program, "-in", grid + ".mesh", "-sol", grid + ".sol", "-out", output, "-hgrad",
           "-1", "-v", "1"},
          output};
}

/// Nothing for a peer that was not found or does not mesh in a plane.
std::optional<ToolTask> task_of(const Peer& peer, const PlaneCase& plane) {
  const bool is_of_plane =
      peer.kind == PeerKind::Gmsh || peer.kind == PeerKind::Bamg || peer.kind == PeerKind::Mmg2d;
  if (peer.program.empty() || !is_of_plane) return std::nullopt;
  ToolTask task = peer.kind == PeerKind::Gmsh   ? gmsh_task(peer, plane)
                  : peer.kind == PeerKind::Bamg ? bamg_task(peer, plane)
                                                : mmg_task(peer, plane);
  task.told_seconds = [kind = peer.kind](const ProcessRun& run) {
    return told_seconds(kind, run.log);
  };
  return task;
}

void write_inputs(const PlaneCase& plane, const ExactMetric& metric, const Settings& settings) {
  const Background grid = sample_background(metric, plane.cells, plane.is_isotropic);
  write_background(grid, settings.work / (plane.name + ".grid"));
  write_gmsh_view(grid, settings.work / (plane.name + ".view"));
  write_gmsh_square(grid, settings.work / (plane.name + ".geo"));
}

void judge(const ExactMetric& metric, const std::filesystem::path& mesh, ToolResult& result) {
  if (!result.failure.empty()) return;
  try {
    result.mesh = judge_plane(read_triangles(mesh), [&](Uv uv) { return metric.at(uv); });
  } catch (const std::exception& error) {
    result.failure = fmt::format("its mesh cannot be judged: {}", error.what());
    return;
  }
  const Domain domain = metric.domain();
  const double area = (domain.u1 - domain.u0) * (domain.v1 - domain.v0);
  if (std::abs(result.mesh.area - area) > kSameArea * area) {
    result.remark = fmt::format("covers {:.6f} of the domain", result.mesh.area / area);
  }
}

}  // namespace

std::vector<PlaneCase> plane_cases(bool is_quick) {
  std::vector<PlaneCase> cases = {
      {"corners", "a unit square with sizes of 0.005 and 0.05 at its corners", 100, true, false},
      {"wave", "the surface of the paper, sizes from curvature with a stretch up to 5, in (u,v)",
       400, false, false},
      {"corners_fine", "corners with sizes 5.8 times as small", 400, true, false},
      {"corners_finest", "corners with sizes 11.6 times as small, a million triangles", 400, true,
       true}};
  if (is_quick) std::erase_if(cases, [](const PlaneCase& plane) { return plane.is_long; });
  return cases;
}

CaseResult compare_plane(const PlaneCase& plane, const std::vector<Peer>& peers,
                         const Settings& settings) {
  const auto model = settings.source / "tools/compare/cases" / (plane.name + ".json");
  const ExactMetric metric(model);
  std::vector<ToolTask> tasks = {surfmesh_task(settings, model, plane.name + ".surfmesh.obj", {})};
  for (const Peer& peer : peers) {
    if (auto task = task_of(peer, plane)) tasks.push_back(std::move(*task));
  }
  if (tasks.size() > 1) {
    settings.tell(plane.name + ": writing the sizes for the other tools");
    write_inputs(plane, metric, settings);
  }
  CaseResult result{plane.name, plane.about, false, run_in_turn(settings, plane.name, tasks)};
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    judge(metric, settings.work / tasks[i].output, result.tools[i]);
  }
  return result;
}

}  // namespace surfmesh::compare
