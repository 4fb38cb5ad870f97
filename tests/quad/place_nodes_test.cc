// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/place_nodes.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/cancelling.hh"
#include "support/domain_meshes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"

namespace surfmesh {
namespace {

using testing::kUnitSquare;

/// A polygon after its inner nodes have been placed.
struct Placed {
  std::unique_ptr<DelaunayMesh> delaunay;
  std::size_t boundary = 0;
  PlacementReport report;
};

Placed place(const std::vector<std::vector<Uv>>& loops, const MetricField& field,
             const RunContext& context = RunContext()) {
  Placed placed;
  placed.delaunay = triangulate_boundary(loops, field).delaunay;
  std::vector<std::size_t> sizes;
  for (const auto& loop : loops) sizes.push_back(loop.size());
  placed.boundary = placed.delaunay->n_vertices();
  const auto corners = boundary_corners(placed.delaunay->mesh(), sizes);
  placed.report = place_square_nodes(*placed.delaunay, field, corners, context);
  return placed;
}

/// The inner nodes.
std::vector<Uv> nodes_of(const Placed& placed) {
  const std::vector<Uv> all = testing::positions(*placed.delaunay);
  return {all.begin() + static_cast<std::ptrdiff_t>(placed.boundary), all.end()};
}

/// The greatest distance, in steps of the lattice, of a node from one of i/columns, j/rows.
double farthest_from_lattice(const std::vector<Uv>& nodes, int columns, int rows) {
  double farthest = 0;
  for (const Uv& node : nodes) {
    farthest = std::max({farthest, std::abs(node.u * columns - std::round(node.u * columns)),
                         std::abs(node.v * rows - std::round(node.v * rows))});
  }
  return farthest;
}

TEST(PlaceSquareNodes, PlacesALatticeInASquareOfConstantSize) {
  for (const int n : {2, 5, 12, 31}) {
    const auto field = testing::isotropic_field(1.0 / n);
    const Placed placed = place({testing::with_nodes(kUnitSquare, field)}, field);
    EXPECT_EQ(placed.report.inserted, static_cast<std::size_t>((n - 1) * (n - 1)));
    EXPECT_LT(farthest_from_lattice(nodes_of(placed), n, n), 0.01);
    EXPECT_FALSE(placed.report.is_stopped);
    EXPECT_NEAR(testing::valid_area(*placed.delaunay), 1, 1e-12);
  }
}

TEST(PlaceSquareNodes, PlacesALatticeAlongTheAxesOfAMetric) {
  const auto field = testing::constant_field({400, 0, 16});
  const Placed placed = place({testing::with_nodes(kUnitSquare, field)}, field);
  EXPECT_EQ(placed.report.inserted, 19u * 3u);
  EXPECT_LT(farthest_from_lattice(nodes_of(placed), 20, 4), 0.01);
}

/// A square of lattice nodes is seen as a parallelogram in sheared parameters, whose metric is such
/// that it is a square.
TEST(PlaceSquareNodes, PlacesALatticeInShearedParameters) {
  constexpr double shear = 0.6;
  // (x, y) = (u + 0.6 v, v), ten nodes a side.
  const auto field = testing::constant_field({100, 100 * shear, 100 * (1 + shear * shear)});
  std::vector<Uv> parallelogram;
  for (const Uv p : kUnitSquare) parallelogram.push_back({p.u - shear * p.v, p.v});
  const Placed placed = place({testing::with_nodes(parallelogram, field)}, field);
  EXPECT_EQ(placed.report.inserted, 81u);
  std::vector<Uv> seen;
  for (const Uv p : nodes_of(placed)) seen.push_back({p.u + shear * p.v, p.v});
  EXPECT_LT(farthest_from_lattice(seen, 10, 10), 0.01);
}

TEST(PlaceSquareNodes, PlacesALatticeInATurnedSquare) {
  const auto field = testing::isotropic_field(0.1);
  const double c = std::cos(0.4), s = std::sin(0.4);
  std::vector<Uv> turned;
  for (const Uv p : kUnitSquare) turned.push_back({c * p.u - s * p.v, s * p.u + c * p.v});
  const Placed placed = place({testing::with_nodes(turned, field)}, field);
  EXPECT_EQ(placed.report.inserted, 81u);
  std::vector<Uv> seen;
  for (const Uv p : nodes_of(placed)) seen.push_back({c * p.u + s * p.v, c * p.v - s * p.u});
  EXPECT_LT(farthest_from_lattice(seen, 10, 10), 0.01);
}

/// On the plane in polar coordinates the rows follow the circles, though no size tells them to.
TEST(PlaceSquareNodes, KeepsRowsWhereTheMetricTurns) {
  // (u,v) is radius and angle; the metric is flat.
  const auto field = testing::FunctionField([](Uv p) { return Metric{64, 0, 64 * p.u * p.u}; });
  const std::vector<Uv> sector = {{1, 0}, {2, 0}, {2, 0.5}, {1, 0.5}};
  const Placed placed = place({testing::with_nodes(sector, field)}, field);
  EXPECT_GT(placed.report.inserted, 7u * 3u);
  EXPECT_LT(placed.report.inserted, 8u * 8u);
}

TEST(PlaceSquareNodes, KeepsItsDistanceFromOtherNodesAndTheBoundary) {
  const auto field = testing::isotropic_field([](Uv p) { return 0.03 + 0.08 * p.u * p.v; });
  const Placed placed = place({testing::circle({0.5, 0.5}, 0.5, 60)}, field);
  const PolyMesh& mesh = placed.delaunay->mesh();
  for (const EdgeHandle eh : mesh.edges()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    const MetricCorner a = corner(*placed.delaunay, mesh.from_vertex_handle(heh));
    const MetricCorner b = corner(*placed.delaunay, mesh.to_vertex_handle(heh));
    if (mesh.is_boundary(eh)) continue;
    EXPECT_GT(std::sqrt(squared_length(mean(a.metric, b.metric), b.uv - a.uv)), 0.4);
  }
}

TEST(PlaceSquareNodes, FillsTheAreaThatTheMetricAsksFor) {
  const auto field = testing::isotropic_field([](Uv p) { return 0.01 + 0.05 * p.u; });
  const Placed placed = place({testing::with_nodes(kUnitSquare, field)}, field);
  const double squares = testing::metric_area(field);
  EXPECT_NEAR(static_cast<double>(placed.delaunay->n_faces()) / 2, squares, 0.1 * squares);
}

TEST(PlaceSquareNodes, LeavesTheBoundaryAsItIs) {
  const auto field = testing::isotropic_field(0.08);
  const auto loop = testing::circle({0.5, 0.5}, 0.5, 40);
  const Placed placed = place({loop}, field);
  const std::vector<Uv> all = testing::positions(*placed.delaunay);
  EXPECT_EQ(std::vector<Uv>(all.begin(), all.begin() + 40), loop);
  EXPECT_EQ(testing::count_constrained(*placed.delaunay, 0, 40), 40u);
}

TEST(PlaceSquareNodes, HasTheMetricOfTheFieldAtEveryNode) {
  const auto field = testing::shock_field(20);
  const Placed placed = place({testing::with_nodes(kUnitSquare, field)}, field);
  for (std::size_t v = 0; v < placed.delaunay->n_vertices(); ++v) {
    const VertexHandle vh(static_cast<int>(v));
    EXPECT_EQ(placed.delaunay->metric(vh), field(placed.delaunay->uv(vh)));
  }
}

TEST(PlaceSquareNodes, CountsItsQueries) {
  const auto field = testing::isotropic_field(0.05);
  const auto loop = testing::with_nodes(kUnitSquare, field);
  auto triangles = triangulate_boundary({loop}, field).delaunay;
  const std::size_t before = field.queries();
  const std::vector<std::size_t> sizes = {loop.size()};
  const auto report = place_square_nodes(*triangles, field,
                                         boundary_corners(triangles->mesh(), sizes), RunContext());
  EXPECT_EQ(report.queries.total(), field.queries() - before);
  EXPECT_LT(report.queries.total(), 16 * triangles->n_vertices());
}

/// A point of small size in the middle that no step would meet.
class Spot : public MetricField {
 public:
  Metric at(Uv uv, QueryHint& hint) const override {
    ++hint.answers.triangle;
    return testing::isotropic_metric(size(uv));
  }

  std::span<const MetricCorner> required_points() const override { return points_; }

  static constexpr Uv kAt{0.63, 0.37};

 private:
  static double size(Uv uv) {
    return 0.005 + 0.5 * std::min(0.39, std::hypot(uv.u - kAt.u, uv.v - kAt.v));
  }
  std::vector<MetricCorner> points_ = {{kAt, testing::isotropic_metric(size(kAt))}};
};

TEST(PlaceSquareNodes, ResolvesRequiredPoints) {
  const Spot field;
  const auto loop = testing::with_nodes(kUnitSquare, testing::isotropic_field(0.2));
  const Placed placed = place({loop}, field);
  double nearest = 1;
  for (const Uv p : nodes_of(placed)) {
    nearest = std::min(nearest, std::hypot(p.u - Spot::kAt.u, p.v - Spot::kAt.v));
  }
  EXPECT_LT(nearest, 0.01);
}

/// Every triangle asks for another node, as seen from its own metric, without end.
TEST(PlaceSquareNodes, GivesUpWhereDirectionsChangeFasterThanSquaresCanFollow) {
  const auto field = testing::FunctionField([](Uv p) {
    const double angle = 4000 * p.u * p.v;
    return testing::directed_metric({std::cos(angle), std::sin(angle)}, 0.5, 0.0005);
  });
  const Placed placed =
      place({testing::with_nodes(kUnitSquare, testing::isotropic_field(0.2))}, field);
  const double squares = testing::metric_area(field);
  EXPECT_TRUE(placed.report.is_stopped);
  EXPECT_LT(static_cast<double>(placed.delaunay->n_faces()), 8 * squares + 12 * 20);
}

TEST(PlaceSquareNodes, EndsAtTheLimitOfElements) {
  const auto field = testing::isotropic_field(0.01);
  const RunContext context(nullptr, 1000);
  const auto loop = testing::with_nodes(kUnitSquare, field);
  EXPECT_EQ(error_of([&] { place({loop}, field, context); }).rfind("limit: ", 0), 0u);
}

TEST(PlaceSquareNodes, EndsOnceItIsCancelled) {
  testing::Cancelling observer;
  const RunContext context(&observer);
  const auto field = testing::isotropic_field(0.1);
  const auto loop = testing::with_nodes(kUnitSquare, field);
  EXPECT_EQ(error_of([&] { place({loop}, field, context); }), testing::kCancelled);
}

TEST(PlaceSquareNodes, PlacesNothingWhereThereIsNoRoom) {
  const auto field = testing::isotropic_field(1);
  EXPECT_EQ(place({kUnitSquare}, field).report.inserted, 0u);
  EXPECT_EQ(place({{{0, 0}, {1, 0}, {0.5, 0.8}}}, field).report.inserted, 0u);
}

TEST(PlaceSquareNodes, IsTheSameEveryTime) {
  const auto field = testing::ring_field(0.01);
  const auto loop = testing::with_nodes(kUnitSquare, field);
  const Placed a = place({loop}, field), b = place({loop}, field);
  EXPECT_EQ(testing::positions(*a.delaunay), testing::positions(*b.delaunay));
  EXPECT_EQ(testing::connectivity(*a.delaunay), testing::connectivity(*b.delaunay));
}

}  // namespace
}  // namespace surfmesh
