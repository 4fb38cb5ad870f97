// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/model_folders.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/set_option.hh"
#include "surfmesh/quality/sag.hh"

/// Meshes of quads alone, of whole models.
namespace surfmesh {
namespace {

using testing::kModels;
using testing::kSharedModels;

namespace fs = std::filesystem;

using Settings = std::vector<std::pair<std::string, std::string>>;

MeshResult mesh_with(const ModelInput& input, bool quads, const Settings& settings = {}) {
  PipelineOptions options = input.options;
  for (const auto& [name, value] : settings) set_option(options, name, value);
  options.quads.is_on = quads;
  return mesh_model(input.model, input.sources, options);
}

std::vector<std::string> shortfalls_of(const MeshResult& result) {
  return texts_of(result.report.notices, Severity::Shortfall);
}

/// Expect a face of different vertices each time: find_faults looks for edges only.
void expect_faces_of_four(const PolyMesh& mesh) {
  std::size_t others = 0, doubled = 0;
  for (const FaceHandle fh : mesh.faces()) {
    std::set<VertexHandle> vertices;
    for (const VertexHandle vh : mesh.fv_range(fh)) vertices.insert(vh);
    if (mesh.valence(fh) != 4) ++others;
    if (vertices.size() < mesh.valence(fh)) ++doubled;
  }
  EXPECT_EQ(others, 0u);
  EXPECT_EQ(doubled, 0u);
}

/// The counts of a mesh that sizes do not change.
std::pair<long, bool> topology_of(const Report& report) {
  return {report.mesh.euler, report.mesh.is_closed};
}

/// A mesh of triangles with few of them.
const Settings kCoarse = {{"size", "20%"}};

/// Expect only quads in a proper mesh with the topology that triangles have.
void expect_proper_quads(const ModelInput& input, const MeshResult& quads) {
  testing::expect_valid(quads.mesh);
  expect_faces_of_four(quads.mesh);
  EXPECT_EQ(topology_of(quads.report), topology_of(mesh_with(input, false, kCoarse).report));
}

/// Expect quads of which none is inverted in (u,v), and that it is told if any is folded in space.
void expect_good_quads(const ModelInput& input) {
  const MeshResult quads = mesh_with(input, true);
  expect_proper_quads(input, quads);
  EXPECT_EQ(quads.report.quads.inverted, 0u) << "least " << quads.report.quads.min_jacobian;
  EXPECT_EQ(shortfalls_of(quads).empty(), quads.report.quads.folded == 0);
  EXPECT_LE(quads.report.quads.folded, quads.mesh.n_faces() / 20);
}

/// Expect that few of the quads are inverted where the boundary leaves no room, and that it is told
/// if there are any.
void expect_coarse_quads(const ModelInput& input) {
  const MeshResult quads = mesh_with(input, true, kCoarse);
  expect_proper_quads(input, quads);
  const std::size_t inverted = quads.report.quads.inverted;
  EXPECT_LE(inverted, quads.mesh.n_faces() / 100) << quads.report.quads.min_jacobian;
  EXPECT_EQ(shortfalls_of(quads).empty(), inverted + quads.report.quads.folded == 0);
}

std::vector<fs::path> files_in(const fs::path& folder, const std::set<std::string>& endings) {
  std::vector<fs::path> paths;
  if (!fs::exists(folder)) return paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name != "surfmesh.schema.json" && endings.contains(entry.path().extension().string())) {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<fs::path> models() { return files_in(kModels, {".json", ".obj", ".off"}); }

TEST(QuadsOfModels, AreProperAndNotInverted) {
  for (const fs::path& path : models()) {
    SCOPED_TRACE(path.filename().string());
    expect_good_quads(load_model(path));
  }
}

TEST(QuadsOfModels, AreProperIfTheyAreLarge) {
  for (const fs::path& path : models()) {
    SCOPED_TRACE(path.filename().string());
    expect_coarse_quads(load_model(path));
  }
}

/// In parts, which can run beside each other.
class QuadsOfSharedCages : public ::testing::TestWithParam<int> {
 protected:
  static constexpr int kParts = 4;

  void SetUp() override {
    const std::vector<fs::path> all = files_in(kSharedModels / "opensubdiv", {".obj"});
    if (all.empty()) GTEST_SKIP() << "no cages in " << kSharedModels;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (static_cast<int>(i % kParts) == GetParam()) cages_.push_back(all[i]);
    }
    if (GetParam() == 0) cages_.push_back(kSharedModels / "spot_control_mesh.obj");
  }

  std::vector<fs::path> cages_;
};

TEST_P(QuadsOfSharedCages, AreProperAndNotInverted) {
  for (const fs::path& path : cages_) {
    SCOPED_TRACE(path.filename().string());
    expect_good_quads(load_model(path));
  }
}

TEST_P(QuadsOfSharedCages, AreProperIfTheyAreLarge) {
  for (const fs::path& path : cages_) {
    SCOPED_TRACE(path.filename().string());
    expect_coarse_quads(load_model(path));
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, QuadsOfSharedCages, ::testing::Range(0, 4));

// --- threads ---

class QuadThreads : public ::testing::TestWithParam<std::string> {};

TEST_P(QuadThreads, MakeTheSameFileInAnyNumber) {
  const ModelInput input = load_model(kModels / GetParam());
  const TestFolder folder;
  const auto bytes_with = [&](const std::string& threads) {
    write_mesh(mesh_with(input, true, {{"threads", threads}}), folder / "mesh.om");
    return read_text(folder / "mesh.om");
  };
  const std::string alone = bytes_with("1");
  EXPECT_TRUE(bytes_with("2") == alone);
  EXPECT_TRUE(bytes_with("3") == alone);
}

INSTANTIATE_TEST_SUITE_P(Models, QuadThreads,
                         ::testing::Values("bracket.json", "sphere.json", "torus.obj", "vault.obj"),
                         [](const auto& test) {
                           return test.param.substr(0, test.param.find('.'));
                         });

// --- sag ---

void expect_sag(const Model& model, double sag) {
  PipelineOptions options;
  options.quads.is_on = true;
  options.sizing.sag = Length::units(sag);
  const MeshResult result = mesh_model(model, {}, options);
  testing::expect_valid(result.mesh);
  expect_faces_of_four(result.mesh);
  EXPECT_LE(measure_sag(result.mesh, model, SurfaceSearch(model)).max, sag);
  EXPECT_EQ(shortfalls_of(result), std::vector<std::string>{});
  EXPECT_EQ(result.report.quads.inverted, 0u);
}

TEST(QuadsWithSag, AreNearTheSurface) {
  expect_sag(testing::model_of({testing::sphere()}), 0.01);
  expect_sag(testing::torus_of(3), 0.01);
  expect_sag(testing::cylinder_of(2), 0.003);
}

TEST(QuadsWithSag, AreMoreForLess) {
  const auto count = [](double sag) {
    PipelineOptions options;
    options.quads.is_on = true;
    options.sizing.sag = Length::units(sag);
    return static_cast<double>(
        mesh_model(testing::model_of({testing::whole_torus()}), {}, options).report.mesh.quads);
  };
  const double ratio = count(0.004) / count(0.016);
  EXPECT_GT(ratio, 2.5);
  EXPECT_LT(ratio, 6.5);
}

// --- contours with even numbers of segments ---

/// Either way of even numbers is tried; on the cube each face is a regular grid by one of them.
TEST(EvenContours, GiveTheCubeRegularGrids) {
  const MeshResult result = mesh_with(load_model(kModels / "cube.obj"), true);
  EXPECT_GE(result.report.quads.mean_jacobian, 0.96);
}

TEST(EvenContours, KeepOppositeSidesOfARectangleEqual) {
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  for (const double size : {0.09, 0.11, 0.21, 0.34}) {
    PipelineOptions options;
    options.quads.is_on = true;
    options.sizing.size = Length::units(size);
    const Report report = mesh_model(model, {}, options).report;
    EXPECT_EQ(report.quads.irregular_share, 0) << size;
    EXPECT_GT(report.quads.min_jacobian, 0.99) << size;
  }
}

// --- poles ---

TEST(QuadsAtPoles, AreQuads) {
  for (const double size : {0.1, 0.3, 1.0}) {
    for (const Model& model : {testing::sphere_of(1), testing::sphere_of(2), testing::sphere_of(5),
                               testing::cone_of(1), testing::cone_of(3)}) {
      PipelineOptions options;
      options.quads.is_on = true;
      options.sizing.size = Length::units(size);
      const MeshResult result = mesh_model(model, {}, options);
      testing::expect_valid(result.mesh);
      expect_faces_of_four(result.mesh);
      EXPECT_EQ(result.report.quads.inverted, 0u) << size;
      EXPECT_EQ(shortfalls_of(result), std::vector<std::string>{}) << size;
    }
  }
}

// --- fronts ---

/// Four fronts around more than two triangles were taken for a gap of two, and the run had no end.
TEST(FrontalQuads, CloseNoGapWithAVertexInside) {
  const TestFolder folder;
  write_text(folder / "sizes.csv", "u,v,ls,lt,angle\n3.02009,0.433841,0.197123,0.161048,169.551\n");
  const std::string surface =
      "\"surface\": {\"where\": {\"r\": \"1+0.160694*sin(1.99241*v+1.1029)\"}, "
      "\"x\": \"r*cos(u)\", \"y\": \"r*sin(u)\", \"z\": \"3.68582*v\"}, ";
  std::string model = "{\"patches\": [{\"name\": \"a\", ";
  model += surface;
  model +=
      "\"domain\": {\"u\": [0, 1.9697], \"v\": [0, 2]}, \"sources\": [{\"field\": "
      "{\"size\": \"if(u<0.606846,0.133968,0.643339)\"}}]}, {\"name\": \"b\", ";
  model += surface;
  model +=
      "\"domain\": {\"u\": [1.9697, 3.9394], \"v\": [0, 2]}, "
      "\"sources\": [{\"table\": \"sizes.csv\"}]}]}";
  write_text(folder / "tube.json", model);
  const MeshResult result = mesh_with(
      load_model(folder / "tube.json"), true,
      {{"quad_method", "frontal"}, {"quad_front", "lee-lo"}, {"sag", "1%"}, {"threads", "1"}});
  testing::expect_valid(result.mesh);
  expect_faces_of_four(result.mesh);
}

}  // namespace
}  // namespace surfmesh
