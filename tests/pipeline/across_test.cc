// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/cancelling.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/model_folders.hh"
#include "support/notices.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/pipeline/check_mesh.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/set_option.hh"
#include "surfmesh/quality/corners_beyond.hh"

/// Whole runs with elements that cross contours.
namespace surfmesh {
namespace {

using testing::kModels;
using testing::kSharedModels;

namespace fs = std::filesystem;

using Settings = std::vector<std::pair<std::string, std::string>>;

MeshResult mesh_with(const ModelInput& input, const Settings& settings = {}) {
  PipelineOptions options = input.options;
  for (const auto& [name, value] : settings) set_option(options, name, value);
  return mesh_model(input.model, input.sources, options);
}

std::vector<std::string> faults_of(const MeshResult& result, const ModelInput& input) {
  MeshFile file{result.mesh, result.names, {}, {}};
  const ModelFit fit = measure_fit(file, input);
  std::vector<std::string> texts;
  for (const auto& faults : {fit.distance.faults, fit.differences}) {
    for (const MeshFault& fault : faults) texts.push_back(fault.kind + ": " + fault.places.front());
  }
  return texts;
}

/// The models and options of the tests below.
struct AcrossCase {
  std::string model;
  std::string quads;
};

std::ostream& operator<<(std::ostream& out, const AcrossCase& example) {
  return out << example.model << (example.quads == "on" ? " quads" : " triangles");
}

class AcrossModels : public ::testing::TestWithParam<AcrossCase> {
 protected:
  ModelInput input() const { return load_model(kModels / GetParam().model); }
  Settings settings(const std::string& across) const {
    return {{"quads", GetParam().quads}, {"across", across}};
  }
};

TEST_P(AcrossModels, AreOnTheirSurfaceWithTheSameTopology) {
  const ModelInput model = input();
  const MeshResult off = mesh_with(model, settings("off")), on = mesh_with(model, settings("on"));
  testing::expect_valid(on.mesh);
  EXPECT_EQ(on.report.mesh.euler, off.report.mesh.euler);
  EXPECT_EQ(on.report.mesh.is_closed, off.report.mesh.is_closed);
  EXPECT_EQ(faults_of(on, model), std::vector<std::string>());
  EXPECT_EQ(texts_of(on.report.notices, Severity::Shortfall),
            texts_of(off.report.notices, Severity::Shortfall));
  EXPECT_TRUE(find(on.mesh, keys::corner_beyond).is_valid());
  EXPECT_FALSE(find(off.mesh, keys::corner_beyond).is_valid());
}

TEST_P(AcrossModels, HaveBetterElements) {
  const ModelInput model = input();
  const Report off = mesh_with(model, settings("off")).report;
  const Report on = mesh_with(model, settings("on")).report;
  EXPECT_GE(on.edges.unit_fraction, off.edges.unit_fraction);
  EXPECT_LE(on.edges.stddev, off.edges.stddev);
  if (GetParam().quads == "on") {
    EXPECT_GE(on.quads.mean_jacobian, off.quads.mean_jacobian - 0.002);
    EXPECT_EQ(on.quads.inverted, 0u);
  } else {
    EXPECT_GE(on.quality.mean, off.quality.mean);
    EXPECT_GT(on.quality.min, 0.6);
  }
}

TEST_P(AcrossModels, AreTheSameOnAnyNumberOfThreads) {
  const ModelInput model = input();
  const TestFolder folder;
  std::set<std::string> files;
  for (const std::string threads : {"1", "2", "3"}) {
    Settings with = settings("on");
    with.emplace_back("threads", threads);
    write_mesh(mesh_with(model, with), folder / "a.om");
    files.insert(read_text(folder / "a.om"));
  }
  EXPECT_EQ(files.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(
    Models, AcrossModels,
    ::testing::Values(AcrossCase{"knob.obj", "off"}, AcrossCase{"knob.obj", "on"},
                      AcrossCase{"torus.json", "off"}, AcrossCase{"torus.json", "on"},
                      AcrossCase{"icosahedron.off", "off"}, AcrossCase{"cylinder.json", "off"},
                      AcrossCase{"knob_on_plate.json", "on"}));

/// Write a result that lies on several patches in places, read it back, and expect no fault.
ModelFit fit_of_file(const std::string& name, const MeshResult& result, const ModelInput& input) {
  const TestFolder folder;
  write_mesh(result, folder / name);
  MeshFile file = read_mesh(folder / name);
  ModelFit fit = measure_fit(file, input);
  EXPECT_GT(fit.corners_beyond, 0u);
  EXPECT_TRUE(fit.distance.faults.empty());
  return fit;
}

TEST(Across, IsFoundAgainByProjection) {
  const ModelInput input = load_model(kModels / "knob.obj");
  const MeshResult result = mesh_with(input);
  const ModelFit fit = fit_of_file("a.obj", result, input);
  EXPECT_TRUE(fit.is_projected);
  EXPECT_NEAR(fit.sizes.edges.unit_fraction, result.report.edges.unit_fraction, 2e-3);
  EXPECT_NEAR(fit.sizes.quality.mean, result.report.quality.mean, 2e-3);
}

TEST(Across, IsReadBackFromFilesThatKeepParameters) {
  const ModelInput input = load_model(kModels / "knob.obj");
  const MeshResult result = mesh_with(input);
  const ModelFit fit = fit_of_file("a.om", result, input);
  EXPECT_FALSE(fit.is_projected);
  EXPECT_EQ(fit.sizes.edges.unit_fraction, result.report.edges.unit_fraction);
}

TEST(Across, IsJudgedByExactSizesToo) {
  const ModelInput input = load_model(kModels / "torus.json");
  MeshFile file{mesh_with(input).mesh, mesh_names(input.model), {}, {}};
  const ModelFit fit = measure_fit(file, input, JudgedBy::ExactSizes);
  EXPECT_GT(fit.sizes.edges.unit_fraction, 0.98);
  EXPECT_GT(fit.sizes.quality.min, 0.6);
}

TEST(Across, FindsVerticesOffTheSurface) {
  const ModelInput input = load_model(kModels / "torus.json");
  MeshFile file{mesh_with(input).mesh, mesh_names(input.model), {}, {}};
  const detail::CornersBeyond is_beyond(file.mesh);
  const auto moved = std::find_if(file.mesh.halfedges_begin(), file.mesh.halfedges_end(),
                                  [&](HalfedgeHandle corner) { return is_beyond(corner); });
  ASSERT_NE(moved, file.mesh.halfedges_end());
  const VertexHandle vh = file.mesh.to_vertex_handle(*moved);
  file.mesh.set_point(vh, 1.01 * file.mesh.point(vh));
  const ModelFit fit = measure_fit(file, input);
  ASSERT_FALSE(fit.distance.faults.empty());
  EXPECT_EQ(fit.distance.faults.back().kind, "corner_off_surface");
}

TEST(Across, HasTheNormalsOfTheSurface) {
  const ModelInput input = load_model(kModels / "torus.json");
  const MeshResult result = mesh_with(input, {{"normals", "on"}});
  const auto normal_of = require(result.mesh, keys::corner_normal);
  for (const VertexHandle vh : result.mesh.vertices()) {
    Vec3 first = Vec3::Zero();
    for (const HalfedgeHandle corner : result.mesh.vih_range(vh)) {
      const Normal& n = result.mesh.property(normal_of, corner);
      const Vec3 normal(n.x, n.y, n.z);
      ASSERT_NEAR(normal.norm(), 1, 1e-12);
      if (first.isZero(0)) first = normal;
      EXPECT_LT((normal - first).norm(), 1e-6) << "the torus has one normal at each point";
    }
  }
}

TEST(Across, GivesWayToASag) {
  const ModelInput input = load_model(kModels / "knob.obj");
  const MeshResult result = mesh_with(input, {{"sag", "1%"}});
  EXPECT_FALSE(find(result.mesh, keys::corner_beyond).is_valid());
  EXPECT_LE(*result.report.sag.reached, *result.report.sag.asked);
}

TEST(Across, KeepsTheLineBetweenGroups) {
  ModelInput input = load_model(kModels / "knob.obj");
  input.model.groups = {{"first", {0}}};
  const MeshResult result = mesh_with(input);
  const auto contour_of = require(result.mesh, keys::edge_contour);
  const auto patch_of = require(result.mesh, keys::face_patch);
  std::size_t between = 0;
  for (const EdgeHandle eh : result.mesh.edges()) {
    const HalfedgeHandle heh = result.mesh.halfedge_handle(eh, 0);
    const int a = result.mesh.property(patch_of, result.mesh.face_handle(heh));
    const int b = result.mesh.property(
        patch_of, result.mesh.face_handle(result.mesh.opposite_halfedge_handle(heh)));
    if ((a == 0) == (b == 0)) continue;
    ++between;
    EXPECT_GE(result.mesh.property(contour_of, eh), 0);
  }
  EXPECT_GT(between, 0u);
}

/// Two squares side by side, the first one with these sources.
std::string first_of_two_squares(const std::string& sources) {
  return R"({"patches": [
    {"name": "a", "surface": {"x": "u", "y": "v", "z": "0"},
     "domain": {"u": [0, 1], "v": [0, 1]}, "sources": [)" +
         sources + R"(]},
    {"name": "b", "surface": {"x": "u", "y": "v", "z": "0"},
     "domain": {"u": [1, 2], "v": [0, 1]}}]})";
}

TEST(Across, KeepsTheContourThatSizesAreAskedForAlong) {
  const TestFolder folder;
  for (const bool is_named : {false, true}) {
    write_text(folder / "a.json",
               first_of_two_squares(is_named ? R"({"along": "a:u1", "size": 0.08})" : ""));
    const ModelInput input = load_model(folder / "a.json");
    const auto named = std::count_if(input.model.contours.begin(), input.model.contours.end(),
                                     [](const Contour& contour) { return contour.is_named; });
    EXPECT_EQ(named, is_named ? 1 : 0);
  }
}

TEST(Across, CanBeCancelled) {
  /// Cancels once elements are improved across contours.
  class CancelAcross : public Observer {
   public:
    void progress(std::string_view stage, std::size_t, std::size_t) override {
      is_across_ = is_across_ || stage == "across";
    }
    bool is_cancelled() override { return is_across_; }

   private:
    bool is_across_ = false;
  } observer;
  const ModelInput input = load_model(kModels / "knob.obj");
  EXPECT_EQ(error_of([&] { mesh_model(input.model, input.sources, input.options, &observer); }),
            testing::kCancelled);
}

/// Models that many look at; numbers are those of their issue.
class AcrossShared : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!fs::exists(kSharedModels / GetParam())) GTEST_SKIP() << "no " << kSharedModels;
  }
};

TEST_P(AcrossShared, HaveUnitEdges) {
  const ModelInput input = load_model(kSharedModels / GetParam());
  const Report report = mesh_with(input).report;
  EXPECT_GE(report.edges.unit_fraction, 0.992);
  EXPECT_GT(report.quality.min, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Cages, AcrossShared,
                         ::testing::Values("spot_control_mesh.obj", "opensubdiv/catmark_car.obj",
                                           "opensubdiv/catmark_pawn.obj"));

}  // namespace
}  // namespace surfmesh
