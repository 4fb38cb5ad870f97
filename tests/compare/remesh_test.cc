// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "compare/remesh_comparison.hh"
#include "compare/remesh_judge.hh"
#include "compare/remesh_text.hh"
#include "compare/report_text.hh"
#include "compare/triangle_file.hh"
#include "support/folders.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

using namespace compare;
namespace fs = std::filesystem;

const fs::path kTorus = fs::path(SURFMESH_SOURCE_DIR) / "models/torus.obj";

/// A mesh of the torus, in a file of a folder.
class RemeshOfTorus : public ::testing::Test {
 protected:
  RemeshOfTorus() {
    const ModelInput input = load_model(kTorus);
    PipelineOptions options = input.options;
    set_option(options, "size", "8%");
    write_mesh(mesh_model(input.model, input.sources, options).mesh, file());
  }

  fs::path file() const { return folder_ / "torus.off"; }

  RemeshJudgement judged(const TriangleMesh& mesh) const {
    const fs::path changed = folder_ / "changed.obj";
    write_obj(mesh, changed);
    return judge_.judge(changed);
  }

  TestFolder folder_;
  RemeshJudge judge_{kTorus};
};

TEST_F(RemeshOfTorus, HasItsVerticesOnTheSurface) {
  const RemeshJudgement mesh = judge_.judge(file());
  EXPECT_GT(mesh.faces, 100u);
  EXPECT_LT(mesh.vertices.max, 1e-6);
  EXPECT_GT(mesh.facets.mean, 1e-4);
  EXPECT_GT(mesh.facets.max, mesh.facets.mean);
  EXPECT_NEAR(mesh.from_surface.mean / mesh.facets.mean, 1, 0.3);
  EXPECT_EQ(mesh.features, 0);  // it has none
  EXPECT_EQ(mesh.euler, 0);
  EXPECT_EQ(mesh.components, 1u);
  EXPECT_EQ(mesh.boundary_loops, 0u);
  EXPECT_EQ(mesh.crossings, 0u);
  EXPECT_EQ(mesh.turned, 0u);
  EXPECT_EQ(mesh.faults, "");
  EXPECT_NEAR(mesh.mean_edge / judge_.diagonal(), 0.08, 0.01);
}

TEST_F(RemeshOfTorus, SeesHowFarVerticesAreMoved) {
  TriangleMesh mesh = read_triangles(file());
  constexpr double kMoved = 0.01;
  // The torus lies around the z axis: so far outwards from the middle of its tube.
  for (Vec3& p : mesh.points) p.z() += std::copysign(kMoved, p.z());
  const double moved = kMoved / judge_.diagonal();
  const RemeshJudgement found = judged(mesh);
  EXPECT_LE(found.vertices.max, 1.001 * moved);
  EXPECT_GT(found.vertices.max, 0.9 * moved);
  EXPECT_GT(found.vertices.mean, 0.4 * moved);
}

TEST_F(RemeshOfTorus, CountsTurnedFaces) {
  TriangleMesh mesh = read_triangles(file());
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  const RemeshJudgement found = judged(mesh);
  EXPECT_EQ(found.turned, 1u);
  EXPECT_NE(found.faults.find("turned_neighbour"), std::string::npos) << found.faults;
  EXPECT_FALSE(found.has_topology_of(judge_.judge(file())));
}

TEST_F(RemeshOfTorus, CountsCrossings) {
  TriangleMesh mesh = read_triangles(file());
  // A high one through the first face, whose middle is not on the equator.
  Vec3 middle = Vec3::Zero();
  for (const int v : mesh.triangles[0]) middle += mesh.points[static_cast<std::size_t>(v)] / 3;
  const Vec3 up(0, 0, 10), aside(0.01, 0, 0);
  const auto first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {middle - up, middle + up, middle + up + aside});
  mesh.triangles.push_back({first, first + 1, first + 2});
  const RemeshJudgement found = judged(mesh);
  EXPECT_GT(found.crossings, 0u);
  EXPECT_EQ(found.turned, 0u);  // too far away
  EXPECT_EQ(found.components, 2u);
}

TEST_F(RemeshOfTorus, MayBeTurnedOverAsAWhole) {
  TriangleMesh mesh = read_triangles(file());
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  const RemeshJudgement found = judged(mesh);
  EXPECT_EQ(found.turned, 0u);
  EXPECT_TRUE(found.has_topology_of(judge_.judge(file())));
}

TEST_F(RemeshOfTorus, MayHaveAHole) {
  TriangleMesh mesh = read_triangles(file());
  mesh.triangles.pop_back();
  const RemeshJudgement found = judged(mesh);
  EXPECT_EQ(found.boundary_loops, 1u);
  EXPECT_EQ(found.euler, -1);
}

TEST_F(RemeshOfTorus, IsCutAtShorterDiagonalsOfItsQuads) {
  // Of the rhombus two equilateral triangles, of the square two halves with Q = √3/2.
  std::ofstream(folder_ / "quads.off")
      << "OFF\n8 2 0\n0 0 0\n1 0 0\n1.5 0.8660254037844386 0\n0.5 0.8660254037844386 0\n"
         "5 0 0\n6 0 0\n6 1 0\n5 1 0\n4 0 1 2 3\n4 4 5 6 7\n";
  const RemeshJudgement mesh = judge_.judge(folder_ / "quads.off");
  EXPECT_EQ(mesh.faces, 2u);
  EXPECT_NEAR(mesh.least_quality, std::sqrt(3.0) / 2, 1e-12);
  EXPECT_NEAR(mesh.mean_quality, (1 + std::sqrt(3.0) / 2) / 2, 1e-12);
}

TEST(RemeshJudge, MeasuresFeatures) {
  const TestFolder folder;
  const fs::path knob = fs::path(SURFMESH_SOURCE_DIR) / "models/knob.obj";
  const RemeshJudge judge(knob);
  // One small triangle is far from most of the creases.
  write_obj({{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}}}, folder / "small.obj");
  EXPECT_GT(judge.judge(folder / "small.obj").features, 0.1);
}

TEST(RemeshTruths, AreThere) {
  Settings settings;
  settings.source = SURFMESH_SOURCE_DIR;
  settings.is_quick = true;
  const auto quick = remesh_truths(settings);
  EXPECT_EQ(quick.size(), 4u);
  settings.is_quick = false;
  EXPECT_GE(remesh_truths(settings).size(), quick.size());
  EXPECT_EQ(remesh_inputs(true).size(), 1u);
  EXPECT_EQ(remesh_inputs(false).size(), 4u);
}

/// A mesh by surfmesh that is as it should be, and one by a peer that is no better.
RemeshResult good_result() {
  RemeshResult result{"torus_2000", "a torus", true, {2000, false}};
  result.input.facets = {0.001, 0.003};
  result.rows.resize(2);
  RemeshRow& mine = result.rows[0];
  mine.sizes = RemeshSizes::Half;
  mine.run.tool = "surfmesh";
  mine.run.command = "surfmesh mesh torus.off";
  mine.run.processor_seconds = {1};
  mine.run.clock_seconds = {2};
  mine.mesh.faces = 8000;
  mine.mesh.facets = {0.0003, 0.001};
  mine.mesh.vertices = {0.0001, 0.0002};
  mine.mesh.from_surface = {0.0003, 0.002};
  mine.mesh.least_quality = 0.8;
  mine.mesh.mean_quality = 0.98;
  result.rows[1] = mine;
  result.rows[1].run.tool = "CGAL";
  result.rows[1].run.processor_seconds = {3};
  return result;
}

TEST(MissedAims, AreNoneWhereAllIsWell) {
  EXPECT_EQ(missed_aims(good_result()), std::vector<std::string>{});
}

TEST(MissedAims, NameWhatIsTooFar) {
  RemeshResult result = good_result();
  result.rows[0].mesh.vertices.mean = result.rows[1].mesh.vertices.mean = 0.0003;
  EXPECT_EQ(missed_aims(result), std::vector<std::string>{});
  result.wanted.triangles = 30000;  // more is expected of a smooth surface then
  EXPECT_EQ(missed_aims(result),
            std::vector<std::string>{"half, triangles: vertices 0.30 of the input's distance"});
  result.is_smooth = false;
  EXPECT_EQ(missed_aims(result), std::vector<std::string>{});
  result.rows[0].mesh.facets.mean = 0.0006;
  result.rows[1].mesh.facets.mean = 0.0007;
  EXPECT_EQ(missed_aims(result),
            std::vector<std::string>{"half, triangles: faces 0.60 of the input's distance"});
  result.wanted.is_adaptive = true;
  EXPECT_EQ(missed_aims(result), std::vector<std::string>{});
  result.wanted.is_adaptive = false;
  // Longer sides have longer chords.
  result.rows[0].sizes = result.rows[1].sizes = RemeshSizes::Same;
  EXPECT_EQ(missed_aims(result), std::vector<std::string>{});
}

TEST(MissedAims, NameOtherFaults) {
  RemeshResult result = good_result();
  result.rows[0].mesh.turned = 3;
  result.rows[0].mesh.crossings = 5;
  result.rows[0].mesh.euler = 2;
  result.rows[0].mesh.features = 0.02;
  EXPECT_EQ(missed_aims(result),
            (std::vector<std::string>{"half, triangles: 3 turned", "half, triangles: 5 crossings",
                                      "half, triangles: the topology is not that of the input",
                                      "half, triangles: features off by 2.000 % of the diagonal"}));
  result = good_result();
  result.input.area = 100 * std::sqrt(3.0) / 4;
  result.input.mean_edge = 0.2;  // five times are the sides of 100 triangles
  EXPECT_NEAR(ideal_count(result, RemeshSizes::Fivefold), 100, 1e-9);
  EXPECT_EQ(ideal_count(result, RemeshSizes::Curvature), 0);
  result.rows[0].sizes = RemeshSizes::Fivefold;
  result.rows[0].mesh.faces = 109;
  result.rows.resize(1);
  EXPECT_EQ(missed_aims(result), std::vector<std::string>{});
  result.rows[0].mesh.faces = 111;
  EXPECT_EQ(missed_aims(result),
            std::vector<std::string>{"fivefold, triangles: 111 faces, 100 are ideal"});
  result = good_result();
  result.rows[0].run.failure = "crashed (signal 11)";
  EXPECT_EQ(missed_aims(result), std::vector<std::string>{"half, triangles: crashed (signal 11)"});
}

TEST(MissedAims, NameWhatAnotherToolDoesBetter) {
  RemeshResult result = good_result();
  RemeshRow& peer = result.rows[1];
  peer.mesh.least_quality = 0.9;
  peer.mesh.mean_quality = 0.99;
  peer.mesh.facets.mean = 0.0002;
  peer.run.processor_seconds = {1.5};
  EXPECT_EQ(missed_aims(result),
            (std::vector<std::string>{"half, triangles: least quality 0.8, 0.9 of CGAL",
                                      "half, triangles: mean quality 0.98, 0.99 of CGAL",
                                      "half, triangles: distance in % 0.03, 0.02 of CGAL",
                                      "half, triangles: seconds 1, 1.5 of CGAL"}));
  peer.sizes = RemeshSizes::Same;  // not the same task
  EXPECT_EQ(missed_aims(result), std::vector<std::string>{});
}

TEST(RemeshTable, HasARowForEachMesh) {
  RemeshResult result = good_result();
  result.rows[1].run.failure = "wrote no mesh";
  const std::string table = remesh_table(result);
  for (const char* row :
       {"| input | – | 0 | 0.1000 / 0.300, 1.00 | 0.0000 / 0.000, 0.00 |",
        "| half | surfmesh | 8,000 | 0.0300 / 0.100, 0.30 | 0.0100 / 0.020, 0.10 | "
        "0.0300 / 0.200 | 0.000 | 0.80 / 0.980 | same | 1 | 2 | 1.00 [1.00, 1.00] |\n",
        "| half | CGAL | wrote no mesh | – |"}) {
    EXPECT_NE(table.find(row), std::string::npos) << table;
  }
  EXPECT_EQ(table.find("Missed"), std::string::npos);
  // As many cells in each line.
  std::vector<long> bars;
  for (std::size_t at = 0, end = 0; at < table.size(); at = end + 1) {
    end = table.find('\n', at);
    bars.push_back(std::count(table.begin() + static_cast<long>(at),
                              table.begin() + static_cast<long>(end), '|'));
  }
  EXPECT_EQ(bars, std::vector<long>(5, 13));
}

TEST(RemeshTable, TellsOtherTopologyAndMissedAims) {
  RemeshResult result = good_result();
  result.rows[0].mesh.euler = 2;
  result.rows[0].mesh.boundary_loops = 1;
  result.rows[0].mesh.turned = 4;
  result.rows[0].mesh.crossings = 1;
  result.rows[0].mesh.faults = "duplicate_vertex";
  const std::string table = remesh_table(result);
  EXPECT_NE(table.find("| χ 2, 1 borders, duplicate_vertex, 1 crossings, 4 turned |"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("Missed by surfmesh:\n\n- half, triangles: 4 turned\n"), std::string::npos);
}

TEST(RemeshSection, IsPartOfTheComparison) {
  Comparison comparison;
  EXPECT_EQ(markdown(comparison).find("## Remeshing"), std::string::npos);
  comparison.remeshing = {good_result()};
  const std::string text = markdown(comparison);
  EXPECT_NE(text.find("## Remeshing"), std::string::npos);
  EXPECT_NE(text.find("    surfmesh mesh torus.off\n"), std::string::npos);
  const auto json = to_json(comparison).at("remeshing").at(0);
  EXPECT_EQ(json.at("meshes").size(), 2u);
  EXPECT_EQ(json.at("meshes").at(0).at("mesh").at("vertices").at("max"), 0.0002);
  EXPECT_EQ(json.at("wanted_share"), 0.5);
}

/// A program for tests: a shell script.
void write_script(const fs::path& path, const std::string& text) {
  std::ofstream(path) << "#!/bin/sh\n" << text << "\n";
  fs::permissions(path, fs::perms::owner_all);
}

TEST_F(RemeshOfTorus, GoesThroughAllTools) {
  // Both write the mesh that is there, but surfmesh makes no quads.
  write_script(folder_ / "surfmesh",
               "case \"$*\" in *--quads*) exit 5;; esac\n"
               "cp '" +
                   file().string() + "' \"$4\"");
  write_script(folder_ / "cgal_remesh", "[ \"$4\" = 40 ] && cp \"$1\" \"$2\"");
  Settings settings;
  settings.work = folder_.path();
  settings.surfmesh = folder_ / "surfmesh";
  settings.rounds = 2;
  const std::vector<Peer> peers = {{PeerKind::Mmgs, "Mmgs", "", ""},
                                   {PeerKind::Gmsh, "Gmsh", "/no/such/tool", ""},
                                   {PeerKind::Cgal, "CGAL", folder_ / "cgal_remesh", "5"}};
  const RemeshResult result =
      compare_remeshing({"torus", kTorus, true}, judge_, {500, true}, peers, settings);
  // Four groups; no curvature sizes for CGAL, and the others do not remesh or are not there.
  ASSERT_EQ(result.rows.size(), 11u);
  for (const RemeshRow& row : result.rows) {
    EXPECT_EQ(row.run.failure, row.is_quads ? "failed (exit status 5)" : "");
    if (row.is_quads) continue;
    EXPECT_EQ(row.mesh.faces, result.input.faces);
    EXPECT_EQ(row.run.processor_seconds.size(), 2u);
    EXPECT_EQ(row.run.clock_seconds.size(), 2u);
  }
  EXPECT_EQ(result.rows[2].run.tool, "CGAL");
  EXPECT_EQ(result.name, "torus_500_adaptive");
  EXPECT_NE(result.rows[0].run.command.find("--surface interpolate --size "), std::string::npos);
  EXPECT_EQ(result.rows[9].run.command.find("--size"), std::string::npos);  // from curvature
}

TEST_F(RemeshOfTorus, IsNotMadeWithoutSurfmesh) {
  Settings settings;
  settings.work = folder_.path();
  settings.surfmesh = "/no/such/surfmesh";
  EXPECT_THROW(compare_remeshing({"torus", kTorus, true}, judge_, {500, false}, {}, settings),
               Error);
}

}  // namespace
}  // namespace surfmesh
