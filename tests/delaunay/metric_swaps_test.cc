// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/metric_swaps.hh"

#include <gtest/gtest.h>

#include "support/domain_meshes.hh"
#include "support/expect_valid.hh"

namespace surfmesh {
namespace {

using testing::FunctionField;
using testing::least_quality;
using testing::random_points;
using testing::valid_area;

/// A Delaunay triangulation of random points in the plane, with the metric of a field.
std::unique_ptr<DelaunayMesh> random_mesh(int count, const FunctionField& field) {
  auto delaunay = std::make_unique<DelaunayMesh>(Uv{0, 0}, Uv{1, 1});
  const ConstantMetricRule rule{delaunay->uv_handle()};
  for (const Uv p : random_points(count, 7)) delaunay->insert(p, FaceHandle(0), rule);
  delaunay->shrink();
  for (std::size_t i = 0; i < delaunay->n_vertices(); ++i) {
    const VertexHandle vh(static_cast<int>(i));
    delaunay->metric(vh) = field(delaunay->uv(vh));
  }
  return delaunay;
}

struct NamedField {
  const char* name;
  FunctionField field;
};

void PrintTo(const NamedField& named, std::ostream* out) { *out << named.name; }

class MetricSwaps : public ::testing::TestWithParam<NamedField> {
 protected:
  const FunctionField& field() const { return GetParam().field; }
};

TEST_P(MetricSwaps, NeverLowerTheLeastQuality) {
  const auto delaunay = random_mesh(1000, field());
  const double before = least_quality(*delaunay);
  EXPECT_GT(swap_edges(*delaunay), 0u);
  EXPECT_GE(least_quality(*delaunay), before);
}

TEST_P(MetricSwaps, KeepEveryTriangleValid) {
  const auto delaunay = random_mesh(1000, field());
  swap_edges(*delaunay);
  EXPECT_NEAR(valid_area(*delaunay), 1, 1e-12);
  testing::expect_valid(delaunay->mesh());
}

TEST_P(MetricSwaps, LeaveNothingToSwap) {
  const auto delaunay = random_mesh(1000, field());
  swap_edges(*delaunay);
  EXPECT_EQ(swap_edges(*delaunay), 0u);
}

/// Edges that are passed over would not have been swapped.
TEST_P(MetricSwaps, AreThoseOfAListOfAllEdges) {
  const auto delaunay = random_mesh(1000, field()), reference = random_mesh(1000, field());
  std::vector<EdgeHandle> edges;  // taken from the end
  for (std::size_t i = reference->n_edges(); i > 0; --i)
    edges.emplace_back(static_cast<int>(i - 1));
  EXPECT_EQ(swap_edges(*delaunay), swap_edges(*reference, edges));
  EXPECT_EQ(testing::connectivity(*delaunay), testing::connectivity(*reference));
}

TEST_P(MetricSwaps, KeepConstrainedEdges) {
  const auto delaunay = random_mesh(300, field());
  for (std::size_t i = 0; i < delaunay->n_edges(); ++i) {
    delaunay->constrain(EdgeHandle(static_cast<int>(i)));
  }
  const std::vector<int> before = testing::connectivity(*delaunay);
  EXPECT_EQ(swap_edges(*delaunay), 0u);
  EXPECT_EQ(testing::connectivity(*delaunay), before);
}

INSTANTIATE_TEST_SUITE_P(
    Fields, MetricSwaps,
    ::testing::Values(NamedField{"Aspect10", testing::constant_field({1, 0, 100})},
                      NamedField{"Turned", testing::constant_field({2, 1.3, 1})},
                      NamedField{"FourPoints", testing::four_point_field()},
                      NamedField{"Shock1000", testing::shock_field(1000)},
                      NamedField{"Ring", testing::ring_field(1e-3)}),
    [](const auto& test) { return std::string(test.param.name); });

/// The unit square cut from (0,0) to (1,1), in one metric.
std::unique_ptr<DelaunayMesh> square(const Metric& metric) {
  auto delaunay = std::make_unique<DelaunayMesh>(Uv{0, 0}, Uv{1, 1});
  for (int i = 0; i < 4; ++i) delaunay->metric(VertexHandle(i)) = metric;
  return delaunay;
}

TEST(SwapEdges, SwapsTheDiagonalThatIsLongInTheMetric) {
  const auto delaunay = square({1, 0.5, 1});
  EXPECT_EQ(swap_edges(*delaunay), 1u);
  EXPECT_TRUE(delaunay->find_halfedge(VertexHandle(1), VertexHandle(3)).is_valid());
}

TEST(SwapEdges, KeepsTheDiagonalThatIsShortInTheMetric) {
  EXPECT_EQ(swap_edges(*square({1, -0.5, 1})), 0u);
}

TEST(SwapEdges, DoesNotSwapForNothing) { EXPECT_EQ(swap_edges(*square({1, 0, 1})), 0u); }

TEST(SwapEdges, OfNoEdgesDoesNothing) {
  const auto delaunay = square({1, 0.5, 1});
  EXPECT_EQ(swap_edges(*delaunay, std::vector<EdgeHandle>()), 0u);
}

TEST(SwapEdges, KeepsAQuadrilateralThatIsNotConvex) {
  DelaunayMesh delaunay({{0, 0}, {1, 0.4}, {0, 1}, {0.2, 0.4}}, {{0, 1, 3}, {3, 1, 2}});
  for (int i = 0; i < 4; ++i) delaunay.metric(VertexHandle(i)) = {1, 0, 1};
  EXPECT_EQ(swap_edges(delaunay), 0u);
}

TEST(SwapEdges, EndsWhereTheMetricIsUnset) { EXPECT_EQ(swap_edges(*square(Metric())), 0u); }

}  // namespace
}  // namespace surfmesh
