// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/size_field.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "cage/cages.hh"
#include "support/analytic.hh"
#include "support/errors.hh"
#include "support/tensors.hh"
#include "support/waves.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/geometry/curvature.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/conformity.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::expect_near;
using testing::size_of;
using testing::sizing_of;
using testing::units;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

SizeField field_of(const Surface& surface, const Sizing& sizing,
                   const std::vector<EverywhereSource>& everywhere = {}) {
  return SizeField(surface, resolve(sizing, 1), PatchSources{everywhere, {}});
}

test::PlanePatch plane() { return {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}; }

test::Sphere sphere(double radius) { return {radius, {0, 2 * pi, -pi / 2, pi / 2}}; }

test::Cylinder cylinder(double radius) { return {radius, {0, 2 * pi, 0, 1}}; }

TEST(SizeField, OnASphereIsTheFactorTimesTheRadius) {
  const auto surface = sphere(2);
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 10, 2));
  for (const Uv uv : {Uv{0, 0}, Uv{1, 1.2}, Uv{5, -1.5}}) {
    expect_near(field.at(uv).size, isotropic(0.5), 1e-12);
  }
}

TEST(SizeField, OnACylinderIsStretchedAlongTheAxis) {
  const auto surface = cylinder(2);
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 10, 3));
  expect_near(field.at({1, 0.3}).size, {0.5, 0, 1.5}, 1e-12);
}

TEST(SizeField, IsIsotropicOnRequestWhateverTheSources) {
  const auto surface = cylinder(2);
  Sizing sizing = sizing_of(0.25, 0.01, 10, 3);
  sizing.isotropic = true;
  expect_near(field_of(surface, sizing).at({1, 0.3}).size, isotropic(0.5), 1e-12);
  const EverywhereSource stretched{0, {units(0.1), units(0.4), 0.3}};
  expect_near(field_of(surface, sizing, {stretched}).at({1, 0.3}).size, isotropic(0.1), 1e-12);
}

TEST(SizeField, OnATorusFollowsBothCurvatures) {
  const test::Torus surface(3, 1, {0, 2 * pi, 0, 2 * pi});
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 10, 100));
  expect_near(field.at({1, 0}).size, {0.25 * 4, 0, 0.25}, 1e-12);
  expect_near(field.at({1, pi}).size, {0.25 * 2, 0, 0.25}, 1e-12);
}

TEST(SizeField, IsNearlyTheSameByDifferences) {
  const test::Torus surface(3, 1, {0, 2 * pi, 0, 2 * pi});
  Sizing sizing = sizing_of(0.25, 0.01, 10, 100);
  const SizeField exact = field_of(surface, sizing);
  sizing.curvature_from = CurvatureFrom::Differences;
  const SizeField found = field_of(surface, sizing);
  for (const Uv uv : {Uv{1, 1}, Uv{3, 0.2}, Uv{0, 4}}) {
    expect_near(found.at(uv).size, exact.at(uv).size, 0.01);
  }
}

TEST(SizeField, OnAPlaneIsTheLargest) {
  const auto surface = plane();
  EXPECT_EQ(field_of(surface, sizing_of(0.25, 0.01, 0.7, 2)).at({0.3, 0.4}).size, isotropic(0.7));
}

TEST(SizeField, WithoutCurvatureIsTheLargest) {
  const auto surface = sphere(0.1);
  EXPECT_EQ(field_of(surface, sizing_of(0, 0.01, 0.7, 2)).at({0.3, 0.4}).size, isotropic(0.7));
}

TEST(SizeField, IsClampedToTheLargestInEachDirection) {
  const auto surface = cylinder(2);
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 10, 1e6));
  expect_near(field.at({1, 0.3}).size, {0.5, 0, 10}, 1e-12);
}

TEST(SizeField, IsClampedBeforeItsStretchIsLimited) {
  const auto surface = cylinder(0.001);
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 10, 2));
  expect_near(field.at({1, 0.3}).size, {0.01, 0, 0.02}, 1e-12);
}

TEST(SizeField, GrowsWithTheModel) {
  const auto base = std::make_shared<test::Torus>(3, 1, Domain{0, 2 * pi, 0, 2 * pi});
  const test::Placed large(base, 1e6, Vec3(1, 2, 3));
  const Sizing sizing{.curvature = 0.25, .stretch = 2, .grade = 0};
  const SizeField field(*base, resolve(sizing, 8), {}), grown(large, resolve(sizing, 8e6), {});
  expect_near(grown.at({1, 2}).size, scaled(field.at({1, 2}).size, 1e6), 1e-9);
}

TEST(SizeField, TellsPositionAndFirstForm) {
  const auto surface = cylinder(2);
  const SizeField::Sample sample = field_of(surface, sizing_of(0.25, 0.01, 10, 2)).at({pi / 2, 1});
  EXPECT_LT((sample.point - Vec3(0, 2, 1)).norm(), 1e-15);
  EXPECT_NEAR(sample.form.l11, 2, 1e-15);
  EXPECT_NEAR(sample.form.l22, 1, 1e-15);
}

TEST(SizeField, IsThatOfAPoleOnThePole) {
  const auto surface = sphere(2);
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 10, 2));
  expect_near(field.at({1, pi / 2}).size, isotropic(0.5), 1e-9);
  expect_near(field.at({1, -pi / 2}).size, isotropic(0.5), 1e-9);
}

TEST(SizeField, TakesTheMinimumWithTheSizeEverywhere) {
  const auto surface = cylinder(2);
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 10, 1e6), {{0, size_of(1)}});
  expect_near(field.at({1, 0.3}).size, {0.5, 0, 1}, 1e-9);
}

TEST(SizeField, ClampsASizeEverywhereButKeepsItsStretch) {
  const auto surface = plane();
  const SizeField field =
      field_of(surface, sizing_of(0.25, 0.01, 0.7, 2), {{0, size_of(9, 0.001)}});
  expect_near(field.at({0.5, 0.5}).size, {0.7, 0, 0.01}, 1e-12);
}

TEST(SizeField, IsNeverBelowTheSmallestWhereSizesCross) {
  // The minimum of two stretched sizes is shorter than both.
  const auto surface = plane();
  const SizeField field = field_of(surface, sizing_of(0, 0.02, 1, 2),
                                   {{0, size_of(1, 0.02)}, {0, size_of(1, 0.02, 0.05)}});
  EXPECT_GE(principal_sizes(field.at({0.5, 0.5}).size).l_t, 0.02 * (1 - 1e-12));
}

// (1 - t) * v1 + t * v1 may be above v1.
TEST(SizeField, HasItsRequiredPointsInTheDomain) {
  const Domain domain{0.376382, 9.15352, -1.22217, 7.18513};
  const test::PlanePatch plane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), domain);
  PatchSources sources;
  TableSource& table = sources.tables.emplace_back();
  for (const double u : {domain.u0, 6.1, domain.u1}) {
    for (const double v : {domain.v0, domain.v1}) table.nodes.push_back({{u, v}, size_of(0.3)});
  }
  const SizeField field(plane, resolve(Sizing(), 1), sources);
  ASSERT_GT(field.required_points().size(), 10u);
  for (const Uv uv : field.required_points()) EXPECT_EQ(domain.clamp(uv), uv);
}

TEST(SizeField, KnowsWhetherItHasASource) {
  const auto surface = plane();
  EXPECT_FALSE(field_of(surface, sizing_of(0, 0.01, 1, 2)).has_source());
  EXPECT_TRUE(field_of(surface, sizing_of(0.25, 0.01, 1, 2)).has_source());
  EXPECT_TRUE(field_of(surface, sizing_of(0, 0.01, 1, 2), {{0, size_of(0.5)}}).has_source());
}

TEST(SizeField, TellsTheKindOfItsErrors) {
  const auto surface = plane();
  const auto bad_sizing = [&] { field_of(surface, sizing_of(-1, 0.01, 1, 2)); };
  const auto bad_source = [&] { field_of(surface, sizing_of(1, 0.01, 1, 2), {{0, size_of(0)}}); };
  EXPECT_EQ(error_of(bad_sizing).rfind(name(ErrorCode::InvalidOption), 0), 0U);
  EXPECT_EQ(error_of(bad_source).rfind(name(ErrorCode::InvalidInput), 0), 0U);
}

TEST(SizeField, RefusesSizesThatAreNoLengths) {
  const auto surface = plane();
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 1, 2));
  for (const double bad : {0.0, -1.0, kUnset, kInfinity}) {
    EXPECT_THROW(field.bounds().tensor(size_of(bad, 1)), Error);
    EXPECT_THROW(field.bounds().tensor(size_of(1, bad)), Error);
  }
  EXPECT_THROW(field.bounds().tensor(size_of(1, 1, kUnset)), Error);
}

TEST(SizeField, TakesSharesOfTheDiagonal) {
  const auto surface = plane();
  const SizeField field(surface, resolve({.curvature = 0, .stretch = 2, .grade = 0}, 50), {});
  EXPECT_DOUBLE_EQ(field.bounds().hmin, 0.05);
  EXPECT_DOUBLE_EQ(field.bounds().hmax, 10);
  expect_near(field.bounds().tensor({Length::share(0.1), Length::units(0.5), 0}), {5, 0, 0.5},
              1e-15);
}

TEST(SizeField, IsMirroredBeyondTheDiagonalOfATriangle) {
  const test::Torus surface(3, 1, {0, 2, 0, 1, Domain::Shape::Triangle});
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 10, 5));
  EXPECT_EQ(field.at({1.5, 0.75}).size, field.at({0.5, 0.25}).size);
  EXPECT_EQ(field.at({2, 1}).point, field.at({0, 0}).point);
}

// --- extraordinary vertices ---

/// The patches of a cage at one extraordinary vertex, each with its corner there.
struct Corner {
  std::shared_ptr<const Surface> surface;
  Uv at;
};

Corner corner_of(const Cage& cage, int level = 8) {
  for (const auto& surface : make_limit_surfaces(cage, Scheme::Auto, level)) {
    if (!surface->singular_points().empty()) return {surface, surface->singular_points()[0].at};
  }
  return {};
}

/// A point at a share of the way from the corner to the middle of the unit square.
Uv near_corner(Uv corner, double share) { return lerp(corner, {0.5, 0.5}, share); }

class ExtraordinaryVertex : public ::testing::TestWithParam<int> {
 protected:
  static Cage cage() { return GetParam() == 3 ? testing::cube() : testing::quad_fan(GetParam()); }
  static Sizing sizing() { return sizing_of(0.25, 1e-4, 10, 2); }
};

TEST_P(ExtraordinaryVertex, HasTheSameIsotropicSizeHoweverNearOneLooks) {
  const Corner corner = corner_of(cage());
  const SizeField field = field_of(*corner.surface, sizing());
  const SizeTensor size = field.at(corner.at).size;
  EXPECT_LT(log_conformity(size, isotropic(size.h11)), 1e-12);
  for (const double share : {1e-2, 1e-3, 1e-5, 1e-9}) {
    EXPECT_EQ(field.at(near_corner(corner.at, share)).size, size) << share;
  }
}

TEST_P(ExtraordinaryVertex, IsFarFromTheBoundsOfSizes) {
  const Corner corner = corner_of(cage());
  const double size = field_of(*corner.surface, sizing()).at(corner.at).size.h11;
  EXPECT_GT(size, 0.02);
  EXPECT_LT(size, 2);
}

TEST_P(ExtraordinaryVertex, HasTheSizeOfTheRingAtHalfOfIt) {
  // Curvature at the distance h/2 from the vertex gives h, up to the steps by two of the rings.
  const Corner corner = corner_of(cage());
  const SizeField field = field_of(*corner.surface, sizing());
  const double h = field.at(corner.at).size.h11;
  const Vec3 centre = field.at(corner.at).point;
  double share = 1;
  while ((field.at(near_corner(corner.at, share)).point - centre).norm() > 0.5 * h) share *= 0.99;
  const Jet jet = corner.surface->evaluate(near_corner(corner.at, share), Order::Second);
  const PrincipalCurvatures k = principal_curvatures(jet);
  const double expected = 0.25 / std::max(std::abs(k.k1), std::abs(k.k2));
  EXPECT_LT(std::abs(std::log(h / expected)), std::log(2.0)) << h << " " << expected;
}

TEST_P(ExtraordinaryVertex, IsBlendedWithoutAJump) {
  const Corner corner = corner_of(cage());
  const SizeField field = field_of(*corner.surface, sizing());
  SizeTensor last = field.at(corner.at).size;
  for (int i = 1; i <= 2000; ++i) {
    const SizeTensor size = field.at(near_corner(corner.at, i / 2000.0)).size;
    ASSERT_LT(log_conformity(last, size), 0.1) << i;
    last = size;
  }
}

TEST_P(ExtraordinaryVertex, HardlyDependsOnTheLevelOfApproximation) {
  const Corner coarse = corner_of(cage(), 6), fine = corner_of(cage(), 8);
  const SizeField a = field_of(*coarse.surface, sizing()), b = field_of(*fine.surface, sizing());
  for (const double share : {0.0, 1e-6, 1e-3, 0.03, 0.1, 0.3, 0.9}) {
    const Uv uv = near_corner(fine.at, share);
    EXPECT_LT(log_conformity(a.at(uv).size, b.at(uv).size), 0.03) << share;
  }
}

TEST(SizeField, IsIsotropicAroundAnExtraordinaryVertexInTheMiddleOfASide) {
  const Model model = model_from_cage(testing::quad_fan(6));
  for (const Patch& patch : model.patches) {
    const SizeField field = field_of(*patch.surface, sizing_of(0.25, 1e-4, 10, 2));
    for (const SingularPoint& singular : patch.surface->singular_points()) {
      if (singular.at.u != 1) continue;
      const SizeTensor size = field.at(singular.at).size;
      EXPECT_LT(log_conformity(size, isotropic(size.h11)), 1e-12);
      for (const double share : {1e-3, 1e-9}) {
        EXPECT_EQ(field.at(lerp(singular.at, {0, 0.5}, share)).size, size);
        EXPECT_EQ(field.at(lerp(singular.at, {2, 0.5}, share)).size, size);
      }
    }
  }
}

/// A cylinder that is wound up twice, of 16 cells, with an extraordinary vertex at its beginning.
struct WoundUp : test::Cylinder {
  WoundUp() : Cylinder(2, {0, 4 * pi, 0, 1}) {}
  CellCount cells() const override { return {16, 1}; }
  std::vector<SingularPoint> singular_points() const override { return {{{0, 0}, 1e-3}}; }
};

TEST(SizeField, IsIsotropicInTheCellsAroundAnExtraordinaryVertexOnly) {
  const WoundUp surface;
  const SizeField field = field_of(surface, sizing_of(0.25, 0.01, 10, 3));
  expect_near(field.at({0.05, 0.05}).size, isotropic(0.5), 1e-12);
  // The same place in space, but on the other layer.
  expect_near(field.at({2 * pi + 0.05, 0.05}).size, {0.5, 0, 1.5}, 1e-12);
}

TEST(SizeField, HasAPlaceInEachFaceOfABlock) {
  const Model model = model_from_cage(testing::sheet(3, 2));
  const SizeField field = field_of(*model.patches[0].surface, sizing_of(0.25, 0.01, 10, 2));
  ASSERT_EQ(field.required_points().size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(std::floor(field.required_points()[k].u), static_cast<double>(k % 3));
    EXPECT_EQ(std::floor(field.required_points()[k].v), static_cast<double>(k / 3));
  }
}

TEST(SizeField, LeavesRoomAroundARing) {
  PatchSources sources;
  sources.rings.push_back({true, 0, 1, {0.4, 0.8}});
  const auto surface = plane();
  const SizeField field(surface, resolve(sizing_of(0, 0.2, 10, 2), 1), sources);
  expect_near(field.at({0.5, 0}).size, {0.1, 0, 10}, 1e-9);
  expect_near(field.at({0.5, 0.5}).size, {0.15, 0, 10}, 1e-9);
  sources.rings[0].is_along_u = false;
  const SizeField across(surface, resolve(sizing_of(0, 0.2, 10, 2), 1), sources);
  expect_near(across.at({1, 0.5}).size, {10, 0, 0.2}, 1e-9);
}

TEST_P(ExtraordinaryVertex, IsAloneWhenCurvatureIsOff) {
  const Corner corner = corner_of(cage());
  const SizeField field = field_of(*corner.surface, sizing_of(0, 0.01, 0.7, 2));
  EXPECT_EQ(field.at(corner.at).size, isotropic(0.7));
}

INSTANTIATE_TEST_SUITE_P(Valence, ExtraordinaryVertex, ::testing::Values(3, 5, 6),
                         ::testing::PrintToStringParamName());

}  // namespace
}  // namespace surfmesh
