// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/make_control.hh"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

#include "cage/cages.hh"
#include "support/analytic.hh"
#include "support/errors.hh"
#include "support/tensors.hh"
#include "support/waves.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/sampling/accurate_nodes.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::expect_near;
using testing::size_of;
using testing::sizing_of;

double root_of_determinant(const FirstFormFactor& form, const SizeTensor& size) {
  return form.l11 * form.l22 / determinant(size);
}

/// ∫√det M of field and control space at one random point in each of n × n cells.
MetricArea stratified_area(const SizeField& field, const ControlSpace& control, int n) {
  std::mt19937_64 random(20240229);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Domain domain = field.surface().domain();
  QueryHint hint;
  MetricArea area;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double s = (i + uniform(random)) / n;
      const Uv uv = domain.at(s, (j + uniform(random)) / n);
      const SizeField::Sample sample = field.at(uv);
      area.exact += root_of_determinant(sample.form, sample.size);
      area.control +=
          root_of_determinant(sample.form, control.size({uv, sample.point, sample.form}, hint));
    }
  }
  const double cell = (domain.u1 - domain.u0) * (domain.v1 - domain.v0) / n / n;
  return {cell * area.exact, cell * area.control};
}

std::unique_ptr<ControlSpace> control_of(const Surface& surface, const Sizing& sizing,
                                         const PatchSources& sources = {},
                                         const ControlOptions& options = {}) {
  ControlInput input = collect_control_input(surface, resolve(sizing, 1), sources, options);
  std::unique_ptr<ControlSpace> control = make_control(input);
  finish(*control);
  return control;
}

constexpr ControlOptions kAsMesh = {.kind = ControlKind::Mesh};

SizeTensor query(const ControlSpace& control, Uv uv) {
  QueryHint hint;
  return control.size({uv, Vec3(uv.u, uv.v, 0), {1, 0, 1}}, hint);
}

// --- the metric area ---

struct AreaCase {
  const char* name;
  std::shared_ptr<const Surface> surface;
  Sizing sizing;
};

void PrintTo(const AreaCase& area, std::ostream* out) { *out << area.name; }

class MetricAreaOf : public ::testing::TestWithParam<AreaCase> {};

TEST_P(MetricAreaOf, IsHeldByAMeshToTwoPercent) {
  const AreaCase& c = GetParam();
  const SizeField field(*c.surface, resolve(c.sizing, 1), {});
  const auto control = control_of(*c.surface, c.sizing, {}, kAsMesh);
  const MetricArea area = stratified_area(field, *control, 150);
  EXPECT_NEAR(area.control, area.exact, 0.02 * area.exact);
}

TEST_P(MetricAreaOf, IsHeldByCellsToFourPercent) {
  const AreaCase& c = GetParam();
  const SizeField field(*c.surface, resolve(c.sizing, 1), {});
  const MetricArea area = stratified_area(field, *control_of(*c.surface, c.sizing), 150);
  EXPECT_NEAR(area.control, area.exact, 0.04 * area.exact);
}

TEST(MetricArea, IsHeldBetterByAFinerPrecision) {
  const auto wave = testing::paper_wave();
  const SizeField field(*wave, resolve(testing::paper_sizing(), 1), {});
  const auto error_at = [&](double precision) {
    const auto control = control_of(*wave, testing::paper_sizing(), {}, {.precision = precision});
    const MetricArea area = stratified_area(field, *control, 150);
    return std::abs(area.control - area.exact) / area.exact;
  };
  EXPECT_LT(error_at(0.05), error_at(0.1));
  EXPECT_LT(error_at(0.03), 0.01);
}

TEST_P(MetricAreaOf, IsEstimatedToOnePercent) {
  const AreaCase& c = GetParam();
  const SizeField field(*c.surface, resolve(c.sizing, 1), {});
  const auto control = control_of(*c.surface, c.sizing);
  const MetricArea area = stratified_area(field, *control, 150);
  const MetricArea estimate = metric_area(field, *control, 20'000);
  EXPECT_NEAR(estimate.exact, area.exact, 0.01 * area.exact);
  EXPECT_NEAR(estimate.control, area.control, 0.01 * area.control);
}

std::vector<AreaCase> area_cases() {
  const auto sphere = std::make_shared<test::Sphere>(1, Domain{0, 2 * pi, -pi / 2, pi / 2});
  const auto torus = std::make_shared<test::Torus>(2, 0.5, Domain{0, 2 * pi, 0, 2 * pi});
  return {{"PaperWave", testing::paper_wave(), testing::paper_sizing()},
          {"PaperWaveAtTwoScales", testing::paper_wave(1e6, 1e-3), testing::paper_sizing()},
          {"Sphere", sphere, sizing_of(0.1, 0.001, 1, 2)},
          {"Torus", torus, sizing_of(0.1, 0.001, 1, 2)},
          {"StretchedTorus", torus, sizing_of(0.1, 0.001, 1, 100)},
          {"SineWave", testing::sine_wave(), sizing_of(0.1, 0.001, 1, 5)},
          {"HalfBentSheet", testing::half_bent_sheet(), sizing_of(0.1, 0.001, 0.3, 5)},
          {"CubePatch", make_limit_surfaces(testing::cube(), Scheme::Auto).front(),
           sizing_of(0.1, 0.001, 1, 2)},
          {"Saddle", make_limit_surfaces(testing::quad_fan(5), Scheme::Auto).front(),
           sizing_of(0.1, 0.001, 1, 2)}};
}

INSTANTIATE_TEST_SUITE_P(Surfaces, MetricAreaOf, ::testing::ValuesIn(area_cases()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(MetricArea, OfASphereIsItsAreaOverTheSquareOfTheSize) {
  const test::Sphere sphere(1, {0, 2 * pi, -pi / 2, pi / 2});
  const SizeField field(sphere, resolve(sizing_of(0.1, 0.001, 1, 2), 1), {});
  const auto control = control_of(sphere, sizing_of(0.1, 0.001, 1, 2));
  const MetricArea area = metric_area(field, *control, 20'000);
  EXPECT_NEAR(area.exact, 400 * pi, 4 * pi);
  EXPECT_NEAR(area.control, 400 * pi, 4 * pi);
}

TEST(MetricArea, OfATriangleIsHalfThatOfItsRectangle) {
  const test::PlanePatch triangle(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(),
                                  {0, 1, 0, 1, Domain::Shape::Triangle});
  const Sizing sizing = sizing_of(0, 0.01, 0.1, 2);
  const MetricArea area = metric_area(SizeField(triangle, resolve(sizing, 1), {}),
                                      *control_of(triangle, sizing), 20'000);
  EXPECT_NEAR(area.exact, 50, 0.5);
}

// --- sources at points ---

test::PlanePatch plane(const Domain& domain = {}) {
  return {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), domain};
}

/// Shares of points, independent of those that the choice looks at, that miss the precision of 0.1
/// and three times it.
std::pair<double, double> misses_of(const Surface& surface, const Sizing& sizing) {
  constexpr int samples = 20'000;
  constexpr double precision = 0.1;
  const SizeField field(surface, resolve(sizing, 1), {}, precision);
  const auto nodes = choose_accurate_nodes(field, {0, precision}).nodes;
  const ControlMesh control(surface.domain(), nodes, {});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  QueryHint hint;
  int once = 0, thrice = 0;
  for (int i = 0; i < samples; ++i) {
    const double s = uniform(random);
    const Uv uv = surface.domain().at(s, uniform(random));
    const SizeField::Sample exact = field.at(uv);
    const double miss =
        log_conformity(exact.size, control.size({uv, exact.point, exact.form}, hint));
    once += miss > precision ? 1 : 0;
    thrice += miss > 3 * precision ? 1 : 0;
  }
  return {double(once) / samples, double(thrice) / samples};
}

TEST(AccurateNodes, HoldASmoothFieldToThePrecisionAtNearlyAllPoints) {
  // The outside of a torus, where no curvature is zero, has no kinks in its sizes.
  const test::Torus torus(3, 1, {0, 6, -1, 1});
  const auto [once, thrice] = misses_of(torus, sizing_of(0.25, 1e-3, 100, 100));
  EXPECT_LE(once, 0.01);
  EXPECT_EQ(thrice, 0);
}

TEST(AccurateNodes, HoldAFieldWithKinksAtMostPoints) {
  const auto [once, thrice] = misses_of(*testing::paper_wave(), testing::paper_sizing());
  EXPECT_LE(once, 0.02);
  EXPECT_EQ(thrice, 0);
}

TEST(MakeControl, TakesTheMinimumOfPointAndAreaSources) {
  const auto surface = plane();
  const PatchSources sources{{{0, size_of(0.3)}}, {{0, {0.4, 0.6}, size_of(0.1, 0.9)}}};
  const auto control = control_of(surface, sizing_of(0, 0.01, 1, 2), sources);
  expect_near(query(*control, {0.4, 0.6}), {0.1, 0, 0.3}, 1e-9);
  expect_near(query(*control, {0, 0}), isotropic(0.3), 1e-9);
}

TEST(MakeControl, ClampsSizesAtPoints) {
  const auto surface = plane();
  const PatchSources sources{{}, {{0, {0.4, 0.6}, size_of(0.001, 9)}}};
  const auto control = control_of(surface, sizing_of(0, 0.01, 1, 2), sources);
  expect_near(query(*control, {0.4, 0.6}), {0.01, 0, 1}, 1e-9);
}

TEST(MakeControl, GivesCornersTheNearestSizeWithoutAreaSources) {
  const auto surface = plane();
  const PatchSources sources{{}, {{0, {0.1, 0.1}, size_of(0.1)}, {0, {0.8, 0.9}, size_of(0.4)}}};
  const auto control = control_of(surface, sizing_of(0, 0.01, 1, 2), sources);
  expect_near(query(*control, {0, 0}), isotropic(0.1), 1e-12);
  expect_near(query(*control, {1, 1}), isotropic(0.4), 1e-12);
}

TEST(MakeControl, HasOnlyCornersAndPointsWithoutAreaSources) {
  const auto surface = plane();
  const PatchSources sources{{}, {{0, {0.1, 0.1}, size_of(0.1)}, {0, {0.8, 0.9}, size_of(0.4)}}};
  const Sizing sizing = sizing_of(0, 0.01, 1, 2);
  EXPECT_EQ(control_of(surface, sizing, sources, kAsMesh)->mesh().n_vertices(), 6U);
}

TEST(MakeControl, InterpolatesBetweenPointsWithoutAreaSources) {
  const auto surface = plane();
  const PatchSources sources{{}, {{0, {0, 0.5}, size_of(0.1)}, {0, {1, 0.5}, size_of(0.4)}}};
  const auto control = control_of(surface, sizing_of(0, 0.01, 1, 2), sources);
  EXPECT_NEAR(query(*control, {0.5, 0.5}).h11, 0.25, 0.05);
}

TEST(MakeControl, GivesHmaxWithoutAnySource) {
  const auto surface = plane();
  EXPECT_EQ(query(*control_of(surface, sizing_of(0, 0.01, 0.7, 2)), {0.3, 0.2}), isotropic(0.7));
}

TEST(MakeControl, RefusesAPointOutsideTheDomainByItsPlace) {
  const auto rectangle = plane();
  const auto triangle = plane({0, 1, 0, 1, Domain::Shape::Triangle});
  const auto error = [](const Surface& surface, Uv at) {
    const PatchSources sources{{}, {{0, at, size_of(0.1)}}};
    return error_of([&] { control_of(surface, sizing_of(0, 0.01, 1, 2), sources); });
  };
  EXPECT_NE(error(rectangle, {1.5, 0.25}).find("(u,v) = (1.5, 0.25)"), std::string::npos);
  EXPECT_NE(error(triangle, {0.75, 0.5}).find("(u,v) = (0.75, 0.5)"), std::string::npos);
  EXPECT_NE(error(rectangle, {kUnset, 0}).find("outside"), std::string::npos);
  EXPECT_EQ(error(rectangle, {1, 0}), "no error");
}

TEST(MakeControl, RefusesAPointWithoutSize) {
  const auto surface = plane();
  const PatchSources sources{{}, {{0, {0.5, 0.5}, size_of(-0.1)}}};
  EXPECT_THROW(control_of(surface, sizing_of(0, 0.01, 1, 2), sources), Error);
}

TEST(MakeControl, GradesLast) {
  const auto surface = plane();
  Sizing sizing = sizing_of(0, 0.01, 1, 2);
  sizing.grade = 1.5;
  const PatchSources sources{{{0, size_of(1)}}, {{0, {0.5, 0.5}, size_of(0.05)}}};
  const auto control = control_of(surface, sizing, sources);
  // Along the edges of the control mesh the way to the corner is at most 1 long.
  EXPECT_LE(query(*control, {0, 0}).h11, (0.05 + std::log(1.5)) * 1.01);
}

TEST(MakeControl, TakesRegularNodes) {
  const auto surface = testing::paper_wave();
  const auto control = control_of(*surface, testing::paper_sizing(), {}, {.regular_nodes = 2500});
  EXPECT_EQ(control->mesh().n_vertices(), 2500U);
}

TEST(ControlOptions, SelectAMeshByWhatBelongsToItAlone) {
  EXPECT_EQ(effective_kind({}), ControlKind::Cells);
  EXPECT_EQ(effective_kind({.regular_nodes = 100}), ControlKind::Mesh);
  EXPECT_EQ(effective_kind({.inner_nodes = true}), ControlKind::Mesh);
  EXPECT_EQ(effective_kind({.interpolation = Interpolation::Circles}), ControlKind::Mesh);
  EXPECT_EQ(effective_kind({.lookup = DiscLookup::Vertices}), ControlKind::Mesh);
  EXPECT_EQ(effective_kind({.reuse = 0.5}), ControlKind::Mesh);
  EXPECT_EQ(effective_kind({.kind = ControlKind::Grid, .regular_nodes = 100}), ControlKind::Grid);
}

TEST(ControlOptions, TellWhatHasNoEffectOnTheKindAskedFor) {
  const auto text = [](const ControlOptions& options) {
    const std::optional<Notice> notice = unused_option(options);
    return notice ? notice->text : "";
  };
  EXPECT_EQ(text({.kind = ControlKind::Cells, .regular_nodes = 100}),
            "nodes has no effect with control = cells, but with control = mesh");
  EXPECT_EQ(text({.kind = ControlKind::Grid, .reuse = 0.5}),
            "reuse has no effect with control = grid, but with control = mesh");
  EXPECT_EQ(text({.kind = ControlKind::Grid, .regular_nodes = 100}), "");
  EXPECT_EQ(text({.kind = ControlKind::Mesh, .reuse = 0.5}), "");
  EXPECT_EQ(text({.reuse = 0.5}), "");
}

TEST(MakeControl, ChecksItsOptionsAlsoWithoutAreaSources) {
  const auto surface = plane();
  const PatchSources sources{{}, {{0, {0.5, 0.5}, size_of(0.1)}}};
  EXPECT_THROW(control_of(surface, sizing_of(0, 0.01, 1, 2), sources, {.regular_nodes = 3}), Error);
}

TEST(MakeControl, HoldsPointsAloneOnAGridToo) {
  const auto surface = plane();
  const PatchSources sources{{}, {{0, {0.1, 0.1}, size_of(0.1)}, {0, {0.8, 0.9}, size_of(0.4)}}};
  const Sizing sizing = sizing_of(0, 0.01, 1, 2);
  const auto mesh = control_of(surface, sizing, sources);
  const auto grid = control_of(surface, sizing, sources, {.kind = ControlKind::Grid});
  for (const Uv uv : {Uv{0.1, 0.1}, Uv{0.8, 0.9}, Uv{0.5, 0.5}, Uv{1, 0}}) {
    EXPECT_NEAR(query(*grid, uv).h11, query(*mesh, uv).h11, 0.25 * query(*mesh, uv).h11);
  }
}

TEST(MakeControl, GradesFromTheRimOfADiscOfPointsAlone) {
  const Domain domain{-5, 5, -5, 5};
  const auto surface = plane(domain);
  AtSource at{0, {0, 0}, size_of(0.2)};
  at.radius = Length::units(2);
  const PatchSources sources{{}, {at, {0, {4, 4}, size_of(2)}}};
  Sizing sizing = sizing_of(0, 0.01, 4, 2);
  sizing.grade = 1.5;
  const auto control = control_of(surface, sizing, sources);
  EXPECT_LE(query(*control, {2.5, 0}).h11, 1.3 * (0.2 + std::log(1.5) * 0.5));
}

TEST(MakeControl, SeesASmallSourceInAWidePatch) {
  const Domain domain{-6, 6, -6, 6};
  const auto surface = plane(domain);
  InsideSource inside;
  inside.patch = 0;
  inside.polygon = {{1.1, 2.3}, {1.4, 2.3}, {1.4, 2.6}, {1.1, 2.6}};
  inside.wish.size = size_of(0.02);
  const PatchSources sources{{}, {}, {}, {inside}};
  const auto control = control_of(surface, sizing_of(0, 0.001, 3, 2), sources);
  EXPECT_NEAR(query(*control, {1.25, 2.45}).h11, 0.02, 0.002);
  EXPECT_NEAR(query(*control, {-3, -3}).h11, 3, 0.3);
}

TEST(MakeControl, RefusesMoreNodesThanItCanHold) {
  const auto surface = plane();
  const std::string error = error_of(
      [&] { control_of(surface, sizing_of(0.25, 0.01, 1, 2), {}, {.regular_nodes = 2147483647}); });
  EXPECT_EQ(error.rfind(name(ErrorCode::InvalidOption), 0), 0U) << error;
}

TEST(MakeControl, IsDeterministic) {
  const auto surface = testing::paper_wave();
  const auto a = control_of(*surface, testing::paper_sizing());
  const auto b = control_of(*surface, testing::paper_sizing());
  const auto size = require(a->mesh(), keys::vertex_size);
  ASSERT_EQ(a->mesh().n_vertices(), b->mesh().n_vertices());
  for (const VertexHandle vh : a->mesh().vertices()) {
    ASSERT_EQ(a->mesh().property(size, vh), b->mesh().property(size, vh));
  }
}

}  // namespace
}  // namespace surfmesh
