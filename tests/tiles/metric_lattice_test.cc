// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/tiles/metric_lattice.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/domain_meshes.hh"
#include "support/metric_fields.hh"
#include "tiles/flat_polygons.hh"

namespace surfmesh::detail {
namespace {

using testing::constant_field;
using testing::FlatPolygon;
using testing::FunctionField;

/// The rectangle from (1, 2) to (5, 4).
FlatPolygon rectangle() { return {{{1, 2}, {5, 2}, {5, 4}, {1, 4}}}; }

/// Sides of 2 along u and 3 along v are units.
FunctionField stretched() { return constant_field({1.0 / 4, 0, 1.0 / 9}); }

/// √det M is u.
FunctionField growing_along_u() {
  return FunctionField([](Uv uv) { return Metric{uv.u * uv.u, 0, 1}; });
}

TEST(MetricLattice, HasTheBoxOfItsPolygon) {
  const FlatPolygon polygon = rectangle();
  const MetricLattice lattice(polygon.sides, polygon.nodes, stretched());
  EXPECT_EQ(lattice.box().lower, (Uv{1, 2}));
  EXPECT_EQ(lattice.box().upper, (Uv{5, 4}));
}

TEST(MetricLattice, MeasuresExtentsInTheMetric) {
  const FlatPolygon polygon = rectangle();
  const MetricLattice lattice(polygon.sides, polygon.nodes, stretched());
  EXPECT_NEAR(lattice.extent(0), 2, 1e-12);
  EXPECT_NEAR(lattice.extent(1), 2.0 / 3, 1e-12);
}

TEST(MetricLattice, TakesTheMeanOfLengthsForAnExtent) {
  const FlatPolygon polygon = rectangle();
  const MetricLattice lattice(polygon.sides, polygon.nodes, growing_along_u());
  EXPECT_NEAR(lattice.extent(0), 3 * 4, 1e-12);
  EXPECT_NEAR(lattice.extent(1), 2, 1e-12);
}

TEST(MetricLattice, SharesAConstantMetricOutEvenly) {
  const FlatPolygon polygon = rectangle();
  const MetricLattice lattice(polygon.sides, polygon.nodes, stretched());
  for (const double share : {0.0, 0.1, 1.0 / 3, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(lattice.coordinate_at(0, share), 1 + 4 * share, 1e-9);
    EXPECT_NEAR(lattice.coordinate_at(1, share), 2 + 2 * share, 1e-9);
  }
}

TEST(MetricLattice, FindsWhereAShareOfTheAreaLies) {
  const FlatPolygon polygon = rectangle();
  const MetricLattice lattice(polygon.sides, polygon.nodes, growing_along_u());
  // ∫ u du from 1 to x is (x² − 1)/2, of 12 in all.
  for (const double share : {0.2, 0.5, 0.8}) {
    EXPECT_NEAR(lattice.coordinate_at(0, share), std::sqrt(1 + 24 * share), 1e-3);
    EXPECT_NEAR(lattice.coordinate_at(1, share), 2 + 2 * share, 1e-9);
  }
}

TEST(MetricLattice, CountsAHoleAsNothing) {
  FlatPolygon polygon({{{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {{1, 0}, {1, 1}, {2, 1}, {2, 0}}});
  const MetricLattice lattice(polygon.sides, polygon.nodes, testing::isotropic_field(1));
  EXPECT_NEAR(lattice.coordinate_at(0, 1.0 / 3), 1, 1e-9);
  EXPECT_NEAR(lattice.coordinate_at(0, 2.0 / 3), 3, 1e-9);
}

TEST(MetricLattice, SharesAreasOutAmongParts) {
  const FlatPolygon polygon = rectangle();
  const MetricLattice lattice(polygon.sides, polygon.nodes, growing_along_u());
  const FlatPolygon left{{{1, 2}, {3, 2}, {3, 4}, {1, 4}}};
  const FlatPolygon right{{{3, 2}, {5, 2}, {5, 4}, {3, 4}}};
  const double of_left = lattice.area_in(left.sides, left.nodes);
  const double of_right = lattice.area_in(right.sides, right.nodes);
  EXPECT_NEAR(of_left / of_right, 4.0 / 8, 1e-9);
  EXPECT_NEAR(lattice.area_in(polygon.sides, polygon.nodes), of_left + of_right, 1e-9);
}

TEST(MetricLattice, MeasuresARoundDomain) {
  const FlatPolygon disc{testing::circle({3, 3}, 2, 400)};
  const MetricLattice lattice(disc.sides, disc.nodes, testing::isotropic_field(0.1));
  EXPECT_NEAR(lattice.coordinate_at(0, 0.5), 3, 1e-9);
  EXPECT_NEAR(lattice.coordinate_at(1, 0.5), 3, 1e-9);
  EXPECT_NEAR(lattice.extent(0), 40, 1e-2);
  const FlatPolygon within{testing::circle({3, 3}, 1, 400)};
  EXPECT_NEAR(lattice.area_in(within.sides, within.nodes) / lattice.area_in(disc.sides, disc.nodes),
              0.25, 0.01);
}

TEST(MetricLattice, AsksOnlyInside) {
  const FlatPolygon square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const FlatPolygon triangle{{{0, 0}, {1, 0}, {0, 1}}};
  const FunctionField everywhere = testing::isotropic_field(1);
  EXPECT_EQ(MetricLattice(square.sides, square.nodes, everywhere).queries().total(), 64u * 64u);
  const FunctionField below([](Uv uv) {
    EXPECT_LE(uv.u + uv.v, 1);
    return testing::isotropic_metric(1);
  });
  const MetricLattice half(triangle.sides, triangle.nodes, below);
  EXPECT_NEAR(static_cast<double>(half.queries().total()), 64 * 64 / 2, 64);
  EXPECT_EQ(half.queries().total(), below.queries());
}

TEST(MetricLattice, HasNoAreaOnALine) {
  const FlatPolygon line{{{0, 0}, {1, 0}, {2, 0}}};
  const MetricLattice lattice(line.sides, line.nodes, testing::isotropic_field(1));
  EXPECT_FALSE(lattice.has_area());
  EXPECT_EQ(lattice.queries().total(), 0u);
}

TEST(MetricLattice, LeavesOutWhereTheMetricIsNotFinite) {
  const FlatPolygon square{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}};
  const FunctionField half([](Uv uv) {
    return testing::isotropic_metric(uv.u < 1 ? std::numeric_limits<double>::quiet_NaN() : 1.0);
  });
  const MetricLattice lattice(square.sides, square.nodes, half);
  EXPECT_TRUE(lattice.has_area());
  EXPECT_NEAR(lattice.coordinate_at(0, 0.5), 1.5, 1e-9);
  const FunctionField nowhere([](Uv) { return Metric{kUnset, 0, kUnset}; });
  EXPECT_FALSE(MetricLattice(square.sides, square.nodes, nowhere).has_area());
}

}  // namespace
}  // namespace surfmesh::detail
