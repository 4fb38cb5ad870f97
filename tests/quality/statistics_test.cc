// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/statistics.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/meshes.hh"
#include "support/tensors.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/quality/quality_histogram.hh"

namespace surfmesh {
namespace {

using testing::disc;
using testing::plane_grid;

std::size_t total(const std::vector<HistogramBin>& histogram) {
  std::size_t sum = 0;
  for (const HistogramBin& bin : histogram) sum += bin.count;
  return sum;
}

TEST(TriangleQuality, OfTheUnitTriangleOfAMetricIsOne) {
  const SizeTensor h = size_tensor(0.5, 0.02, 0.3);
  const Metric m = testing::metric_of(h);
  // H takes the unit triangle of the plane to that of the metric.
  const auto image = [&](double x, double y) {
    return Uv{h.h11 * x + h.h12 * y, h.h12 * x + h.h22 * y};
  };
  const Uv a = image(0, 0), b = image(1, 0), c = image(0.5, 0.5 * std::numbers::sqrt3);
  EXPECT_NEAR(triangle_quality(a, b, c, m), 1, 1e-12);
  EXPECT_NEAR(triangle_quality(b, c, a, m), 1, 1e-12);
  EXPECT_NEAR(triangle_quality(b, a, c, m), -1, 1e-12);
}

TEST(TriangleQuality, OfTheHalfSquareIsRootThreeOverTwo) {
  EXPECT_NEAR(triangle_quality({0, 0}, {1, 0}, {0, 1}, {1, 0, 1}), std::numbers::sqrt3 / 2, 1e-15);
}

TEST(TriangleQuality, OfNoAreaIsZero) {
  EXPECT_EQ(triangle_quality({0, 0}, {1, 1}, {2, 2}, {1, 0, 1}), 0);
  EXPECT_EQ(triangle_quality({1, 1}, {1, 1}, {1, 1}, {1, 0, 1}), 0);
}

TEST(TriangleQuality, DoesNotDependOnTheScaleOfTheParameters) {
  const Metric m{4, 1, 2};
  const Metric scaled = testing::with_scaled_parameters(m, 1e6, 1e-3);
  EXPECT_NEAR(triangle_quality({0, 0}, {1e6, 2e-4}, {3e5, 1e-3}, scaled),
              triangle_quality({0, 0}, {1, 0.2}, {0.3, 1}, m), 1e-14);
}

TEST(MeasureEdges, OfUnitTrianglesHasNoDeviation) {
  const EdgeStatistics s = measure_edges(disc(6));
  EXPECT_EQ(s.count, 12u);
  EXPECT_NEAR(s.mean, 1, 1e-15);
  EXPECT_NEAR(s.stddev, 0, 1e-15);
  EXPECT_NEAR(s.min, 1, 1e-15);
  EXPECT_NEAR(s.max, 1, 1e-15);
  EXPECT_EQ(s.unit_fraction, 1);
}

TEST(MeasureEdges, CountsEachEdgeOnce) {
  // 2 × 1 squares: 7 sides of length 1 and 2 diagonals.
  const EdgeStatistics s = measure_edges(plane_grid(2, 1, {4, 0, 4}));
  const double mean = 2 * (7 + 2 * std::numbers::sqrt2) / 9;
  EXPECT_EQ(s.count, 9u);
  EXPECT_NEAR(s.mean, mean, 1e-14);
  EXPECT_NEAR(s.stddev, std::sqrt(4 * (7 + 2 * 2) / 9.0 - mean * mean), 1e-14);
  EXPECT_NEAR(s.min, 2, 1e-15);
  EXPECT_NEAR(s.max, 2 * std::numbers::sqrt2, 1e-15);
  EXPECT_EQ(s.unit_fraction, 0);
}

TEST(MeasureEdges, TakesTheLengthOfASizeThatChangesGeometrically) {
  PolyMesh mesh = testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-6, 0}}, {{0, 1, 2}});
  testing::attach_plane_properties(mesh);
  const auto metric = require(mesh, keys::corner_metric);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    const double size = std::pow(4.0, mesh.point(mesh.to_vertex_handle(heh))[0]);
    mesh.property(metric, heh) = {1 / (size * size), 0, 1 / (size * size)};
  }
  // ∫ 4^-s ds over [0, 1] is the longest of the three.
  EXPECT_NEAR(measure_edges(mesh).max, (1 - 0.25) / std::log(4.0), 1e-12);
}

TEST(MeasureEdges, ReadsTheCornersOfAFaceAndNotThoseOfTheBoundary) {
  PolyMesh mesh = disc(6);
  const auto uv = require(mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.is_boundary(heh)) mesh.property(uv, heh) = Uv();
  }
  EXPECT_NEAR(measure_edges(mesh).mean, 1, 1e-15);
}

TEST(MeasureEdges, FillsTheHistogram) {
  const EdgeStatistics s = measure_edges(plane_grid(2, 1, {2, 0, 2}));
  EXPECT_EQ(total(s.histogram), s.count);
  EXPECT_EQ(s.histogram.front().from, 0);
  for (std::size_t i = 1; i < s.histogram.size(); ++i) {
    EXPECT_EQ(s.histogram[i].from, s.histogram[i - 1].to);
  }
  // Diagonals have length 2, or a hair less.
  std::size_t around_two = 0;
  for (const HistogramBin& bin : s.histogram) {
    if (bin.from < 2.1 && bin.to > 1.9) around_two += bin.count;
  }
  EXPECT_EQ(around_two, 2u);
}

TEST(MeasureEdges, HasBinsForTheShortestAndTheLongest) {
  const EdgeStatistics longest = measure_edges(plane_grid(1, 1, {1e8, 0, 1e8}));
  EXPECT_EQ(longest.histogram.back().count, longest.count);
  EXPECT_EQ(longest.histogram.back().to, longest.max);
  const EdgeStatistics shortest = measure_edges(plane_grid(1, 1, {0, 0, 0}));
  EXPECT_EQ(shortest.histogram.front().count, shortest.count);
}

TEST(MeasureEdges, HasTheUnitIntervalInItsMiddleBins) {
  const auto histogram = measure_edges(disc(6)).histogram;
  const std::size_t middle = histogram.size() / 2;
  EXPECT_NEAR(histogram[middle - 2].from, 1 / std::numbers::sqrt2, 1e-15);
  EXPECT_NEAR(histogram[middle + 1].to, std::numbers::sqrt2, 1e-15);
}

TEST(MeasureEdges, OfNothingIsZero) {
  PolyMesh mesh;
  testing::attach_plane_properties(mesh);
  const EdgeStatistics s = measure_edges(mesh);
  EXPECT_EQ(s.count, 0u);
  EXPECT_EQ(s.mean, 0);
  EXPECT_EQ(s.min, 0);
  EXPECT_EQ(s.unit_fraction, 0);
}

TEST(MeasureEdges, NamesAMissingProperty) {
  EXPECT_THROW(measure_edges(testing::octahedron<PolyMesh>()), Error);
}

TEST(MeasureEdges, RefusesACornerThatIsNotSet) {
  PolyMesh mesh = disc(6);
  mesh.property(require(mesh, keys::corner_uv), mesh.halfedge_handle(FaceHandle(2))) = Uv();
  EXPECT_THROW(measure_edges(mesh), Error);
  EXPECT_THROW(measure_quality(mesh), Error);
}

TEST(MeasureEdges, TakesASingularMetric) {
  // A diagonal has no length; rounding of the entries has made its square negative.
  const EdgeStatistics s = measure_edges(plane_grid(1, 1, {1, -1 - 1e-15, 1}));
  EXPECT_EQ(s.min, 0);
  EXPECT_EQ(s.max, 1);
}

TEST(MeasureQuality, OfUnitTrianglesIsOne) {
  const QualityStatistics s = measure_quality(disc(6));
  EXPECT_EQ(s.count, 6u);
  EXPECT_NEAR(s.min, 1, 1e-14);
  EXPECT_NEAR(s.mean, 1, 1e-14);
  EXPECT_EQ(s.below_0_3, 0);
}

TEST(MeasureQuality, CountsPoorTriangles) {
  // Half squares stretched by 20: Q = 4√3 · 10 / (1 + 400 + 401).
  const QualityStatistics s = measure_quality(plane_grid(3, 3, {400, 0, 1}));
  EXPECT_NEAR(s.mean, 40 * std::numbers::sqrt3 / 802, 1e-14);
  EXPECT_EQ(s.below_0_3, 1);
}

TEST(MeasureQuality, CountsTrianglesByQuality) {
  const QualityStatistics s = measure_quality(plane_grid(3, 3, {400, 0, 1}));
  ASSERT_EQ(s.histogram.size(), 11u);
  EXPECT_EQ(s.histogram.front(), (HistogramBin{-1, 0, 0}));
  EXPECT_EQ(s.histogram[1], (HistogramBin{0, 0.1, 18}));
  EXPECT_EQ(total(s.histogram), s.count);
}

TEST(QualityHistogram, HasItsLimitsInTheUpperBins) {
  auto bins = detail::empty_quality_histogram();
  for (const double quality : {-1.0, -1e-300, 0.0, 0.3, 0.6, 0.7, 1.0, 1 + 1e-15}) {
    detail::count_quality(quality, bins);
  }
  std::vector<std::size_t> counts;
  for (const HistogramBin& bin : bins) counts.push_back(bin.count);
  EXPECT_EQ(counts, (std::vector<std::size_t>{2, 1, 0, 0, 1, 0, 0, 1, 1, 0, 2}));
}

TEST(QualityHistogram, AgreesWithComparisons) {
  for (int i = 1; i <= 10; ++i) {
    auto bins = detail::empty_quality_histogram();
    const double limit = bins[static_cast<std::size_t>(i)].to;
    detail::count_quality(std::nextafter(limit, 0.0), bins);
    EXPECT_EQ(bins[static_cast<std::size_t>(i)].count, 1u) << limit;
  }
}

TEST(MeasureQuality, NamesTheWorstTriangle) {
  PolyMesh mesh =
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 0.01, 0}, {0, 1, 0}}, {{0, 2, 3}, {0, 1, 2}});
  testing::attach_plane_properties(mesh);
  EXPECT_EQ(measure_quality(mesh).worst_face, 1);
}

TEST(MeasureQuality, LeavesQuadsOut) {
  PolyMesh mesh = testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 0}},
                                   {{0, 1, 2, 3}, {1, 4, 2}});
  testing::attach_plane_properties(mesh);
  EXPECT_EQ(measure_quality(mesh).count, 1u);
}

TEST(MeasureQuality, IsNegativeForATriangleThatIsTurnedOver) {
  PolyMesh mesh = plane_grid(2, 2);
  const auto uv = require(mesh, keys::corner_uv);
  // Pull the corner (0,0) of its two triangles over their far edges.
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.to_vertex_handle(heh) == VertexHandle(0)) mesh.property(uv, heh) = {1.2, 1.1};
  }
  EXPECT_LT(measure_quality(mesh).min, 0);
}

TEST(MeasureQuality, TakesAPatchThatIsTurnedAsAWholeForRight) {
  PolyMesh mesh = disc(6);
  const auto uv = require(mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    Uv& corner = mesh.property(uv, heh);
    corner.u = -corner.u;
  }
  EXPECT_NEAR(measure_quality(mesh).min, 1, 1e-14);
}

TEST(MeasureQuality, OfNothingIsZero) {
  PolyMesh mesh;
  testing::attach_plane_properties(mesh);
  EXPECT_EQ(measure_quality(mesh), QualityStatistics());
}

}  // namespace
}  // namespace surfmesh
