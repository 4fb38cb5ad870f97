// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/join_sides.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <string>

#include "support/analytic.hh"
#include "support/errors.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::count_shared;

using Shape = std::shared_ptr<const Surface>;

Shape plane(Vec3 origin, Vec3 a, Vec3 b, Domain domain = {}) {
  return std::make_shared<test::PlanePatch>(origin, a, b, domain);
}

/// The unit square, scaled to the rectangle from (x0, y0) to (x1, y1) in the plane z = 0.
Shape scaled_square(double x0, double y0, double x1, double y1) {
  return plane({x0, y0, 0}, {x1 - x0, 0, 0}, {0, y1 - y0, 0});
}

Shape cylinder(double u0, double u1, double v0 = 0, double v1 = 1) {
  return std::make_shared<test::Cylinder>(1, Domain{u0, u1, v0, v1});
}

Shape sphere(double u0, double u1) {
  return std::make_shared<test::Sphere>(1, Domain{u0, u1, -pi / 2, pi / 2});
}

Shape torus(Domain domain) { return std::make_shared<test::Torus>(2, 0.5, domain); }

std::vector<PatchInput> named(const std::vector<Shape>& shapes) {
  std::vector<PatchInput> result;
  for (const Shape& shape : shapes) {
    result.push_back({std::string("p").append(std::to_string(result.size())), shape});
  }
  return result;
}

int count_uses(const Model& model) {
  int count = 0;
  for (const Contour& contour : model.contours) count += static_cast<int>(contour.uses.size());
  return count;
}

int count_degenerate(const Model& model) {
  return static_cast<int>(std::count_if(model.contours.begin(), model.contours.end(),
                                        [](const Contour& c) { return c.is_degenerate; }));
}

/// V - E + F, without degenerate contours.
int euler(const Model& model) {
  return static_cast<int>(model.vertices.size()) - static_cast<int>(model.contours.size()) +
         count_degenerate(model) + static_cast<int>(model.patches.size());
}

Vec3 place(const Model& model, const ContourUse& use, double t) {
  const Surface& surface = *model.patches[static_cast<std::size_t>(use.patch)].surface;
  return surface.evaluate(use.curve->evaluate(t), Order::Position).point;
}

/// What every contour promises: ends at its vertices on every patch, speed as told.
void expect_valid_contour(const Model& model, const Contour& contour) {
  const Vec3 start = model.vertices[static_cast<std::size_t>(contour.start)].position;
  const Vec3 end = model.vertices[static_cast<std::size_t>(contour.end)].position;
  const double tolerance = 2e-9 * model.diagonal + 1e-14 * start.norm();
  for (const ContourUse& use : contour.uses) {
    EXPECT_LE((place(model, use, 0) - start).norm(), tolerance) << contour.name;
    EXPECT_LE((place(model, use, 1) - end).norm(), tolerance) << contour.name;
    for (const double t : {0.1, 0.5, 0.77}) {
      const double gap = (place(model, use, t) - place(model, contour.uses.front(), t)).norm();
      if (use.is_same_speed) {
        EXPECT_LE(gap, tolerance) << contour.name;
      }
    }
  }
}

/// Each loop goes round the domain once, counter-clockwise, and closes in (u,v).
void expect_valid_loops(const Model& model, const Patch& patch) {
  ASSERT_EQ(patch.loops.size(), 1U);
  double doubled_area = 0;
  std::vector<Uv> corners;
  for (const LoopEntry& entry : patch.loops.front()) {
    const ContourUse& use = model.contours[static_cast<std::size_t>(entry.contour)]
                                .uses[static_cast<std::size_t>(entry.use)];
    corners.push_back(use.curve->evaluate(use.is_forward ? 0 : 1));
    const Uv next = use.curve->evaluate(use.is_forward ? 1 : 0);
    doubled_area += cross(corners.back() - corners.front(), next - corners.front());
  }
  const Domain d = patch.surface->domain();
  const double expected = 2 * (d.u1 - d.u0) * (d.v1 - d.v0);
  EXPECT_NEAR(doubled_area, expected, 1e-9 * expected) << patch.name;
}

Model join(const std::vector<PatchInput>& patches) {
  Model model = model_from_patches(patches);
  EXPECT_NO_THROW(check(model));
  std::set<std::string> names;
  for (const Contour& contour : model.contours) {
    expect_valid_contour(model, contour);
    EXPECT_TRUE(names.insert(contour.name).second) << contour.name;
  }
  for (const Patch& patch : model.patches) expect_valid_loops(model, patch);
  return model;
}

Model join(const std::vector<Shape>& shapes) { return join(named(shapes)); }

void expect_counts(const Model& model, std::size_t vertices, std::size_t contours, int uses) {
  EXPECT_EQ(model.vertices.size(), vertices);
  EXPECT_EQ(model.contours.size(), contours);
  EXPECT_EQ(count_uses(model), uses);
  EXPECT_EQ(texts_of(model.notices), std::vector<std::string>{});
}

const Contour& contour_of(const Model& model, std::string_view side) {
  return model.contours[static_cast<std::size_t>(side_uses(model, side).front().contour)];
}

const ContourUse& use_of(const Model& model, std::string_view side) {
  const LoopEntry entry = side_uses(model, side).front();
  return model.contours[static_cast<std::size_t>(entry.contour)]
      .uses[static_cast<std::size_t>(entry.use)];
}

/// The text of the error that joining gives.
Error joining_error(const std::vector<PatchInput>& patches) {
  try {
    model_from_patches(patches);
  } catch (const Error& error) {
    return error;
  }
  return {ErrorCode::Limit, "no error"};
}

TEST(JoinSides, LeavesOnePlaneAlone) {
  const Model model = join({{"wave", scaled_square(0, 0, 3, 4)}});
  expect_counts(model, 4, 4, 4);
  EXPECT_DOUBLE_EQ(model.diagonal, 5);
  EXPECT_EQ(model.contours[0].name, "wave:v0");
  EXPECT_EQ(model.contours[1].name, "wave:u1");
  EXPECT_EQ(model.contours[2].name, "wave:v1");
  EXPECT_EQ(model.contours[3].name, "wave:u0");
}

TEST(JoinSides, HasThePatchOnTheLeftOfForwardUses) {
  const Model model = join({{"wave", scaled_square(0, 0, 1, 1)}});
  EXPECT_TRUE(use_of(model, "wave:v0").is_forward);
  EXPECT_TRUE(use_of(model, "wave:u1").is_forward);
  EXPECT_FALSE(use_of(model, "wave:v1").is_forward);
  EXPECT_FALSE(use_of(model, "wave:u0").is_forward);
}

TEST(JoinSides, JoinsTwoPlanesOfEqualDirection) {
  const Model model = join({scaled_square(0, 0, 1, 1), scaled_square(1, 0, 2, 1)});
  expect_counts(model, 6, 7, 8);
  const Contour& shared = contour_of(model, "p0:u1");
  EXPECT_EQ(&shared, &contour_of(model, "p1:u0"));
  ASSERT_EQ(shared.uses.size(), 2U);
  EXPECT_TRUE(shared.uses[0].is_forward);
  EXPECT_FALSE(shared.uses[1].is_forward);
  EXPECT_TRUE(shared.uses[1].is_same_speed);
}

TEST(JoinSides, JoinsTwoPlanesOfOppositeDirection) {
  const Model model = join({scaled_square(0, 0, 1, 1), plane({2, 1, 0}, {-1, 0, 0}, {0, -1, 0})});
  expect_counts(model, 6, 7, 8);
  const Contour& shared = contour_of(model, "p1:u1");
  ASSERT_EQ(shared.uses.size(), 2U);
  EXPECT_EQ(shared.uses[1].curve->evaluate(0), (Uv{1, 1}));
  EXPECT_FALSE(shared.uses[1].is_forward);
  EXPECT_TRUE(shared.uses[1].is_same_speed);
}

TEST(JoinSides, JoinsPlanesThatMeetInUAndV) {
  const Model model = join({scaled_square(0, 0, 1, 1), plane({1, 1, 0}, {0, -1, 0}, {1, 0, 0})});
  expect_counts(model, 6, 7, 8);
  EXPECT_EQ(&contour_of(model, "p0:u1"), &contour_of(model, "p1:v0"));
}

TEST(JoinSides, JoinsSidesOfDifferentSpeed) {
  const auto fast = std::make_shared<test::Reparametrised>(scaled_square(0, 1, 1, 2));
  const Model model = join({scaled_square(0, 0, 1, 1), fast});
  expect_counts(model, 6, 7, 8);
  const Contour& shared = contour_of(model, "p0:v1");
  ASSERT_EQ(shared.uses.size(), 2U);
  EXPECT_TRUE(shared.uses[0].is_same_speed);
  EXPECT_FALSE(shared.uses[1].is_same_speed);
}

TEST(JoinSides, DividesALongSideAtItsNeighbours) {
  const Model model =
      join({scaled_square(0, 0, 2, 1), scaled_square(0, 1, 0.7, 2), scaled_square(0.7, 1, 2, 2)});
  expect_counts(model, 8, 10, 13);
  const std::vector<LoopEntry> parts = side_uses(model, "p0:v1");
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].contour, side_uses(model, "p1:v0").front().contour);
  EXPECT_EQ(parts[1].contour, side_uses(model, "p2:v0").front().contour);
  EXPECT_EQ(contour_of(model, "p1:v0").name, "p1:v0");
}

TEST(JoinSides, DividesALongSideOfDifferentSpeed) {
  const auto fast = std::make_shared<test::Reparametrised>(scaled_square(0, 0, 2, 1));
  const Model model = join({fast, scaled_square(0, 1, 0.7, 2), scaled_square(2, 1, 0.7, 2)});
  expect_counts(model, 8, 10, 13);
  EXPECT_FALSE(use_of(model, "p1:v0").is_same_speed);
}

TEST(JoinSides, JoinsThePartWhereSidesOverlap) {
  const Model model = join({scaled_square(0, 0, 2, 1), scaled_square(1, 1, 3, 2)});
  expect_counts(model, 8, 9, 10);
  EXPECT_EQ(count_shared(model), 1);
  EXPECT_EQ(contour_of(model, "p0:v1").name, "p0:v1#0");
  EXPECT_EQ(side_uses(model, "p0:v1")[1].contour, side_uses(model, "p1:v0")[0].contour);
}

TEST(JoinSides, SharesOneSideBetweenThreePatches) {
  const Model model = join({scaled_square(0, 0, 1, 1), scaled_square(0, 0, 1, -1),
                            plane({0, 0, 0}, {1, 0, 0}, {0, 0, 1})});
  expect_counts(model, 8, 10, 12);
  EXPECT_EQ(contour_of(model, "p0:v0").uses.size(), 3U);
}

TEST(JoinSides, KeepsSidesApartThatShareTheirEndsOnly) {
  const auto bulged = std::make_shared<test::Cylinder>(1, Domain{0, pi, 0, 1});
  const Model model = join({bulged, plane({-1, 0, 0}, {2, 0, 0}, {0, 0, 1})});
  expect_counts(model, 4, 6, 8);
}

TEST(JoinSides, UsesTheSeamOfACylinderTwice) {
  const Model model = join({cylinder(0, 2 * pi)});
  expect_counts(model, 2, 3, 4);
  const Contour& seam = contour_of(model, "p0:u0");
  ASSERT_EQ(seam.uses.size(), 2U);
  EXPECT_NE(seam.uses[0].is_forward, seam.uses[1].is_forward);
  EXPECT_EQ(contour_of(model, "p0:v0").start, contour_of(model, "p0:v0").end);
  EXPECT_FALSE(contour_of(model, "p0:v0").is_degenerate);
}

TEST(JoinSides, JoinsTheHalvesOfACylinder) {
  const Model model = join({cylinder(0, pi), cylinder(pi, 2 * pi)});
  expect_counts(model, 4, 6, 8);
  EXPECT_EQ(euler(model), 0);
}

TEST(JoinSides, JoinsClosedCirclesThatStartElsewhere) {
  const Model model = join({cylinder(0, 2 * pi, 0, 1), cylinder(1, 1 + 2 * pi, 1, 2)});
  expect_counts(model, 4, 6, 10);
  EXPECT_EQ(count_shared(model), 4);
  EXPECT_EQ(euler(model), 0);
}

/// A cone and a cylinder on its rim, which runs the other way when mirrored.
TEST(JoinSides, JoinsClosedCirclesInEitherDirection) {
  const auto cone = std::make_shared<test::Cone>(1, Domain{0, 2 * pi, 0, 1});
  const auto mirrored =
      std::make_shared<test::Placed>(cylinder(-pi, pi, -2, -1), -1, Vec3(0, 0, 0));
  for (const Shape& other : {cylinder(0, 2 * pi, 1, 2), Shape(mirrored)}) {
    const Model model = join({cone, other});
    expect_counts(model, 3, 5, 8);
    EXPECT_EQ(count_shared(model), 3);
    EXPECT_EQ(euler(model), 1);
  }
}

TEST(JoinSides, JoinsClosedCirclesOfDifferentSpeedAndDirection) {
  const auto fast = std::make_shared<test::Reparametrised>(cylinder(0, 2 * pi));
  const auto upside_down =
      std::make_shared<test::Placed>(cylinder(pi, 3 * pi, 0, 1), -1, Vec3(0, 0, 0));
  const Model model = join({fast, upside_down});
  expect_counts(model, 3, 5, 8);
  const Contour& shared = contour_of(model, "p1:v0");
  ASSERT_EQ(shared.uses.size(), 2U);
  EXPECT_FALSE(shared.uses[1].is_same_speed);
  EXPECT_EQ(shared.uses[0].is_forward, shared.uses[1].is_forward);
}

/// Each side passes its own start and covers itself.
TEST(JoinSides, JoinsTheTurnsOfACylinderThatGoesRoundTwice) {
  const Model model = join({cylinder(0, 4 * pi)});
  expect_counts(model, 2, 3, 6);
  EXPECT_EQ(count_shared(model), 3);
  EXPECT_EQ(side_uses(model, "p0:v0").size(), 2U);
}

TEST(JoinSides, ClosesATorusOfOnePatch) {
  const Model model = join({torus({0, 2 * pi, 0, 2 * pi})});
  expect_counts(model, 1, 2, 4);
  EXPECT_EQ(count_shared(model), 2);
  EXPECT_EQ(euler(model), 0);
}

TEST(JoinSides, ClosesATorusOfFourPatches) {
  const Model model = join({torus({0, pi, 0, pi}), torus({pi, 2 * pi, 0, pi}),
                            torus({0, pi, pi, 2 * pi}), torus({pi, 2 * pi, pi, 2 * pi})});
  expect_counts(model, 4, 8, 16);
  EXPECT_EQ(count_shared(model), 8);
  EXPECT_EQ(euler(model), 0);
}

TEST(JoinSides, ClosesASphereOfOnePatch) {
  const Model model = join({sphere(0, 2 * pi)});
  expect_counts(model, 2, 3, 4);
  EXPECT_EQ(count_degenerate(model), 2);
  EXPECT_EQ(count_shared(model), 1);
  EXPECT_EQ(euler(model), 2);
  EXPECT_EQ(contour_of(model, "p0:v0").start, contour_of(model, "p0:v0").end);
  EXPECT_TRUE(contour_of(model, "p0:v0").is_degenerate);
}

TEST(JoinSides, ClosesASphereOfTwoHalves) {
  const Model model = join({sphere(0, pi), sphere(-pi, 0)});
  expect_counts(model, 2, 6, 8);
  EXPECT_EQ(count_degenerate(model), 4);
  EXPECT_EQ(euler(model), 2);
}

TEST(JoinSides, ClosesAConeAtItsApex) {
  const Model model = join({std::make_shared<test::Cone>(1, Domain{0, 2 * pi, 0, 1})});
  expect_counts(model, 2, 3, 4);
  EXPECT_EQ(count_degenerate(model), 1);
  EXPECT_EQ(euler(model), 1);
}

TEST(JoinSides, UsesTheSeamOfAMobiusBandTwiceInOneSense) {
  const Model model = join({std::make_shared<test::MobiusBand>(2, Domain{0, 2 * pi, -0.5, 0.5})});
  expect_counts(model, 2, 3, 4);
  const Contour& seam = contour_of(model, "p0:u0");
  ASSERT_EQ(seam.uses.size(), 2U);
  EXPECT_TRUE(seam.uses[0].is_forward);
  EXPECT_TRUE(seam.uses[1].is_forward);
  EXPECT_EQ(euler(model), 0);
}

TEST(JoinSides, TellsNearMissesAndTheirGap) {
  const Model model = join({scaled_square(0, 0, 1, 1), scaled_square(1 + 1e-6, 0, 2, 1)});
  EXPECT_EQ(model.vertices.size(), 8U);
  EXPECT_EQ(count_shared(model), 0);
  ASSERT_EQ(model.notices.size(), 1U);
  const Notice& notice = model.notices[0];
  EXPECT_NE(notice.text.find("p0:u1 and p1:u0"), std::string::npos) << notice.text;
  EXPECT_NE(notice.text.find("1e-06"), std::string::npos) << notice.text;
  EXPECT_EQ(notice.severity, Severity::Shortfall);
  EXPECT_EQ(model.contour(notice.contour).name, "p0:u1");
}

/// The joining that a notice has to advise.
double required_advice(const Notice& notice) {
  const std::string words = "joining = ";
  const std::size_t at = notice.text.find(words);
  EXPECT_NE(at, std::string::npos) << notice.text;
  return at == std::string::npos ? 0 : std::stod(notice.text.substr(at + words.size()));
}

TEST(JoinSides, AdvisesAJoiningThatJoins) {
  for (const double gap : {1e-8, 3.7e-7, 9.9e-6, 7.6e-5}) {
    const std::vector<PatchInput> patches = {{"a", scaled_square(0, 0, 1, 1)},
                                             {"b", scaled_square(1 + gap, 0, 2, 1)}};
    const Model apart = model_from_patches(patches);
    ASSERT_EQ(apart.notices.size(), 1u) << gap;
    const double joining = required_advice(apart.notices[0]);
    EXPECT_LT(joining, 3 * gap);
    const Model joined = model_from_patches(patches, {}, {Length::units(joining)});
    EXPECT_EQ(count_shared(joined), 1) << gap;
    EXPECT_TRUE(joined.notices.empty());
    EXPECT_NO_THROW(check(joined));
  }
}

TEST(JoinSides, DoesNotTellOfTheSidesOfANarrowPatch) {
  EXPECT_TRUE(join({scaled_square(0, 0, 1, 3e-5)}).notices.empty());
}

TEST(JoinSides, RefusesAJoiningThatWouldMakePointsOfSides) {
  const std::vector<PatchInput> patches = {{"a", scaled_square(0, 0, 1, 1)}};
  EXPECT_NE(error_of([&] {
              model_from_patches(patches, {}, {Length::share(0.02)});
            }).find("must not be above 1 % of the diagonal"),
            std::string::npos);
  EXPECT_NE(error_of([&] { model_from_patches(patches, {}, {Length::units(0)}); }).find("joining"),
            std::string::npos);
}

TEST(JoinSides, TellsASeamThatDoesNotClose) {
  const Model model = join({cylinder(0, 2 * pi - 1e-5)});
  EXPECT_EQ(count_shared(model), 0);
  ASSERT_EQ(texts_of(model.notices).size(), 1U);
}

TEST(JoinSides, TellsAThirdPatchBesideAJoin) {
  const Model model = join({scaled_square(0, 0, 1, 1), scaled_square(0, 0, 1, -1),
                            plane({0, 0, 1e-6}, {1, 0, 0}, {0, 0, 1})});
  EXPECT_EQ(count_shared(model), 1);
  EXPECT_EQ(texts_of(model.notices).size(), 1U);
}

TEST(JoinSides, TellsNearMissesOverAPart) {
  const Model model = join({scaled_square(0, 0, 2, 1), scaled_square(1, 1 + 1e-6, 3, 2)});
  EXPECT_EQ(texts_of(model.notices).size(), 1U);
}

TEST(JoinSides, CountsNearMissesInsteadOfListingThousands) {
  std::vector<Shape> shapes;
  for (int i = 0; i < 30; ++i)
    shapes.push_back(scaled_square(i + 1e-5 * (i % 2), 0, i + 0.9999, 1));
  const Model model = join(shapes);
  ASSERT_EQ(model.notices.size(), 20U);
  EXPECT_EQ(model.notices.back().count, 10U);
}

TEST(JoinSides, DoesNotTellOfThinOrFarSides) {
  EXPECT_TRUE(
      texts_of(join({scaled_square(0, 0, 1, 1), scaled_square(1.001, 0, 2, 1)}).notices).empty());
  EXPECT_TRUE(
      texts_of(join({scaled_square(0, 0, 1, 1), scaled_square(1, 0, 1 + 5e-5, 5e-5)}).notices)
          .empty());
}

TEST(JoinSides, WorksAtEveryScale) {
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const auto placed = [&](const Shape& shape, Vec3 offset) {
      return std::make_shared<test::Placed>(shape, scale, scale * offset);
    };
    for (const Vec3& offset : {Vec3(0, 0, 0), Vec3(1e5, -3e5, 7e4), Vec3(1e9, 1e9, 1e9)}) {
      const Model model = join({placed(cylinder(0, 2 * pi, 0, 1), offset),
                                placed(cylinder(1, 1 + 2 * pi, 1, 2), offset)});
      if (offset.norm() < 1e6) {
        expect_counts(model, 4, 6, 10);
      }
    }
  }
}

TEST(JoinSides, DoesNotDependOnTheScaleOfParameters) {
  const Domain uneven{1e6, 2e6, 0, 1e-3};
  const Shape left = plane({-2, 0, 0}, {1e-6, 0, 0}, {0, 1e3, 0}, uneven);
  const Model model = join({left, scaled_square(0, 0, 1, 0.3), scaled_square(1, 1, 0, 0.3)});
  expect_counts(model, 8, 10, 13);
}

TEST(JoinSides, JoinsALongAndNarrowStrip) {
  const Model model = join({scaled_square(0, 0, 1e6, 0.1), scaled_square(0, 0.1, 1e6, 1)});
  EXPECT_EQ(model.vertices.size(), 6U);
  EXPECT_EQ(count_shared(model), 1);
}

TEST(JoinSides, JoinsAGridOfFourHundredPatches) {
  const int n = 20;
  std::vector<Shape> shapes;
  for (int i = 0; i < n * n; ++i) {
    const double x = i % n * 0.1;
    const double y = i / n * 0.1;
    const double x1 = (i % n + 1) * 0.1;
    const double y1 = (i / n + 1) * 0.1;
    shapes.push_back(i % 3 == 0 ? scaled_square(x1, y, x, y1) : scaled_square(x, y1, x1, y));
  }
  const Model model = join(shapes);
  expect_counts(model, (n + 1) * (n + 1), 2 * n * (n + 1), 4 * n * n);
  EXPECT_EQ(count_shared(model), 2 * n * (n - 1));
  EXPECT_EQ(euler(model), 1);
}

TEST(JoinSides, SlicesASphereIntoManyPatches) {
  const int n = 60;
  std::vector<Shape> shapes;
  for (int i = 0; i < n; ++i) shapes.push_back(sphere(2 * pi * i / n, 2 * pi * (i + 1) / n));
  const Model model = join(shapes);
  EXPECT_EQ(model.vertices.size(), 2U);
  EXPECT_EQ(count_shared(model), n);
  EXPECT_EQ(euler(model), 2);
}

/// A plate whose waves end at every sample of an even spacing is not taken for a flat one.
class WavyPlate : public test::AnalyticSurface {
 public:
  WavyPlate() : AnalyticSurface({}) {}

 protected:
  Jet all(Uv uv) const override {
    const double k = 64 * pi;
    const double a = 0.001;
    Jet jet{Vec3(uv.u, uv.v, a * std::sin(k * uv.u)),
            Vec3(1, 0, a * k * std::cos(k * uv.u)),
            Vec3(0, 1, 0),
            Vec3(0, 0, -a * k * k * std::sin(k * uv.u)),
            Vec3::Zero(),
            Vec3::Zero()};
    return jet;
  }
};

/// A rectangle that stays at (0, 0) for the first half of its sides v0 and v1.
class LateStart : public test::AnalyticSurface {
 public:
  LateStart() : AnalyticSurface({}) {}

 protected:
  Jet all(Uv uv) const override {
    const double s = std::max(0.0, 2 * uv.u - 1);
    const double ds = uv.u > 0.5 ? 2 : 0;
    return {Vec3(s, s * uv.v, 0), Vec3(ds, ds * uv.v, 0), Vec3(0, s, 0),
            Vec3::Zero(),         Vec3(0, ds, 0),         Vec3::Zero()};
  }
};

TEST(JoinSides, DoesNotDivideASideThatWaitsAtItsStart) {
  const Model model = join({std::make_shared<LateStart>(), scaled_square(0, 0, 1, -1)});
  expect_counts(model, 5, 7, 8);
  EXPECT_FALSE(contour_of(model, "p0:v0").uses[1].is_same_speed);
}

TEST(JoinSides, IsNotMisledByWaves) {
  const Model model = join({std::make_shared<WavyPlate>(), scaled_square(0, 0, 1, -1)});
  EXPECT_EQ(count_shared(model), 0);
}

TEST(JoinSides, GivesTheSameModelTwice) {
  const std::vector<Shape> shapes{torus({0, pi, 0, pi}), torus({pi, 2 * pi, 0, pi}),
                                  torus({0, pi, pi, 2 * pi}), scaled_square(1.5, 0, 2.5, 1)};
  const Model a = join(shapes);
  const Model b = join(shapes);
  ASSERT_EQ(a.contours.size(), b.contours.size());
  for (std::size_t c = 0; c < a.contours.size(); ++c) {
    EXPECT_EQ(a.contours[c].name, b.contours[c].name);
    EXPECT_EQ(a.contours[c].start, b.contours[c].start);
    EXPECT_EQ(a.contours[c].end, b.contours[c].end);
    ASSERT_EQ(a.contours[c].uses.size(), b.contours[c].uses.size());
    for (std::size_t u = 0; u < a.contours[c].uses.size(); ++u) {
      EXPECT_EQ(a.contours[c].uses[u].patch, b.contours[c].uses[u].patch);
      for (const double t : {0.0, 0.3, 1.0}) {
        EXPECT_EQ(a.contours[c].uses[u].curve->evaluate(t),
                  b.contours[c].uses[u].curve->evaluate(t));
      }
    }
  }
  EXPECT_EQ(texts_of(a.notices), texts_of(b.notices));
}

TEST(JoinSides, RefusesPatchesWithoutArea) {
  const Shape good = scaled_square(0, 0, 1, 1);
  const Error line =
      joining_error({{"good", good}, {"flat", plane({0, 0, 0}, {1, 0, 0}, {2, 0, 0})}});
  EXPECT_EQ(line.code(), ErrorCode::Geometry);
  EXPECT_STREQ(line.what(), "patch flat: its surface is a line, without area");
  const Error point =
      joining_error({{"good", good}, {"dot", plane({5, 0, 0}, {0, 0, 0}, {0, 0, 0})}});
  EXPECT_EQ(point.code(), ErrorCode::Geometry);
  EXPECT_STREQ(point.what(), "patch dot: its surface is a point, without area");
  EXPECT_EQ(joining_error({{"dot", plane({5, 0, 0}, {0, 0, 0}, {0, 0, 0})}}).code(),
            ErrorCode::Geometry);
}

TEST(JoinSides, RefusesPatchesTooLargeToMeasure) {
  const Error error = joining_error({{"wide", plane({0, 0, 0}, {1e200, 0, 0}, {0, 1, 0})}});
  EXPECT_EQ(error.code(), ErrorCode::Geometry);
  EXPECT_STREQ(error.what(),
               "patch wide: its surface is too large: the diagonal of its box is inf");
}

Shape wave(double amplitude, double frequency) {
  return make_callable_surface({0, 1, 0, 1}, [=](auto u, auto v) {
    return std::array{u, v, amplitude * sin(frequency * u)};
  });
}

TEST(JoinSides, RefusesWavesThatNoSampleResolves) {
  const Error error = joining_error({{"wave", wave(1, 1e9)}});
  EXPECT_EQ(error.code(), ErrorCode::Geometry);
  EXPECT_TRUE(
      std::string(error.what())
          .starts_with(
              "patch wave: its surface goes to and fro too often to be meshed: its area is about "))
      << error.what();
  EXPECT_EQ(model_from_patches({{"waves", wave(1, 1000)}}).patches.size(), 1u);
  EXPECT_EQ(model_from_patches({{"flat", wave(1e-9, 1e9)}}).patches.size(), 1u);
}

TEST(JoinSides, RefusesInvalidInput) {
  const Shape good = scaled_square(0, 0, 1, 1);
  const Shape triangle =
      plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0, 1, Domain::Shape::Triangle});
  const Shape empty = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 2, 2});
  const std::vector<std::vector<PatchInput>> inputs{
      {}, {{"a", good}, {"a", good}}, {{"b", nullptr}}, {{"c", triangle}}, {{"d", empty}}};
  for (const auto& input : inputs) {
    const Error error = joining_error(input);
    EXPECT_EQ(error.code(), ErrorCode::InvalidInput);
    if (!input.empty()) {
      EXPECT_NE(std::string(error.what()).find("patch " + input.back().name), std::string::npos);
    }
  }
}

TEST(SampleParameters, RiseUnevenlyFromZeroToOne) {
  for (const int count : {2, 8, 32, 64}) {
    const std::vector<double> t = sample_parameters(count);
    ASSERT_EQ(t.size(), static_cast<std::size_t>(count) + 1);
    EXPECT_EQ(t.front(), 0);
    EXPECT_EQ(t.back(), 1);
    for (std::size_t i = 1; i < t.size(); ++i) {
      EXPECT_GT(t[i], t[i - 1]);
      EXPECT_LT(t[i] - t[i - 1], 2.0 / count);
    }
  }
}

TEST(SideUses, FollowsTheGrowingParameter) {
  const Model model =
      join({scaled_square(0, 0, 3, 1), scaled_square(2, 1, 3, 2), scaled_square(0, 1, 1, 2)});
  const std::vector<LoopEntry> uses = side_uses(model, "p0:v1");
  ASSERT_EQ(uses.size(), 3U);
  EXPECT_EQ(uses[0].contour, side_uses(model, "p2:v0").front().contour);
  EXPECT_EQ(model.contours[static_cast<std::size_t>(uses[1].contour)].uses.size(), 1U);
  EXPECT_EQ(uses[2].contour, side_uses(model, "p1:v0").front().contour);
}

TEST(SideUses, RefusesUnknownSides) {
  const Model model = join({scaled_square(0, 0, 3, 1)});
  for (const char* name : {"p0:w0", "p1:u0", "p0", "", ":u0"}) {
    EXPECT_THROW(side_uses(model, name), Error) << name;
  }
}

}  // namespace
}  // namespace surfmesh
