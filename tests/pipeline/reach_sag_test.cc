// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "model/hand_made.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/model/finish_model.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/set_option.hh"
#include "surfmesh/quality/contour_distance.hh"
#include "surfmesh/quality/sag.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

PipelineOptions with_sag(double sag) {
  PipelineOptions options;
  options.sizing.sag = Length::units(sag);
  return options;
}

MeshResult mesh_with_sag(const Model& model, double sag) {
  return mesh_model(model, {}, with_sag(sag));
}

/// A sine wave across, straight along.
Model corrugated() {
  return testing::model_of({make_callable_surface({0, 6, 0, 3}, [](auto u, auto v) {
    return std::array{u, v, 0.5 * sin(2 * u)};
  })});
}

/// Expect all triangles within the sag, of a fair shape, and not turned.
void expect_reached(const Model& model, double sag) {
  const MeshResult result = mesh_with_sag(model, sag);
  testing::expect_valid(result.mesh);
  EXPECT_LE(measure_sag(result.mesh, model, SurfaceSearch(model)).max, sag);
  EXPECT_TRUE(texts_of(result.report.notices, Severity::Shortfall).empty())
      << texts_of(result.report.notices, Severity::Shortfall).front();
  EXPECT_GT(result.report.quality.min, 0.2);
}

TEST(ReachSag, KeepsAllTrianglesNear) {
  expect_reached(testing::model_of({testing::sphere()}), 0.01);
  expect_reached(testing::torus_of(3), 0.01);
  expect_reached(corrugated(), 0.005);
  expect_reached(testing::cylinder_of(2), 0.003);
}

TEST(ReachSag, TakesFewMoreTrianglesThanThatTakes) {
  // A triangle of sides h over the unit sphere has the sag h²/6.
  const double sag = 0.002, least = 4 * pi / (std::sqrt(3) / 4 * 6 * sag);
  const MeshResult result = mesh_with_sag(testing::model_of({testing::sphere()}), sag);
  EXPECT_LT(static_cast<double>(result.report.mesh.triangles), 1.5 * least);
}

TEST(ReachSag, TakesTrianglesInInverseProportion) {
  const Model model = testing::model_of({testing::whole_torus()});
  const auto coarse = static_cast<double>(mesh_with_sag(model, 0.016).report.mesh.triangles);
  const auto fine = static_cast<double>(mesh_with_sag(model, 0.002).report.mesh.triangles);
  EXPECT_NEAR(fine / coarse, 8, 1.6);
}

double greatest_distance(const PolyMesh& mesh, const std::vector<SharpContour>& contours) {
  double greatest = 0;
  for (const ContourDistance& far : far_contour_points(mesh, contours, 0)) {
    greatest = std::max(greatest, far.distance);
  }
  return greatest;
}

// No triangle of a plate is far from its plane, but its border may be.
TEST(ReachSag, KeepsBordersNear) {
  for (const double sag : {0.05, 0.01, 0.002}) {
    const Model model = testing::square_with_hole(0.5);
    const MeshResult result = mesh_with_sag(model, sag);
    const auto contours = sharp_contours(model, 1e-6);
    EXPECT_LE(greatest_distance(result.mesh, contours), sag);
    EXPECT_TRUE(texts_of(result.report.notices, Severity::Shortfall).empty());
  }
}

TEST(ReachSag, TellsOfABorderThatHminKeepsAway) {
  PipelineOptions options = with_sag(0.001);
  options.sizing.hmin = Length::units(0.6);
  options.sizing.hmax = Length::units(1);
  const Model model = testing::square_with_hole(0.5);
  const MeshResult result = mesh_model(model, {}, options);
  const auto contours = sharp_contours(model, 1e-6);
  EXPECT_NEAR(*result.report.sag.reached, greatest_distance(result.mesh, contours), 1e-4);
  const auto notices = texts_of(result.report.notices, Severity::Shortfall);
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_NE(notices[0].find("on contour hole at"), std::string::npos) << notices[0];
  EXPECT_NE(notices[0].find("hmin = 0.6 is in the way"), std::string::npos) << notices[0];
}

TEST(ReachSag, IsReportedAndSoAreTheSizesThatHold) {
  const MeshResult result = mesh_with_sag(testing::torus_of(3), 0.02);
  EXPECT_EQ(result.report.sag.asked, 0.02);
  ASSERT_TRUE(result.report.sag.reached.has_value());
  EXPECT_GT(*result.report.sag.reached, 0.01);
  EXPECT_LE(*result.report.sag.reached, 0.02);
  EXPECT_EQ(to_text(get_option(result.report.options, "sag")), "0.02");
  EXPECT_EQ(to_text(get_option(result.report.options, "curvature")), "off");
}

TEST(ReachSag, IsNotMeasuredWhereItIsNotAskedFor) {
  const MeshResult result = mesh_model(testing::torus_of(3), {}, {});
  EXPECT_FALSE(result.report.sag.asked.has_value());
  EXPECT_FALSE(result.report.sag.reached.has_value());
}

TEST(ReachSag, IsAShortfallWhereTheLeastSizeIsInTheWay) {
  PipelineOptions options = with_sag(1e-4);
  options.sizing.hmin = Length::units(0.2);
  const MeshResult result = mesh_model(testing::torus_of(3), {}, options);
  ASSERT_EQ(texts_of(result.report.notices, Severity::Shortfall).size(), 1u);
  EXPECT_NE(texts_of(result.report.notices, Severity::Shortfall)[0].find("sag = 0.0001"),
            std::string::npos);
  const Notice& notice = result.report.notices.back();
  EXPECT_EQ(notice.kind, NoticeKind::SagNotReached);
  EXPECT_GE(notice.patch, 0);
  EXPECT_TRUE(notice.point.has_value());
  EXPECT_GT(*result.report.sag.reached, 1e-4);
}

TEST(ReachSag, NamesHminWhereItIsInTheWay) {
  PipelineOptions options = with_sag(1e-4);
  options.sizing.hmin = Length::units(0.2);
  const MeshResult result = mesh_model(testing::torus_of(3), {}, options);
  EXPECT_NE(result.report.notices.back().text.find("hmin = 0.2 is in the way"), std::string::npos);
}

/// Counts the meshes that are begun.
class MeshCounter : public Observer {
 public:
  void progress(std::string_view stage, std::size_t done, std::size_t) override {
    if (stage == "boundary" && done == 0) ++count;
  }
  int count = 0;
};

TEST(ReachSag, MeshesOnceWhereHminIsInTheWayEverywhere) {
  for (const double sag : {1e-9, 1e-12}) {
    PipelineOptions options = with_sag(sag);
    options.sizing.hmin = Length::units(0.1);
    MeshCounter counter;
    const MeshResult result = mesh_model(testing::torus_of(3), {}, options, &counter);
    EXPECT_EQ(counter.count, 1);
    EXPECT_NE(result.report.notices.back().text.find("hmin = 0.1"), std::string::npos);
  }
}

/// Meshes a model with a sag and a least size, and counts the meshes that were made for it.
struct CountedRun {
  CountedRun(const Model& model, double sag, double hmin) {
    PipelineOptions options = with_sag(sag);
    options.sizing.hmin = Length::units(hmin);
    MeshCounter counter;
    report = mesh_model(model, {}, options, &counter).report;
    count = counter.count;
  }
  Report report;
  int count = 0;
};

TEST(ReachSag, EndsWhereHminKeepsAllTrianglesTooLarge) {
  const CountedRun run(testing::torus_of(3), 0.001, 0.08);
  EXPECT_LE(run.count, 4);
  EXPECT_NE(run.report.notices.back().text.find("hmin = 0.08 is in the way"), std::string::npos);
}

TEST(ReachSag, EndsWhereMeshesBecomeNoBetterForHmin) {
  const CountedRun run(corrugated(), 0.005, 0.3);
  EXPECT_LE(run.count, 7);
  EXPECT_NE(run.report.notices.back().text.find("is in the way"), std::string::npos);
}

TEST(ReachSag, HoldsBesideRoundedCreases) {
  const std::filesystem::path mug =
      std::filesystem::path(SURFMESH_SHARED_DIR) / "cases" / "trial" / "mug.obj";
  if (!std::filesystem::exists(mug)) GTEST_SKIP() << mug;
  ModelInput input = load_model(mug);
  for (const double sag : {0.0005, 0.0002}) {
    input.options.sizing.sag = Length::share(sag);
    const MeshResult result = mesh_model(input.model, input.sources, input.options);
    EXPECT_LE(*result.report.sag.reached, *result.report.sag.asked);
    EXPECT_TRUE(texts_of(result.report.notices, Severity::Shortfall).empty());
    EXPECT_GT(result.report.quality.mean, 0.93);
  }
}

/// Shapes in space are poor where the sizes are stretched: they must not keep triangles from being
/// corrected, nor be bettered at the cost of the stretch.
TEST(ReachSag, LeavesTrianglesOfGoodShapeWhereTheyAreStretched) {
  PipelineOptions options = with_sag(0.002);
  options.sizing.stretch = 10;
  const Report report = mesh_model(testing::torus_of(3), {}, options).report;
  EXPECT_LE(*report.sag.reached, 0.002);
  EXPECT_GT(report.quality.min, 0.6);
  EXPECT_GT(report.quality.mean, 0.975);
  EXPECT_LT(*report.sag.evaluations, 60 * report.mesh.triangles);
}

/// A plane with a narrow bump.
TEST(ReachSag, FindsANarrowBump) {
  for (const double steepness : {800.0, 1000.0, 2000.0}) {
    const Model model =
        testing::model_of({make_callable_surface({-1, 1, -1, 1}, [=](auto u, auto v) {
          const auto x = u - 0.1, y = v - 0.13;
          return std::array{u, v, 0.3 * exp(-steepness * (x * x + y * y))};
        })});
    const Report report = mesh_with_sag(model, 0.01).report;
    EXPECT_LE(*report.sag.reached, 0.01) << steepness;
    EXPECT_LT(report.mesh.triangles, 3000u) << steepness;
  }
}

/// A crease of some slope, rounded over some width, across a bend.
MeshResult mesh_of_crease(double slope, double width, double stretch) {
  const Model model = testing::model_of({make_callable_surface({0, 1, 0, 1}, [=](auto u, auto v) {
    const auto aside = u - 0.3;
    return std::array{u, v, slope * sqrt(aside * aside + width * width) + 0.1 * sin(3.0 * v)};
  })});
  PipelineOptions options = with_sag(5e-5 * model.diagonal);
  options.sizing.hmin = Length::share(1e-5);
  options.sizing.stretch = stretch;
  return mesh_model(model, {}, options);
}

/// Were stretched triangles not corrected, sizes would shrink to ten times as many triangles.
TEST(ReachSag, HoldsOverANarrowCreaseAtAnyStretch) {
  for (const double stretch : {2.0, 5.0, 10.0}) {
    const Report report = mesh_of_crease(0.02, 1e-3, stretch).report;
    EXPECT_LE(*report.sag.reached, *report.sag.asked) << stretch;
    EXPECT_LT(report.mesh.triangles, 5000u) << stretch;
    EXPECT_GT(report.quality.mean, 0.88) << stretch;
  }
}

TEST(ReachSag, HoldsOverACreaseThatOnceNeededAnotherStretch) {
  const Report report = mesh_of_crease(0.02, 3e-4, 10).report;
  EXPECT_LE(*report.sag.reached, *report.sag.asked);
}

TEST(ReachSag, AdvisesAStretchThatHelps) {
  const Report report = mesh_of_crease(0.1, 5e-4, 10).report;
  ASSERT_GT(*report.sag.reached, *report.sag.asked);
  ASSERT_FALSE(report.notices.empty());
  EXPECT_NE(report.notices.back().text.find("stretch = 2 helps"), std::string::npos);
  const Report advised = mesh_of_crease(0.1, 5e-4, 2).report;
  EXPECT_LE(*advised.sag.reached, *advised.sag.asked);
}

/// The text of the last notice of a mesh of two patches side by side, joined up to `joining`.
std::string last_notice(const std::shared_ptr<const Surface>& left,
                        const std::shared_ptr<const Surface>& right, double joining, double sag) {
  const Model model =
      model_from_patches({{"left", left}, {"right", right}}, {}, {Length::units(joining)});
  EXPECT_TRUE(model.notices.empty());
  PipelineOptions options = with_sag(sag);
  options.sizing.hmin = Length::share(1e-5);
  options.sizing.stretch = 10;
  const Report report = mesh_model(model, {}, options).report;
  EXPECT_GT(*report.sag.reached, sag);
  return report.notices.empty() ? std::string() : report.notices.back().text;
}

TEST(ReachSag, NamesJoiningWhereSidesThatAreJoinedAreApart) {
  const auto plane = [](double u0, double z) {
    return make_callable_surface({u0, u0 + 1, 0, 1}, [=](auto u, auto v) {
      return std::array{u, v, z + 0.0 * u};
    });
  };
  const std::string text = last_notice(plane(0, 0), plane(1, 0.002), 0.003, 0.0005);
  EXPECT_NE(text.find("up to joining = 0.003 apart"), std::string::npos) << text;
}

// Any joining above the sag was named, wherever the worst place was.
TEST(ReachSag, DoesNotNameJoiningElsewhere) {
  const auto crease = [](double u0, double u1) {
    return make_callable_surface({u0, u1, 0, 1}, [](auto u, auto v) {
      const auto aside = u - 0.3;
      return std::array{u, v, 0.3 * sqrt(aside * aside + 2.5e-7) + 0.1 * sin(3.0 * v)};
    });
  };
  const std::string text = last_notice(crease(0, 1), crease(1, 1.05), 0.003, 7e-5);
  EXPECT_NE(text.find("bends there"), std::string::npos) << text;
  EXPECT_EQ(text.find("joining"), std::string::npos) << text;
}

TEST(ReachSag, LeavesTrianglesOfGoodShape) {
  const std::filesystem::path spot =
      std::filesystem::path(SURFMESH_SHARED_DIR) / "models" / "spot_control_mesh.obj";
  if (!std::filesystem::exists(spot)) GTEST_SKIP() << spot;
  ModelInput input = load_model(spot);
  input.options.sizing.sag = Length::share(0.0005);
  const MeshResult result = mesh_model(input.model, input.sources, input.options);
  EXPECT_GT(result.report.quality.mean, 0.95);
  EXPECT_GT(result.report.quality.min, 0.4);
  EXPECT_LT(result.report.mesh.triangles, 10'000u);
  EXPECT_LE(*result.report.sag.reached, *result.report.sag.asked);
}

TEST(ReachSag, HoldsBesideExtraordinaryVerticesWithHardlyAFlatTriangle) {
  const std::filesystem::path car =
      std::filesystem::path(SURFMESH_SHARED_DIR) / "models" / "opensubdiv" / "catmark_car.obj";
  if (!std::filesystem::exists(car)) GTEST_SKIP() << car;
  ModelInput input = load_model(car);
  input.options.sizing.sag = Length::share(0.0002);
  const Report report = mesh_model(input.model, input.sources, input.options).report;
  EXPECT_LT(report.quality.below_0_3, 5e-4);
  EXPECT_LE(*report.sag.reached, *report.sag.asked);
  EXPECT_TRUE(texts_of(report.notices, Severity::Shortfall).empty());
}

TEST(ReachSag, CountsItsEvaluations) {
  const Model model = testing::torus_of(3);
  PipelineOptions options = with_sag(0.005);
  options.threads = 1;
  const Report::Sag one = mesh_model(model, {}, options).report.sag;
  options.threads = 2;
  EXPECT_EQ(mesh_model(model, {}, options).report.sag.evaluations, one.evaluations);
  EXPECT_FALSE(mesh_model(model, {}, {}).report.sag.evaluations.has_value());
}

TEST(ReachSag, TakesAtMost150EvaluationsATriangle) {
  const std::filesystem::path shared(SURFMESH_SHARED_DIR);
  for (const auto& file : {shared / "models" / "spot_control_mesh.obj",
                           shared / "models" / "opensubdiv" / "catmark_pawn.obj",
                           shared / "cases" / "trial" / "mug.obj"}) {
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    ModelInput input = load_model(file);
    input.options.sizing.sag = Length::share(0.0005);
    const Report report = mesh_model(input.model, input.sources, input.options).report;
    EXPECT_LT(*report.sag.evaluations, 150 * report.mesh.triangles) << file;
    EXPECT_GT(*report.sag.evaluations, 20 * report.mesh.triangles) << file;
  }
}

TEST(ReachSag, IsReachedByCorrectionsAloneOnATriangulationOfNodes) {
  PipelineOptions options = with_sag(0.01);
  options.control.kind = ControlKind::Mesh;
  MeshCounter counter;
  const MeshResult result = mesh_model(testing::torus_of(3), {}, options, &counter);
  testing::expect_valid(result.mesh);
  EXPECT_EQ(counter.count, 1);
  EXPECT_LE(*result.report.sag.reached, 0.01);
  EXPECT_GT(*result.report.sag.reached, 0.005);
  EXPECT_TRUE(texts_of(result.report.notices, Severity::Shortfall).empty());
}

TEST(ReachSag, HoldsTogetherWithCurvature) {
  PipelineOptions options = with_sag(0.05);
  options.sizing.curvature = 0.15;
  const Model model = testing::torus_of(3);
  const std::size_t both = mesh_model(model, {}, options).report.mesh.triangles;
  EXPECT_GT(both, 2 * mesh_with_sag(model, 0.05).report.mesh.triangles);
}

TEST(ReachSag, LeavesSizesOfTheUserAsTheyAre) {
  const Model model = testing::torus_of(3);
  Sources sources;
  sources.everywhere.push_back({0, {Length::units(0.1), Length::units(0.1), 0}});
  const MeshResult result = mesh_model(model, sources, with_sag(0.05));
  const auto coarse = mesh_with_sag(model, 0.05).report.mesh.triangles;
  EXPECT_GT(result.report.mesh.triangles, 3 * coarse);
  EXPECT_TRUE(texts_of(result.report.notices, Severity::Warning).empty());
}

/// A size at a point holds there, and only there.
TEST(ReachSag, KeepsASizeAtAPointLocal) {
  const Model model = testing::cylinder_of(1);
  Sources sources;
  sources.at.push_back({0, {pi, 0.5}, {Length::units(0.01), Length::units(0.01), 0}});
  const auto without = mesh_with_sag(model, 0.005).report.mesh.triangles;
  const auto with = mesh_model(model, sources, with_sag(0.005)).report.mesh.triangles;
  EXPECT_GT(with, without + 20);
  EXPECT_LT(with, without + 2000);
}

TEST(ReachSag, MakesRoundHolesRound) {
  const MeshResult result = mesh_with_sag(testing::square_with_hole(0.5), 0.001);
  const auto contour_of = require(result.mesh, keys::edge_contour);
  for (const EdgeHandle eh : result.mesh.edges()) {
    const HalfedgeHandle heh = result.mesh.halfedge_handle(eh, 0);
    const Vec3 a = to_eigen(result.mesh.point(result.mesh.from_vertex_handle(heh)));
    const Vec3 b = to_eigen(result.mesh.point(result.mesh.to_vertex_handle(heh)));
    if (result.mesh.property(contour_of, eh) < 4) continue;  // inner edges and the square's
    EXPECT_GE((0.5 * (a + b)).norm(), 0.5 - 0.001);
  }
}

TEST(ReachSag, WorksOnAGrid) {
  PipelineOptions options = with_sag(0.01);
  options.control.kind = ControlKind::Grid;
  const MeshResult result = mesh_model(testing::torus_of(3), {}, options);
  EXPECT_TRUE(texts_of(result.report.notices, Severity::Shortfall).empty());
}

TEST(ReachSag, GivesTheSameMeshTwice) {
  const Model model = corrugated();
  const MeshResult a = mesh_with_sag(model, 0.01), b = mesh_with_sag(model, 0.01);
  ASSERT_EQ(a.mesh.n_vertices(), b.mesh.n_vertices());
  EXPECT_EQ(a.report.sag.reached, b.report.sag.reached);
  EXPECT_EQ(a.report.edges, b.report.edges);
}

/// Two squares side by side, the second one higher by a gap.
Model squares_apart(double gap, double tolerance) {
  testing::HandMade made;
  std::vector<int> vertices;
  for (const Uv uv : {Uv{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}}) {
    vertices.push_back(made.add_vertex({uv.u, uv.v, uv.u > 1 ? gap : 0}));
  }
  const int left = made.add_patch(testing::rectangle(0, 0, 1, 1));
  const int right = made.add_patch(std::make_shared<test::PlanePatch>(
      Vec3(0, 0, gap), Vec3::UnitX(), Vec3::UnitY(), Domain{1, 2, 0, 1}));
  made.add_loop(left, {{0, {0, 0}}, {1, {1, 0}}, {2, {1, 1}}, {3, {0, 1}}});
  made.model.patch(right).loops = {{made.add_use(made.add_contour(1, 4), right, {1, 0}, {2, 0}),
                                    made.add_use(made.add_contour(4, 5), right, {2, 0}, {2, 1}),
                                    made.add_use(made.add_contour(5, 2), right, {2, 1}, {1, 1}),
                                    made.add_use(1, right, {1, 0}, {1, 1}, false)}};
  for (Contour& contour : made.model.contours) contour.tolerance = tolerance;
  finish(made.model);
  return made.model;
}

TEST(ReachSag, AsksForNoLessThanTheGapsOfTheModel) {
  const MeshResult result = mesh_with_sag(squares_apart(1e-3, 1.1e-3), 1e-4);
  EXPECT_DOUBLE_EQ(result.report.tolerance, 1.1e-3);
  EXPECT_DOUBLE_EQ(*result.report.sag.asked, 2.2e-3);
  EXPECT_LE(*result.report.sag.reached, 2.2e-3);
  ASSERT_EQ(result.report.notices.size(), 1U);
  EXPECT_EQ(result.report.notices[0].kind, NoticeKind::LooseFit);
  EXPECT_EQ(result.report.notices[0].severity, Severity::Shortfall);
}

}  // namespace
}  // namespace surfmesh
