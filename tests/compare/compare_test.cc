// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/background.hh"
#include "compare/cage_comparison.hh"
#include "compare/chart.hh"
#include "compare/comparison.hh"
#include "compare/peers.hh"
#include "compare/plane_comparison.hh"
#include "compare/plane_judge.hh"
#include "compare/report_text.hh"
#include "compare/run_process.hh"
#include "compare/triangle_file.hh"
#include "pictures/machine.hh"
#include "pictures/median.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

using namespace compare;

const std::string kMshHead = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";

/// A file with a point, a line and a triangle; node numbers have a gap.
const std::string kMsh = kMshHead +
                         "$Nodes\n3\n1 0 0 0\n2 1 0 0\n7 0 1 0.5\n$EndNodes\n"
                         "$Elements\n3\n1 15 2 0 1 1\n2 1 2 0 1 1 2\n3 2 2 0 1 1 2 7\n"
                         "$EndElements\n";

const std::string kMedit =
    "MeshVersionFormatted 1\nDimension\n2\nIdentifier\n\"no Vertices\"\n# none\nVertices\n3\n"
    "0 0 1\n1 0 1\n0 1 1\nEdges\n1\n1 2 4\nTriangles\n1\n1 2 3 0\nEnd\n";

/// What a reader says of a text that is no legal input.
template <class Reader>
std::string fault_of(Reader reader, const std::string& text) {
  const std::string error = error_of([&] { reader(text, "file"); });
  const std::string kind = std::string(name(ErrorCode::InvalidInput)) + ": ";
  return error.starts_with(kind) ? error.substr(kind.size()) : error;
}

TEST(ReadMsh, TakesTheTriangles) {
  const TriangleMesh mesh = read_msh(kMsh, "file");
  ASSERT_EQ(mesh.points.size(), 3u);
  EXPECT_EQ(mesh.points[2], Vec3(0, 1, 0.5));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], (std::array<int, 3>{0, 1, 2}));
}

TEST(ReadMsh, NamesTheLineOfAnError) {
  EXPECT_EQ(fault_of(read_msh, "$MeshFormat\n4.1 0 8\n"),
            "file:2: only ASCII files of format 2 are read");
  EXPECT_EQ(fault_of(read_msh, kMshHead + "$Nodes\n1\n1 0 zero 0\n"),
            "file:6: \"zero\" is no number");
  EXPECT_EQ(fault_of(read_msh, kMshHead + "$Nodes\n1\n1 0 nan 0\n"),
            "file:6: \"nan\" is no number");
  EXPECT_EQ(fault_of(read_msh, kMshHead + "$Elements\n1\n1 3 0 1 2 3 4\n"),
            "file:6: element type 3 is no point, line or triangle");
  EXPECT_EQ(fault_of(read_msh, kMshHead + "$Elements\n1\n1 15 0 5\n"),
            "file:6: there is no node 5");
  EXPECT_EQ(fault_of(read_msh, kMshHead + "$Nodes\n-1\n"),
            "file:5: -1 is no count of what follows");
}

TEST(ReadMsh, RefusesATruncatedFile) {
  EXPECT_EQ(fault_of(read_msh, kMshHead + "$Nodes\n2\n1 0 0 0"),
            "file:6: the end of the file is no integer");
  EXPECT_EQ(fault_of(read_msh, kMshHead), "file:4: the file has no triangles");
}

TEST(ReadMedit, TakesTheTriangles) {
  const TriangleMesh mesh = read_medit(kMedit, "file");
  ASSERT_EQ(mesh.points.size(), 3u);
  EXPECT_EQ(mesh.points[1], Vec3(1, 0, 0));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], (std::array<int, 3>{0, 1, 2}));
}

TEST(ReadMedit, NamesTheLineOfAnError) {
  EXPECT_EQ(fault_of(read_medit, "Dimension 4\n"), "file:1: the dimension is neither 2 nor 3");
  EXPECT_EQ(fault_of(read_medit, "Dimension 2\nVertices\n1\n0 x 1\n"),
            "file:4: \"x\" is no number");
  EXPECT_EQ(fault_of(read_medit, "Dimension 2\nTriangles\n1\n1 2 3 0\n"),
            "file:4: there is no vertex 1");
  EXPECT_EQ(fault_of(read_medit, "Vertices 99999\n"), "file:1: 99999 is no count of what follows");
  EXPECT_EQ(fault_of(read_medit, ""), "file:1: the file has no triangles");
}

TEST(TriangleFiles, AreReadAsTheyWereWritten) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0.1}, {0, 1, 1.0 / 3}}, {{0, 1, 2}}};
  const auto directory = std::filesystem::path(::testing::TempDir());
  write_obj(mesh, directory / "compare_test.obj");
  write_medit(mesh, directory / "compare_test.mesh");
  for (const char* name : {"compare_test.obj", "compare_test.mesh"}) {
    const TriangleMesh read = read_triangles(directory / name);
    EXPECT_EQ(read.points, mesh.points) << name;
    EXPECT_EQ(read.triangles, mesh.triangles) << name;
    std::filesystem::remove(directory / name);
  }
}

/// Two halves of a unit square.
const TriangleMesh kSquare{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};

TEST(PlaneJudge, MeasuresEachEdgeOnce) {
  const Judgement j = judge_plane(kSquare, [](Uv) { return Metric{1, 0, 1}; });
  const double diagonal = std::sqrt(2.0), mean = (4 + diagonal) / 5;
  EXPECT_EQ(j.triangles, 2u);
  EXPECT_NEAR(j.mean, mean, 1e-14);
  EXPECT_NEAR(j.stddev, (diagonal - 1) * 0.4, 1e-14);  // a fifth of the edges is so much longer
  EXPECT_NEAR(j.area, 1, 1e-14);
}

TEST(PlaneJudge, CountsUnitEdges) {
  const Judgement j = judge_plane(kSquare, [](Uv) { return Metric{1.21, 0, 1.21}; });
  EXPECT_DOUBLE_EQ(j.unit_fraction, 0.8);
}

TEST(PlaneJudge, IntegratesAlongTheEdge) {
  // Sizes 1 + u: the length from 0 to 1 is ln 2.
  const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}};
  const Judgement j = judge_plane(flat, [](Uv uv) { return Metric{std::pow(1 + uv.u, -2), 0, 1}; });
  EXPECT_NEAR(j.mean, 2 * std::log(2.0) / 3, 1e-6);
}

TEST(PlaneJudge, SeesTheUnitTriangleInItsMetric) {
  const TriangleMesh wide{{{0, 0, 0}, {2, 0, 0}, {1, std::sqrt(0.75), 0}}, {{0, 1, 2}}};
  const Judgement j = judge_plane(wide, [](Uv) { return Metric{0.25, 0, 1}; });
  EXPECT_NEAR(j.least_quality, 1, 1e-14);
  EXPECT_NEAR(j.mean, 1, 1e-14);
}

TEST(PlaneJudge, TurnsBackAWholeMeshButNotOneTriangle) {
  TriangleMesh mesh = kSquare;
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  const auto unit = [](Uv) { return Metric{1, 0, 1}; };
  EXPECT_GT(judge_plane(mesh, unit).least_quality, 0);
  mesh.points[3] = {0.9, 0.5, 0};
  EXPECT_LT(judge_plane(mesh, unit).least_quality, 0);
}

TEST(Median, IsTheMiddleValue) {
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({9, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 9}), 3);
}

TEST(Ratio, IsTakenRoundByRound) {
  EXPECT_EQ(ratio({2, 9, 8}, {1, 3, 2}), (Spread{3, 2, 4}));
  EXPECT_EQ(ratio({2, 9}, {1}), (Spread{2, 2, 2}));
  EXPECT_EQ(ratio({}, {1}), std::nullopt);
  EXPECT_EQ(ratio({1}, {0}), std::nullopt);
}

TEST(Speed, IsUnknownWithoutSeconds) {
  EXPECT_EQ(speed(100, {2, 4, 9}), 25);
  EXPECT_EQ(speed(100, {}), std::nullopt);
  EXPECT_EQ(speed(100, {0}), std::nullopt);
}

TEST(ToldSeconds, AreThoseOfTheToolsOutput) {
  EXPECT_EQ(told_seconds(PeerKind::Gmsh,
                         "Info : Done meshing 1D (Wall 1s, CPU 2s)\n"
                         "Info : Done meshing 2D (Wall 4.03s, CPU 3.89s)\n"),
            3.89);
  EXPECT_EQ(told_seconds(PeerKind::Bamg,
                         " Cpu time for meshing          : 0.52s  Nb Vertices/s = 39055.8\n"
                         " Cpu time for meshing with io  : 1.39s  Nb Vertices/s = 1.461e+04\n"),
            0.52);
  EXPECT_EQ(told_seconds(PeerKind::Gmsh, "nothing"), std::nullopt);
  EXPECT_EQ(told_seconds(PeerKind::Mmgs, "1 s"), std::nullopt);
}

TEST(FindProgram, LooksInEachDirectory) {
  EXPECT_EQ(find_program({"no_such_tool", "sh"}, "/no/such/directory::/bin"), "/bin/sh");
  EXPECT_EQ(find_program({"no_such_tool"}, "/bin"), "");
  EXPECT_EQ(find_program({"sh"}, ""), "");
}

ProcessRun run_shell(const std::string& script, double time_limit) {
  const TestFolder folder;
  return run_process({"sh", "-c", script}, folder.path(), time_limit);
}

TEST(RunProcess, TellsHowItEnded) {
  EXPECT_EQ(run_shell("echo out; echo err >&2", 20).log, "out\nerr\n");
  EXPECT_EQ(failure_of(run_shell("exit 0", 20)), "");
  EXPECT_EQ(failure_of(run_shell("exit 5", 20)), "failed (exit status 5)");
  EXPECT_EQ(failure_of(run_shell("kill -SEGV $$", 20)), "crashed (signal 11)");
  const TestFolder folder;
  EXPECT_EQ(failure_of(run_process({"/no/such/tool"}, folder.path(), 20)),
            "failed (exit status 127)");
}

TEST(RunProcess, EndsAtTheTimeLimit) {
  EXPECT_EQ(failure_of(run_shell("sleep 100", 0.1)), "stopped at the time limit");
}

CaseResult example() {
  CaseResult result{"corners", "a square", false, {}};
  result.tools.resize(3);
  result.tools[0].tool = "surfmesh";
  result.tools[0].mesh = {7570, 0.99, 0.051, 0.9998, 0.85, 0.992, 1};
  result.tools[0].processor_seconds = {0.03, 0.03};
  result.tools[0].meshing_seconds = {0.02};
  result.tools[1].tool = "Gmsh";
  result.tools[1].mesh = {7772, 1, 0.079, 0.9982, 0.78, 0.987, 1};
  result.tools[1].processor_seconds = {0.3, 0.6};
  result.tools[2].tool = "BAMG";
  result.tools[2].failure = "crashed (signal 11)";
  return result;
}

TEST(CaseTable, HasARowForEachTool) {
  EXPECT_EQ(case_table(example()),
            "| tool | triangles | mean length | σ | unit edges | Q least / mean | triangles/s, "
            "meshing | triangles/s, process | seconds | time to surfmesh |\n"
            "|---|---|---|---|---|---|---|---|---|---|\n"
            "| surfmesh | 7,570 | 0.990 | 0.051 | 99.98 % | 0.85 / 0.992 | 379,000 | 252,000 | "
            "0.03 | 1.00 [1.00, 1.00] |\n"
            "| Gmsh | 7,772 | 1.000 | 0.079 | 99.82 % | 0.78 / 0.987 | – | 17,300 | 0.45 | 15.00 "
            "[10.00, 20.00] |\n"
            "| BAMG | crashed (signal 11) | – | – | – | – | – | – | – | – |\n");
}

TEST(CaseTable, TellsTheDistanceOfCages) {
  CaseResult result{"knob", "a cage", true, {}};
  result.tools.resize(1);
  result.tools[0].tool = "surfmesh";
  set_from_check(R"({"counts": {"triangles": 2848}, "shape": {"min": 0.43, "mean": 0.918},
                     "fit": {"distance": {"max": 0.0045}}, "faults": []})",
                 5, result.tools[0]);
  EXPECT_NE(case_table(result).find("| surfmesh | 2,848 | 0.0900 % | 0.43 / 0.918 |"),
            std::string::npos)
      << case_table(result);
}

TEST(SetFromCheck, RemarksASagThatWasNotReached) {
  ToolResult result;
  set_from_check(R"({"counts": {"triangles": 9}, "shape": {"min": 0.4, "mean": 0.9},
                     "fit": {"distance": {"max": 0.02}}, "faults": []})",
                 1, result);
  EXPECT_EQ(result.remark, "the sag was not reached with any size that was tried");
}

TEST(SetFromCheck, FailsWithoutADistance) {
  ToolResult result;
  set_from_check("no JSON", 1, result);
  EXPECT_EQ(result.failure, "its mesh cannot be judged: surfmesh check tells no distance");
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Charts, HaveABarForEachTool) {
  const std::string title = bar_chart("none", {});
  for (const bool is_speed : {true, false}) {
    const std::string chart = is_speed ? speed_chart({example()}) : quality_chart({example()});
    // Of the whole process, and of meshing alone.
    EXPECT_EQ(count_of(chart, "<rect") - count_of(title, "<rect"), is_speed ? 6u : 3u);
    EXPECT_NE(chart.find(">Gmsh<"), std::string::npos);
    EXPECT_NE(chart.find("crashed (signal 11)"), std::string::npos);
  }
}

TEST(Markdown, NamesMachineToolsAndCommands) {
  Comparison comparison;
  comparison.machine.processor = "Some Processor";
  comparison.peers = {{PeerKind::Gmsh, "Gmsh", "/usr/bin/gmsh", "4.8.4"},
                      {PeerKind::Mmgs, "Mmgs", "", ""}};
  comparison.cases = {example()};
  comparison.cases[0].tools[1].command = "gmsh -2 x.geo";
  const std::string text = markdown(comparison);
  for (const char* part :
       {"Some Processor", "Gmsh 4.8.4", "Not found: Mmgs.", "    gmsh -2 x.geo\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(to_json(comparison).at("cases").at(0).at("tools").size(), 3u);
}

TEST(ProcessorName, IsTheFirstInTheFile) {
  EXPECT_EQ(processor_name("vendor_id : x\nmodel name\t: Some CPU @ 2 GHz\nmodel name : b\n"),
            "Some CPU @ 2 GHz");
  EXPECT_EQ(processor_name(""), "unknown processor");
}

TEST(PlaneCases, AreModelsOfOnePatch) {
  for (const PlaneCase& plane : plane_cases(false)) {
    const auto file =
        std::filesystem::path(SURFMESH_SOURCE_DIR) / "tools/compare/cases" / (plane.name + ".json");
    const ExactMetric metric(file);
    const Metric m = metric.at({metric.domain().u0, metric.domain().v0});
    EXPECT_GT(m.m11, 0) << plane.name;
    if (plane.is_isotropic) {
      EXPECT_NEAR(m.m12, 0, 1e-9 * m.m11) << plane.name;
    }
  }
  EXPECT_LT(plane_cases(true).size(), plane_cases(false).size());
}

TEST(Background, IsReadAsAMeshOfTheDomain) {
  const auto file = std::filesystem::path(SURFMESH_SOURCE_DIR) / "tools/compare/cases/wave.json";
  const Background grid = sample_background(ExactMetric(file), 4, false);
  ASSERT_EQ(grid.metrics.size(), 25u);
  const auto stem = std::filesystem::path(::testing::TempDir()) / "compare_test_grid";
  write_background(grid, stem);
  write_gmsh_view(grid, stem);
  for (const char* ending : {".mesh", ".msh"}) {
    const TriangleMesh mesh = read_triangles(stem.string() + ending);
    EXPECT_EQ(mesh.triangles.size(), 32u);
    EXPECT_NEAR(judge_plane(mesh, [](Uv) { return Metric{1, 0, 1}; }).area, 144, 1e-9);
  }
  for (const char* ending : {".mesh", ".msh", ".mtr", ".sol"}) {
    std::filesystem::remove(stem.string() + ending);
  }
}

}  // namespace
}  // namespace surfmesh
