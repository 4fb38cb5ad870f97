// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/chart_surface.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "cage/cages.hh"
#include "cage/region_topology.hh"
#include "support/errors.hh"

namespace surfmesh {
namespace {

using testing::RegionTopology;

/// A sheet over the square [0,n]² of the plane, with waves of this height.
Cage wavy_sheet(int n, double height) {
  Cage cage;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      // Rows are shifted and stretched: faces are of many shapes.
      const double x = i + 0.3 * std::sin(1.7 * j), y = j + 0.2 * std::cos(2.3 * i);
      cage.points.emplace_back(x, y, height * std::sin(0.6 * x) * std::cos(0.5 * y));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int at = j * (n + 1) + i;
      cage.faces.push_back({at, at + 1, at + n + 2, at + n + 1});
    }
  }
  return cage;
}

/// All faces of a cage in one chart over the plane z = 0.
Chart whole_chart(const RegionTopology& cage) {
  const FaceNeighbours neighbours = cage.neighbours();
  std::vector<ChartFace> faces;
  for (int f = 0; f < neighbours.face_count(); ++f) {
    ChartFace face{cage.surfaces[static_cast<std::size_t>(f)]};
    for (int side = 0; side < neighbours.corner_count(); ++side) {
      const auto beyond = neighbours.across({f, side});
      face.neighbours[static_cast<std::size_t>(side)] = {beyond.face, beyond.side};
      face.vertices[static_cast<std::size_t>(side)] = neighbours.vertex({f, side});
    }
    faces.push_back(std::move(face));
  }
  return Chart({Vec3(1, 2, 3), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, std::move(faces));
}

class ChartTest : public ::testing::TestWithParam<bool> {
 protected:
  /// Triangles, half of whose vertices are irregular, or quads.
  static Cage cage() {
    return GetParam() ? testing::triangulated(wavy_sheet(9, 0.8)) : wavy_sheet(9, 0.8);
  }
};

/// Points of a unit square or triangle, on its border, too.
std::vector<Uv> samples(const Domain& domain) {
  std::vector<Uv> points;
  for (const double s : {0.0, 0.21, 0.5, 0.83, 1.0}) {
    for (const double t : {0.0, 0.13, 0.5, 0.9, 1.0}) {
      points.push_back(domain.fold(domain.at(s, t)));
    }
  }
  return points;
}

TEST_P(ChartTest, IsThatOfItsFaces) {
  const RegionTopology topology(cage());
  const Chart chart = whole_chart(topology);
  for (std::size_t f = 0; f < topology.surfaces.size(); ++f) {
    const Surface& face = *topology.surfaces[f];
    for (const Uv at : samples(face.domain())) {
      const Jet there = face.evaluate(at, Order::First);
      const Uv uv = chart.frame().project(there.point);
      ASSERT_TRUE(chart.point_on_faces(uv)) << "face " << f << " at " << at.u << ", " << at.v;
      const Jet jet = chart.evaluate(uv, Order::First);
      EXPECT_LT((jet.point - there.point).norm(), 1e-13);
      // On sides the other face may tell; at extraordinary vertices they differ.
      const bool is_inside = at.u > 0 && at.v > 0 && at.u < 1 && at.v < 1 && at.u + at.v != 1;
      if (!is_inside) continue;
      const Vec3 normal = there.du.cross(there.dv).normalized();
      EXPECT_GT(jet.du.cross(jet.dv).normalized().dot(normal), 1 - 1e-12);
    }
  }
}

/// The parameters are coordinates in the plane, so derivatives in it are known.
TEST_P(ChartTest, ParametersAreCoordinatesInThePlane) {
  const Chart chart = whole_chart(RegionTopology(cage()));
  for (const Uv uv : {Uv{2.1, 1.3}, Uv{3.77, 4.2}, Uv{0.9, 5.01}}) {
    const Jet jet = chart.evaluate(uv, Order::Second);
    EXPECT_NEAR(jet.point.x(), 1 + uv.u, 1e-14);
    EXPECT_NEAR(jet.point.y(), 2 + uv.v, 1e-14);
    EXPECT_NEAR(jet.du.x(), 1, 1e-12);
    EXPECT_NEAR(jet.du.y(), 0, 1e-12);
    EXPECT_NEAR(jet.dv.x(), 0, 1e-12);
    EXPECT_NEAR(jet.dv.y(), 1, 1e-12);
    for (const Vec3& second : {jet.duu, jet.duv, jet.dvv}) {
      EXPECT_NEAR(second.head<2>().norm(), 0, 1e-10);
    }
  }
}

TEST_P(ChartTest, FirstDerivativesAreThoseOfDifferences) {
  const Chart chart = whole_chart(RegionTopology(cage()));
  constexpr double h = 1e-4;
  for (const Uv uv : {Uv{2.13, 1.37}, Uv{3.77, 4.21}, Uv{1.9, 5.03}}) {
    const Jet jet = chart.evaluate(uv, Order::Second);
    const auto point = [&](Uv step) { return chart.evaluate(uv + step, Order::Position).point; };
    EXPECT_LT((jet.du - (point({h, 0}) - point({-h, 0})) / (2 * h)).norm(), 1e-6);
    EXPECT_LT((jet.dv - (point({0, h}) - point({0, -h})) / (2 * h)).norm(), 1e-6);
  }
}

/// Of a paraboloid: how it bends is the same everywhere, though faces are of many shapes. Within
/// faces the limit surface of irregular ones ripples by a half and more.
TEST_P(ChartTest, SecondDerivativesAreThoseOfTheWholeNotOfFaces) {
  Cage sheet = wavy_sheet(16, 0);
  for (Vec3& p : sheet.points) p.z() = 0.02 * p.x() * p.x() + 0.01 * p.x() * p.y();
  if (GetParam()) sheet = testing::triangulated(sheet);
  const Chart chart = whole_chart(RegionTopology(sheet));
  for (double u = 3; u < 11; u += 0.37) {
    const Jet jet = chart.evaluate({u, 14 - u}, Order::Second);
    EXPECT_NEAR(jet.duu.z(), 0.04, 0.006) << u;
    EXPECT_NEAR(jet.duv.z(), 0.01, 0.006) << u;
    EXPECT_NEAR(jet.dvv.z(), 0, 0.006) << u;
  }
}

/// Control spaces sample all of the domain, of which the faces cover a part.
TEST_P(ChartTest, GoesOnBeyondItsFaces) {
  const Chart chart = whole_chart(RegionTopology(cage()));
  const Uv outside{-1.5, 3.2};
  EXPECT_FALSE(chart.point_on_faces(outside));
  const Jet jet = chart.evaluate(outside, Order::Second);
  EXPECT_NEAR(jet.point.x(), 1 + outside.u, 1e-12);
  EXPECT_TRUE(jet.duu.allFinite() && jet.duv.allFinite() && jet.dvv.allFinite());
  EXPECT_LT(std::abs(jet.point.z() - 3), 5);
  // Over the border, where it begins, nothing jumps.
  for (double u = -1; u < 0.5; u += 0.01) {
    const Jet a = chart.evaluate({u, 3.2}, Order::First);
    const Jet b = chart.evaluate({u + 1e-7, 3.2}, Order::First);
    EXPECT_LT((a.point - b.point).norm(), 1e-5) << u;
  }
}

TEST_P(ChartTest, TellsThePlaceOnTheCage) {
  const Cage given = cage();
  const RegionTopology topology(given);
  const Chart chart = whole_chart(topology);
  for (std::size_t f = 0; f < topology.surfaces.size(); f += 7) {
    const Uv at{0.3, 0.4};
    const Uv uv = chart.frame().project(topology.surfaces[f]->evaluate(at, Order::Position).point);
    const CagePlace place = chart.place(uv);
    EXPECT_EQ(place.face, static_cast<int>(f));
    EXPECT_NEAR(place.uv.u, at.u, 1e-6);
    EXPECT_NEAR(place.uv.v, at.v, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Faces, ChartTest, ::testing::Bool(),
                         [](const auto& kind) { return kind.param ? "Triangles" : "Quads"; });

TEST(Chart, RefusesNothingAndNaN) {
  EXPECT_EQ(error_of([] { Chart(ChartFrame(), {}); }), "invalid input: a chart has no faces");
  const Chart chart = whole_chart(RegionTopology(wavy_sheet(3, 0.1)));
  const Uv nowhere{std::numeric_limits<double>::quiet_NaN(), 0};
  EXPECT_EQ(error_of([&] { chart.evaluate(nowhere, Order::Position); }),
            "geometry: a chart is evaluated at a point that is not finite");
}

TEST(ChartFrame, HasAxesThatTurnCounterClockwise) {
  const ChartFrame frame = ChartFrame::at(Vec3(1, 2, 3), Vec3(0.6, 0, 0.8));
  EXPECT_NEAR(frame.along_u.cross(frame.along_v).dot(frame.normal), 1, 1e-14);
  const Uv uv = frame.project(frame.origin + 2 * frame.along_u - 3 * frame.along_v);
  EXPECT_NEAR(uv.u, 2, 1e-14);
  EXPECT_NEAR(uv.v, -3, 1e-14);
}

}  // namespace
}  // namespace surfmesh
