// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/nurbs_surface.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

#include "support/errors.hh"
#include "support/nurbs_nets.hh"

namespace surfmesh {
namespace {

using testing::clamped_knots;
using testing::open_knots;
using testing::slow_jet;
using testing::sphere_net;
using testing::strip_net;
using testing::wavy_net;

/// Points of the domain, some at its corners and knots.
std::vector<Uv> points_of(const Surface& surface) {
  std::vector<Uv> result;
  for (const double s : {0.0, 0.07, 0.25, 0.5, 0.81, 1.0}) {
    for (const double t : {0.0, 0.31, 0.5, 0.93, 1.0}) result.push_back(surface.domain().at(s, t));
  }
  return result;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance, const char* what) {
  EXPECT_LE((a - b).norm(), tolerance) << what << ' ' << a.transpose() << " and " << b.transpose();
}

struct Kind {
  std::string name;
  NurbsNet net;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

Kind clamped(int p, int q, bool is_rational = false) {
  return {"Degree" + std::to_string(p) + "x" + std::to_string(q) + (is_rational ? "Rational" : ""),
          wavy_net(p, q, clamped_knots(p, 5, 1.5), clamped_knots(q, 3), is_rational)};
}

class NurbsSurfaces : public ::testing::TestWithParam<Kind> {};

TEST_P(NurbsSurfaces, AgreeWithDeBoor) {
  const NurbsNet& net = GetParam().net;
  const NurbsSurface surface(net);
  const double size = (net.points.back().back() - net.points.front().front()).norm();
  double first = 0, second = 0;
  for (const Uv uv : points_of(surface)) {
    const Jet jet = slow_jet(net, uv);
    first = std::max({first, jet.du.norm(), jet.dv.norm()});
    second = std::max({second, jet.duu.norm(), jet.duv.norm(), jet.dvv.norm()});
  }
  for (const Uv uv : points_of(surface)) {
    const Jet fast = surface.evaluate(uv, Order::Second), slow = slow_jet(net, uv);
    expect_near(fast.point, slow.point, 1e-13 * size, "point");
    expect_near(fast.du, slow.du, 1e-11 * first, "du");
    expect_near(fast.dv, slow.dv, 1e-11 * first, "dv");
    expect_near(fast.duu, slow.duu, 1e-9 * second, "duu");
    expect_near(fast.duv, slow.duv, 1e-9 * second, "duv");
    expect_near(fast.dvv, slow.dvv, 1e-9 * second, "dvv");
  }
}

TEST_P(NurbsSurfaces, HaveTheDerivativesOfFiniteDifferences) {
  const NurbsSurface surface(GetParam().net);
  const double h = 1e-6;
  const auto at = [&](Uv uv, double u, double v) {
    return surface.evaluate({uv.u + u, uv.v + v}, Order::First);
  };
  for (const Uv uv : {surface.domain().at(0.13, 0.4), surface.domain().at(0.71, 0.83)}) {
    const Jet jet = surface.evaluate(uv, Order::Second);
    const Jet west = at(uv, -h, 0), east = at(uv, h, 0), south = at(uv, 0, -h),
              north = at(uv, 0, h);
    const double first = 1e-7 * (1 + jet.duu.norm() + jet.dvv.norm() + jet.du.norm());
    const double second = 1e-4 * (1 + jet.duu.norm() + jet.duv.norm() + jet.dvv.norm());
    expect_near((east.point - west.point) / (2 * h), jet.du, first, "du");
    expect_near((north.point - south.point) / (2 * h), jet.dv, first, "dv");
    expect_near((east.du - west.du) / (2 * h), jet.duu, second, "duu");
    expect_near((east.dv - west.dv) / (2 * h), jet.duv, second, "duv");
    expect_near((north.dv - south.dv) / (2 * h), jet.dvv, second, "dvv");
  }
}

TEST_P(NurbsSurfaces, OrdersAgreeBitByBit) {
  const NurbsSurface surface(GetParam().net);
  for (const Uv uv : points_of(surface)) {
    const Jet second = surface.evaluate(uv, Order::Second);
    const Jet first = surface.evaluate(uv, Order::First);
    EXPECT_EQ(first.point, second.point);
    EXPECT_EQ(first.du, second.du);
    EXPECT_EQ(first.dv, second.dv);
    EXPECT_TRUE(first.duu.hasNaN());
    EXPECT_EQ(surface.evaluate(uv, Order::Position).point, second.point);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, NurbsSurfaces,
    ::testing::Values(clamped(1, 1), clamped(2, 1, true), clamped(2, 3), clamped(3, 3),
                      clamped(3, 3, true), clamped(4, 5), clamped(6, 7, true), clamped(7, 2),
                      clamped(1, 13), Kind{"Sphere", sphere_net()},
                      Kind{"Unclamped", wavy_net(3, 2, open_knots(3, 4), open_knots(2, 3), true)}),
    [](const auto& test) { return test.param.name; });

TEST(NurbsSurface, IsTheSphere) {
  const NurbsSurface sphere(sphere_net());
  for (const Uv uv : points_of(sphere)) {
    EXPECT_NEAR(sphere.evaluate(uv, Order::Position).point.norm(), 1, 1e-15);
  }
}

TEST(NurbsSurface, HasNoDerivativeAlongAPole) {
  for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(1e6, 0.1, -3e5)}) {
    const NurbsSurface sphere(sphere_net(centre));
    for (const double u : {0.0, 0.1, 0.25, 0.9}) {
      for (const double v : {0.0, 1.0}) {
        const Jet pole = sphere.evaluate({u, v}, Order::Second);
        EXPECT_EQ(pole.du, Vec3::Zero());
        EXPECT_EQ(pole.duu, Vec3::Zero());
        EXPECT_GT(pole.dv.norm(), 1);
        EXPECT_GT(pole.duv.norm(), 1);
      }
    }
  }
}

TEST(NurbsSurface, KeepsSmallDerivativesBesideAPole) {
  const NurbsSurface sphere(sphere_net());
  EXPECT_GT(sphere.evaluate({0.1, 1e-9}, Order::Second).du.norm(), 1e-9);
}

TEST(NurbsSurface, KeepsTheSecondDerivativeOfACusp) {
  const NurbsSurface cusp(strip_net(2, {0, 0, 0, 1, 1, 1}, {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}));
  const Jet jet = cusp.evaluate({0, 0.5}, Order::Second);
  EXPECT_EQ(jet.du, Vec3::Zero());
  EXPECT_NEAR(jet.duu.x(), 2, 1e-14);
}

TEST(NurbsSurface, HasKnotSpansAsCells) {
  const NurbsSurface surface(wavy_net(2, 1, {0, 0, 0, 1, 1, 5, 6, 6, 6}, {0, 0, 2, 3, 3}));
  EXPECT_EQ(surface.cells().u, 3);
  EXPECT_EQ(surface.cells().v, 2);
  EXPECT_EQ(surface.from_cells({2, 1}), (Uv{5, 2}));
  EXPECT_EQ(surface.from_cells({1.5, 2}), (Uv{3, 3}));
  EXPECT_EQ(surface.to_cells({3, 1}), (Uv{1.5, 0.5}));
}

TEST(NurbsSurface, TakesKnotsThatDifferByRoundingAsOne) {
  const NurbsSurface surface(wavy_net(2, 1, {0, 0, 0, 1, 1 + 1e-14, 2, 2, 2}, {0, 0, 1, 1}));
  EXPECT_EQ(surface.cells().u, 2);
}

TEST(NurbsSurface, GoesOnBeyondItsDomain) {
  const NurbsSurface surface(wavy_net(3, 3, clamped_knots(3, 4), clamped_knots(3, 4)));
  const Jet end = surface.evaluate({1, 0}, Order::Second);
  const double h = 1e-7;
  const Jet beyond = surface.evaluate({1 + h, -h}, Order::Second);
  expect_near(beyond.point, end.point + h * (end.du - end.dv), 1e-11, "point");
  expect_near(beyond.duu, end.duu, 1e-3, "duu");
}

/// Two straight parts that meet at u = 1.
NurbsNet roof() { return strip_net(1, {0, 0, 1, 2, 2}, {{0, 0, 0}, {1, 0, 1}, {2, 0, 0}}); }

TEST(NurbsSurface, HasAtAKnotTheDerivativesBehindIt) {
  EXPECT_EQ(NurbsSurface(roof()).evaluate({1, 0}, Order::First).du, Vec3(1, 0, -1));
  const NurbsSurface first(roof(), {0, 1, 0, 1});
  EXPECT_EQ(first.evaluate({1, 0}, Order::First).du, Vec3(1, 0, 1));
  EXPECT_EQ(first.cells().u, 1);
}

TEST(NurbsSurface, IsTheSameOnAPartOfItsDomain) {
  const NurbsNet net = wavy_net(3, 2, clamped_knots(3, 6), clamped_knots(2, 4), true);
  const NurbsSurface whole(net), part(net, {0.2, 0.7, 0.25, 0.9});
  EXPECT_EQ(part.domain().u1, 0.7);
  EXPECT_EQ(part.cells().u, 4);
  EXPECT_EQ(part.from_cells({0, 0}), (Uv{0.2, 0.25}));
  for (const Uv uv : points_of(part)) {
    expect_near(part.evaluate(uv, Order::Second).duu, whole.evaluate(uv, Order::Second).duu, 1e-10,
                "duu");
  }
}

/// A tube around the z axis that closes smoothly.
NurbsNet periodic_tube() {
  NurbsNet net{{3, 1}, {{{0, 1, 2, 3, 4, 5, 6}, {0, 0, 1, 1}}}, {}, {}, {{true, false}}};
  for (int j = 0; j < 2; ++j) {
    std::vector<Vec3>& row = net.points.emplace_back();
    for (int i = 0; i < 6; ++i) {
      const double angle = i * std::numbers::pi / 3;
      row.push_back({std::cos(angle), std::sin(angle), 1.0 * j});
    }
  }
  return net;
}

TEST(NurbsSurface, ClosesWhereItIsPeriodic) {
  const NurbsSurface tube(periodic_tube());
  EXPECT_EQ(tube.domain().u1, 6);
  const Jet start = tube.evaluate({0, 0.5}, Order::Second);
  const Jet end = tube.evaluate({6, 0.5}, Order::Second);
  expect_near(start.point, end.point, 1e-15, "point");
  expect_near(start.du, end.du, 1e-14, "du");
  expect_near(start.duu, end.duu, 1e-13, "duu");
}

TEST(NurbsSurface, IsWrappedOutsideOfItsPeriod) {
  const NurbsSurface tube(periodic_tube());
  for (const double u : {0.3, 2.0, 5.7}) {
    const Vec3 point = tube.evaluate({u, 0.5}, Order::Position).point;
    for (const double turns : {-2, -1, 1, 3}) {
      expect_near(tube.evaluate({u + 6 * turns, 0.5}, Order::Position).point, point, 1e-14,
                  "point");
    }
  }
}

TEST(NurbsSurface, HasADomainAnywhereAlongItsPeriod) {
  const NurbsNet net = periodic_tube();
  const NurbsSurface whole(net), part(net, {-2.5, 1.5, 0, 1}), moved(net, {10, 16, 0, 1});
  EXPECT_EQ(part.cells().u, 5);
  EXPECT_EQ(moved.cells().u, 6);
  for (const double u : {-2.5, -1.0, 0.0, 1.5, 12.3}) {
    const Vec3 point = whole.evaluate({u, 0.5}, Order::Position).point;
    expect_near(part.evaluate({u, 0.5}, Order::Position).point, point, 1e-14, "part");
    expect_near(moved.evaluate({u, 0.5}, Order::Position).point, point, 1e-14, "moved");
  }
}

TEST(NurbsSurface, IsTheOneOfRepeatedPointsWhereItIsPeriodic) {
  NurbsNet repeated = periodic_tube();
  repeated.periodic = {false, false};
  repeated.knots[0] = {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  for (std::vector<Vec3>& row : repeated.points) {
    for (std::size_t i = 0; i < 3; ++i) row.push_back(row[i]);
  }
  const NurbsSurface periodic(periodic_tube()), surface(repeated);
  for (const Uv uv : points_of(surface)) {
    expect_near(periodic.evaluate(uv, Order::Second).duu, surface.evaluate(uv, Order::Second).duu,
                1e-13, "duu");
  }
}

TEST(NurbsSurface, RefusesDomainsBeyondItsKnots) {
  const NurbsNet net = wavy_net(1, 1, {0, 0, 1, 1}, {0, 0, 1, 1});
  EXPECT_EQ(
      error_of([&] {
        NurbsSurface(net, {0, 1.5, 0, 1});
      }),
      "invalid input: the domain in u is from 0 to 1.5, but the knots only reach from 0 to 1");
  EXPECT_NE(error_of([&] { NurbsSurface(net, {1, 0, 0, 1}); }), "no error");
  EXPECT_EQ(error_of([&] {
              NurbsSurface(periodic_tube(), {0, 7, 0, 1});
            }),
            "invalid input: the domain is longer in u than the period of the knots, 6");
}

TEST(NurbsSurface, ReportsWhereItIsNotFinite) {
  const NurbsSurface surface(roof());
  EXPECT_NE(error_of([&] { surface.evaluate({kUnset, 0}, Order::Second); }), "no error");
}

}  // namespace
}  // namespace surfmesh
