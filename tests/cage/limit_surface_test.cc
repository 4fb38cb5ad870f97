// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/limit_surface.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <thread>

#include "cage/cages.hh"
#include "surfmesh/cage/subdivision.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

using Surfaces = std::vector<std::shared_ptr<const Surface>>;

Surfaces surfaces_of(const Cage& cage, int level = 8) {
  return make_limit_surfaces(cage, Scheme::Auto, level);
}

std::vector<Uv> samples(const Domain& domain, int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Uv> result;
  for (int i = 0; i < count; ++i) result.push_back(domain.fold({uniform(random), uniform(random)}));
  return result;
}

double distance_to_corners(Uv uv, const Domain& domain) {
  double least = 1;
  for (int i = 0; i < domain.corner_count(); ++i) {
    const Uv step = uv - domain.corner(i);
    least = std::min(least, std::hypot(step.u, step.v));
  }
  return least;
}

/// Greatest difference of all members that are set in both.
double difference(const Jet& a, const Jet& b) {
  return std::max({(a.point - b.point).norm(), (a.du - b.du).norm(), (a.dv - b.dv).norm(),
                   (a.duu - b.duu).norm(), (a.duv - b.duv).norm(), (a.dvv - b.dvv).norm()});
}

/// Central differences of the position and of the first derivatives.
Jet by_differences(const Surface& surface, Uv uv) {
  constexpr double h = 1e-5;
  const Jet left = surface.evaluate({uv.u - h, uv.v}, Order::First);
  const Jet right = surface.evaluate({uv.u + h, uv.v}, Order::First);
  const Jet below = surface.evaluate({uv.u, uv.v - h}, Order::First);
  const Jet above = surface.evaluate({uv.u, uv.v + h}, Order::First);
  Jet jet;
  jet.point = surface.evaluate(uv, Order::Position).point;
  jet.du = (right.point - left.point) / (2 * h);
  jet.dv = (above.point - below.point) / (2 * h);
  jet.duu = (right.du - left.du) / (2 * h);
  jet.duv = (above.du - below.du) / (2 * h);
  jet.dvv = (above.dv - below.dv) / (2 * h);
  return jet;
}

void expect_exact_derivatives(const Cage& cage) {
  for (const auto& surface : surfaces_of(cage)) {
    for (Uv uv : samples(surface->domain(), 50)) {
      if (distance_to_corners(uv, surface->domain()) < 0.05) continue;
      // Away from the boundary, so that differences stay inside.
      uv = lerp(uv, {1.0 / 3, 1.0 / 3}, 1e-3);
      const Jet jet = surface->evaluate(uv, Order::Second);
      EXPECT_LT(difference(jet, by_differences(*surface, uv)), 2e-3) << uv.u << " " << uv.v;
    }
  }
}

TEST(LimitSurface, HasExactDerivativesOnRegularQuads) {
  expect_exact_derivatives(testing::torus());
}
TEST(LimitSurface, HasExactDerivativesOnIrregularQuads) {
  expect_exact_derivatives(testing::cube());
}
TEST(LimitSurface, HasExactDerivativesOnIrregularTriangles) {
  expect_exact_derivatives(testing::octahedron());
  expect_exact_derivatives(testing::icosahedron());
}
TEST(LimitSurface, HasExactDerivativesAtABoundary) {
  expect_exact_derivatives(testing::sheet());
  expect_exact_derivatives(testing::triangle_sheet());
}

TEST(LimitSurface, HasSecondDerivativesOfTheRightSignInAllSmallerTriangles) {
  // Bfr 3.5.0 turns them in every smaller triangle of an irregular one that is upside down.
  const auto surface = surfaces_of(testing::octahedron())[0];
  for (int n = 2; n <= 64; n *= 2) {
    for (int i = 0; i < n; ++i) {
      const Uv uv = {(i + 0.31) / (n + 1), (n - i + 0.29) / (n + 1) / 2};
      const Jet jet = surface->evaluate(uv, Order::Second);
      EXPECT_LT(difference(jet, by_differences(*surface, uv)), 2e-3) << uv.u << " " << uv.v;
    }
  }
}

TEST(LimitSurface, LevelsAgreeWithinTheirBounds) {
  const Surfaces at6 = surfaces_of(testing::cube(), 6), at8 = surfaces_of(testing::cube(), 8),
                 at10 = surfaces_of(testing::cube(), 10);
  double between_6_and_8 = 0, between_8_and_10 = 0;
  for (std::size_t f = 0; f < at8.size(); ++f) {
    for (int i = 0; i <= 1024; ++i) {
      // Towards a corner, where the approximation is.
      const double t = std::pow(0.99, i);
      const Uv uv = {t, 0.7 * t};
      const Vec3 point = at8[f]->evaluate(uv, Order::Position).point;
      between_6_and_8 =
          std::max(between_6_and_8, (at6[f]->evaluate(uv, Order::Position).point - point).norm());
      between_8_and_10 =
          std::max(between_8_and_10, (at10[f]->evaluate(uv, Order::Position).point - point).norm());
    }
  }
  EXPECT_GT(between_6_and_8, 1e-6);
  EXPECT_LT(between_6_and_8, 2e-4 * diagonal(testing::cube()));
  EXPECT_LT(between_8_and_10, 1e-5 * diagonal(testing::cube()));
}

TEST(LimitSurface, OfTheCubeHasItsVerticesAtOneHalf) {
  // (n² v + 4 Σ edge neighbours + Σ face neighbours) / (n (n + 5)), n = 3.
  const Cage cage = testing::cube();
  const Surfaces surfaces = surfaces_of(cage);
  for (std::size_t f = 0; f < surfaces.size(); ++f) {
    for (int i = 0; i < 4; ++i) {
      const Vec3 corner = surfaces[f]->evaluate(Domain{}.corner(i), Order::Position).point;
      const int vertex = cage.faces[f][static_cast<std::size_t>(i)];
      EXPECT_LT((corner - 0.5 * cage.points[static_cast<std::size_t>(vertex)]).norm(), 1e-7);
    }
  }
}

TEST(LimitSurface, OfBilinearCagesIsTheCage) {
  const Surfaces surfaces = make_limit_surfaces(testing::cube(), Scheme::Bilinear);
  const Jet jet = surfaces[0]->evaluate({0.25, 0.75}, Order::Second);
  EXPECT_LT((jet.point - Vec3(0.5, -0.5, -1)).norm(), 1e-15);
  EXPECT_LT((jet.du - Vec3(0, 2, 0)).norm(), 1e-15);
  EXPECT_TRUE(surfaces[0]->singular_points().empty());
}

TEST(LimitSurface, OfRegularFacesByHandEqualsBfr) {
  Cage creased = testing::torus();
  creased.creases = {{{0, 1}, 10}, {{1, 2}, 10}};
  for (const Cage& cage : {testing::torus(), testing::sheet(), creased}) {
    const CageTopology topology = make_topology(cage, Scheme::CatmullClark);
    const Surfaces by_hand = make_limit_surfaces(*topology.refiner, cage.points, {8, true});
    const Surfaces by_bfr = make_limit_surfaces(*topology.refiner, cage.points, {8, false});
    for (std::size_t f = 0; f < by_hand.size(); ++f) {
      if (!by_hand[f]->singular_points().empty()) continue;
      for (Uv uv : samples({}, 50)) {
        const Jet jet = by_bfr[f]->evaluate(uv, Order::Second);
        EXPECT_LT(difference(by_hand[f]->evaluate(uv, Order::Second), jet), 1e-13);
      }
    }
  }
}

TEST(LimitSurface, OfIrregularFacesByTheirPartsEqualsBfr) {
  Cage semi_sharp = testing::torus();
  semi_sharp.creases = {{{0, 1}, 2.5f}, {{1, 2}, 2.5f}};
  Cage corner = testing::torus();
  corner.corners = {{0, 1.2f}};
  for (const Cage& cage : {testing::cube(), testing::sheet(), semi_sharp, corner}) {
    const CageTopology topology = make_topology(cage, Scheme::CatmullClark);
    const Surfaces by_parts = make_limit_surfaces(*topology.refiner, cage.points, {8, true});
    const Surfaces by_bfr = make_limit_surfaces(*topology.refiner, cage.points, {8, false});
    for (std::size_t f = 0; f < by_parts.size(); ++f) {
      if (by_parts[f]->singular_points().empty()) continue;
      for (Uv uv : samples({}, 200)) {
        const Jet exact = by_bfr[f]->evaluate(uv, Order::Second);
        const Jet found = by_parts[f]->evaluate(uv, Order::Second);
        // Roundings of points times 16² in second derivatives: see bicubic_parts_test.cc.
        EXPECT_LT((found.point - exact.point).norm(), 1e-14 * diagonal(cage));
        EXPECT_LT((found.du - exact.du).norm(), 1e-13 * diagonal(cage));
        EXPECT_LT((found.dv - exact.dv).norm(), 1e-13 * diagonal(cage));
        EXPECT_LT(difference(found, exact), 3e-12 * diagonal(cage));
      }
    }
  }
}

TEST(LimitSurface, IsTheSameFromFourThreads) {
  const Surfaces surfaces = surfaces_of(testing::icosahedron());
  const auto evaluate_all = [&] {
    std::vector<Jet> jets;
    for (const auto& surface : surfaces) {
      for (Uv uv : samples(surface->domain(), 500)) {
        jets.push_back(surface->evaluate(uv, Order::Second));
      }
    }
    return jets;
  };
  const std::vector<Jet> serial = evaluate_all();
  std::vector<std::vector<Jet>> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results) threads.emplace_back([&] { result = evaluate_all(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : results) {
    ASSERT_EQ(result.size(), serial.size());
    for (std::size_t i = 0; i < serial.size(); ++i) ASSERT_EQ(difference(result[i], serial[i]), 0);
  }
}

int singular_count(const Cage& cage) {
  std::size_t count = 0;
  for (const auto& surface : surfaces_of(cage)) {
    if (surface) count += surface->singular_points().size();
  }
  return static_cast<int>(count);
}

TEST(LimitSurface, IsSingularAtExtraordinaryCorners) {
  EXPECT_EQ(singular_count(testing::torus()), 0);
  EXPECT_EQ(singular_count(testing::cube()), 24);
  EXPECT_EQ(singular_count(testing::icosahedron()), 60);
  // Boundary rule "edge only": corners of one face are rounded, which is irregular.
  EXPECT_EQ(singular_count(testing::sheet()), 4);
  Cage cage = testing::sheet();
  cage.boundary = BoundaryRule::EdgeAndCorner;
  EXPECT_EQ(singular_count(cage), 0);
}

TEST(LimitSurface, IsSingularAtEndsOfCreasesAndAtSemiSharpOnes) {
  Cage cage = testing::torus();
  cage.creases = {{{0, 1}, 10}, {{1, 2}, 10}};
  EXPECT_EQ(singular_count(cage), 8) << "the four faces at each end, not those in the middle";
  cage.creases = {{{0, 1}, 3}};
  EXPECT_EQ(singular_count(cage), 8);
}

TEST(LimitSurface, ReachHalvesWithTheLevel) {
  EXPECT_EQ(surfaces_of(testing::cube(), 6)[0]->singular_points()[0].reach, 1.0 / 32);
  EXPECT_EQ(surfaces_of(testing::cube(), 8)[0]->singular_points()[0].reach, 1.0 / 128);
}

TEST(LimitSurface, HasAValueAtAnyDistanceFromASingularCorner) {
  for (const Cage& cage : {testing::cube(), testing::icosahedron()}) {
    const auto surface = surfaces_of(cage)[0];
    const Uv at = surface->singular_points()[0].at;
    const Vec3 corner = surface->evaluate(at, Order::Position).point;
    for (const double near : {1e-12, 1e-200, 4e-311}) {
      const Uv uv{at.u > 0 ? 1 - near : near, at.v > 0 ? 1 - near : 0};
      const Jet jet = surface->evaluate(uv, Order::Second);
      EXPECT_LT((jet.point - corner).norm(), 1e-9) << near;
      EXPECT_TRUE(jet.duu.allFinite()) << near;
    }
  }
}

TEST(LimitSurface, HasUsableFirstDerivativesAtSingularCorners) {
  for (const Cage& cage : {testing::cube(), testing::tetrahedron(), testing::icosahedron()}) {
    for (const auto& surface : surfaces_of(cage)) {
      for (const SingularPoint& singular : surface->singular_points()) {
        const Uv middle = {1.0 / 3, 1.0 / 3};
        for (double t : {0.0, 1e-12, 1e-6, 1e-3}) {
          const Jet jet = surface->evaluate(lerp(singular.at, middle, t), Order::First);
          const double area = jet.du.cross(jet.dv).norm();
          EXPECT_GT(area, 0.05 * jet.du.norm() * jet.dv.norm());
          EXPECT_GT(jet.du.norm(), 1e-3);
        }
      }
    }
  }
}

TEST(LimitSurface, MovesDerivativesButNotThePositionNearASingularCorner) {
  const auto surface = surfaces_of(testing::cube())[0];
  const double reach = surface->singular_points()[0].reach;
  const Jet at_corner = surface->evaluate({0, 0}, Order::First);
  const double s = reach / std::sqrt(2.0);
  const Jet at_reach = surface->evaluate({s, s}, Order::First);
  EXPECT_LT((at_corner.du - at_reach.du).norm(), 1e-9);
  EXPECT_GT((at_corner.point - at_reach.point).norm(), 1e-4);
  EXPECT_EQ(at_corner.point, surface->evaluate({0, 0}, Order::Position).point);
}

TEST(LimitSurface, AllowsPointsOutsideByRounding) {
  for (const Cage& cage : {testing::cube(), testing::octahedron(), testing::torus()}) {
    const auto surface = surfaces_of(cage)[0];
    for (int i = 0; i < surface->domain().corner_count(); ++i) {
      const Uv corner = surface->domain().corner(i);
      const Vec3 point = surface->evaluate(corner, Order::Position).point;
      for (Uv step : {Uv{1e-16, 1e-16}, Uv{-1e-16, -1e-16}, Uv{3e-16, -1e-16}}) {
        EXPECT_LT((surface->evaluate(corner + step, Order::Position).point - point).norm(), 1e-9);
      }
    }
  }
}

TEST(LimitSurface, RefusesAPointThatIsNotFinite) {
  for (const Cage& cage : {testing::cube(), testing::torus()}) {
    EXPECT_THROW(surfaces_of(cage)[0]->evaluate({0.5, kUnset}, Order::First), Error);
  }
}

TEST(LimitSurface, IsMissingAtHolesAndBoundariesWithoutRule) {
  Cage cage = testing::sheet();
  cage.holes = {2};
  EXPECT_FALSE(surfaces_of(cage)[2]);
  EXPECT_TRUE(surfaces_of(cage)[3]);
  cage.boundary = BoundaryRule::None;
  const Surfaces surfaces = surfaces_of(cage);
  for (std::size_t f = 0; f < 9; ++f) EXPECT_EQ(surfaces[f] != nullptr, f == 4);
}

TEST(LimitSurface, AtInteriorVerticesOfValenceTwoIsSafe) {
  Cage cage = testing::pillow();
  for (int i = 0; i < 3; ++i) {  // several of them, for a cache to be shared
    const int first = static_cast<int>(cage.points.size());
    for (int k = 0; k < 4; ++k) {
      cage.points.emplace_back(cage.points[static_cast<std::size_t>(k)] + Vec3(3 * i + 3, 0, 0));
    }
    cage.faces.push_back({first, first + 1, first + 2, first + 3});
    cage.faces.push_back({first + 3, first + 2, first + 1, first});
  }
  for (const auto& surface : surfaces_of(cage)) {
    for (Uv uv : samples({}, 20)) EXPECT_NO_THROW(surface->evaluate(uv, Order::Second));
  }
}

/// Two faces share two edges of a vertex, beside which there is a third face.
TEST(LimitSurface, AtAFanOfTwoFacesBesideAnotherIsSafe) {
  Cage cage;
  cage.points = {{0, 4, 0}, {3, 5, 0}, {6, 2, 0}, {0, 5, 0}, {3, 8, 0},
                 {6, 8, 3}, {6, 0, 7}, {0, 5, 0}, {0, 8, 7}};
  cage.faces = {{0, 1, 4, 3}, {3, 4, 1, 6}, {4, 5, 8, 7}};
  cage.creases = {{{1, 4}, 2.5}, {{3, 4}, 10}};
  Eigen::AlignedBox3d bounds;
  for (const Vec3& point : cage.points) bounds.extend(point);
  for (const auto& surface : surfaces_of(cage)) {
    for (Uv uv : samples({}, 20)) {
      const Jet jet = surface->evaluate(uv, Order::Second);
      EXPECT_LT(bounds.exteriorDistance(jet.point), 1e-9);
      EXPECT_TRUE(jet.du.allFinite() && jet.dv.allFinite());
    }
  }
}

TEST(LimitSurface, RefusesFacesOfTheWrongSize) {
  const auto expect_refused = [](const Cage& cage, Scheme scheme, const std::string& text) {
    try {
      make_limit_surfaces(cage, scheme);
      ADD_FAILURE() << "expected: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::InvalidInput);
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  expect_refused(testing::cube(), Scheme::Loop, "face 0 has 4 vertices");
  expect_refused(testing::pentagon_prism(), Scheme::CatmullClark, "face 0 has 5 vertices");
}

TEST(LimitSurface, RefusesALevelOutOfRange) {
  for (int level : {0, 11}) EXPECT_THROW(surfaces_of(testing::cube(), level), Error);
}

}  // namespace
}  // namespace surfmesh
