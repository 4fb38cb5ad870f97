// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/tile_summary.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "pieces/tiled_cases.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/pieces/mesh_with_fans.hh"

namespace surfmesh {
namespace {

using testing::MeshedTiles;
using testing::TiledCase;

// --- sums of values ---

/// The sums of values between 0 and 16: the share is that of those above 10, bins are 1 wide.
SummedValues sums_of(const std::vector<double>& values) {
  SummedValues sums;
  if (values.empty()) return sums;
  const auto count = static_cast<double>(values.size());
  double mean = 0, variance = 0;
  for (const double value : values) {
    mean += value / count;
    sums.marked += value > 10 ? 1 : 0;
    ++sums.histogram[static_cast<std::size_t>(value)];
  }
  for (const double value : values) variance += (value - mean) * (value - mean) / count;
  sums.moments = detail::Moments::of(values.size(), mean, std::sqrt(variance));
  sums.min = *std::min_element(values.begin(), values.end());
  sums.max = *std::max_element(values.begin(), values.end());
  return sums;
}

void expect_near(const SummedValues& a, const SummedValues& b) {
  EXPECT_EQ(a.count(), b.count());
  EXPECT_NEAR(a.moments.mean(), b.moments.mean(), 1e-12);
  EXPECT_NEAR(a.moments.stddev(), b.moments.stddev(), 1e-12);
  EXPECT_EQ(a.min, b.min);
  EXPECT_EQ(a.max, b.max);
  EXPECT_EQ(a.marked, b.marked);
  EXPECT_EQ(a.histogram, b.histogram);
}

std::vector<double> random_values(int count, double least, double greatest, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(least, greatest);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(uniform(random));
  return values;
}

TEST(SummedValues, AddUpToThoseOfAllValues) {
  std::vector<double> all;
  SummedValues sums;
  for (const auto& part :
       {random_values(100, 0, 3, 1), random_values(1, 15, 16, 2), random_values(3000, 8, 12, 3),
        std::vector<double>{}, random_values(17, 0, 16, 4)}) {
    sums += sums_of(part);
    all.insert(all.end(), part.begin(), part.end());
    expect_near(sums, sums_of(all));
  }
}

TEST(SummedValues, AreTheSameWithNothing) {
  const SummedValues some = sums_of({1, 2, 11.5}), none;
  SummedValues sums = none;
  sums += none;
  expect_near(sums, none);
  sums += some;
  expect_near(sums, some);
  sums += none;
  expect_near(sums, some);
}

// --- tiles ---

/// Mean, deviation and bounds of values that are set.
struct Moments {
  explicit Moments(const std::vector<double>& values) {
    for (const double value : values) {
      if (std::isnan(value)) continue;
      ++count;
      sum += value;
      min = std::min(min, value);
      max = std::max(max, value);
    }
    const double mean = sum / static_cast<double>(count);
    double squares = 0;
    for (const double value : values) {
      if (!std::isnan(value)) squares += (value - mean) * (value - mean);
    }
    deviation = std::sqrt(squares / static_cast<double>(count));
  }

  double mean() const { return sum / static_cast<double>(count); }

  std::size_t count = 0;
  double sum = 0, deviation = 0;
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
};

/// The share of the values that are set for which a condition holds.
template <class Condition>
double share_of(const std::vector<double>& values, Condition condition) {
  std::size_t count = 0, held = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    ++count;
    if (condition(value)) ++held;
  }
  return static_cast<double>(held) / static_cast<double>(count);
}

std::vector<double> space_jacobians(const PolyMesh& mesh) {
  std::vector<double> values;
  for (const FaceHandle fh : mesh.faces()) {
    values.push_back(mesh.valence(fh) == 4 ? quad_space_jacobian(mesh, fh) : kUnset);
  }
  return values;
}

/// Expect the middle of a face that has the least of values by face.
void expect_worst(const FacePlace& place, const std::vector<double>& values, const PolyMesh& mesh) {
  std::size_t worst = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < values.size(); ++f) {
    if (values[f] < least) {
      worst = f;
      least = values[f];
    }
  }
  const auto middle = mesh.calc_face_centroid(FaceHandle(static_cast<int>(worst)));
  EXPECT_EQ((std::array{place.x, place.y, place.z}), (std::array{middle[0], middle[1], middle[2]}));
}

/// The sum of the areas of faces, each half the product of two sides, or of the diagonals.
double area_of(const PolyMesh& mesh) {
  double area = 0;
  for (const FaceHandle fh : mesh.faces()) {
    std::vector<Vec3> corners;
    for (const VertexHandle vh : mesh.fv_range(fh)) corners.push_back(to_eigen(mesh.point(vh)));
    const Vec3 &a = corners[0], &b = corners[1], &c = corners[2], &d = corners.back();
    area += 0.5 * (corners.size() == 4 ? (c - a).cross(d - b) : (b - a).cross(c - a)).norm();
  }
  return area;
}

/// The tiles of a model with their summaries.
struct Summaries {
  explicit Summaries(const MeshedTiles& meshed) : results(meshed.results()) {
    for (std::size_t t = 0; t < results.size(); ++t) {
      of_tiles.push_back(summary_of(t, results[t], meshed.tiled.model));
      meshes_.push_back(detail::mesh_with_fans(results[t].mesh, meshed.tiled.model));
    }
  }

  /// The mesh of a tile with the faces around its poles.
  const PolyMesh& mesh(std::size_t tile) const { return *meshes_[tile]; }

  std::vector<PatchResult> results;
  std::vector<TileSummary> of_tiles;

 private:
  std::vector<std::unique_ptr<PolyMesh>> meshes_;
};

class SummaryOf : public ::testing::TestWithParam<TiledCase> {
 protected:
  MeshedTiles meshed_{GetParam()};
  Summaries made_{meshed_};
};

TEST_P(SummaryOf, ATileCountsItsFaces) {
  for (std::size_t t = 0; t < made_.of_tiles.size(); ++t) {
    const TileSummary& summary = made_.of_tiles[t];
    const PolyMesh& mesh = made_.mesh(t);
    std::int64_t quads = 0;
    for (const FaceHandle fh : mesh.faces()) quads += mesh.valence(fh) == 4 ? 1 : 0;
    EXPECT_EQ(summary.tile, static_cast<std::int64_t>(t));
    EXPECT_EQ(summary.patch, meshed_.tiles[t].boundary.patch);
    EXPECT_EQ(summary.quads, quads);
    EXPECT_EQ(summary.triangles, static_cast<std::int64_t>(mesh.n_faces()) - quads);
    EXPECT_NEAR(summary.area, area_of(mesh), 1e-12 * summary.area);
    EXPECT_EQ(summary.turned, static_cast<std::int64_t>(made_.results[t].turned.count));
    EXPECT_EQ(summary.refine, made_.results[t].refine);
  }
}

TEST_P(SummaryOf, ATileMeasuresItsEdges) {
  for (std::size_t t = 0; t < made_.of_tiles.size(); ++t) {
    const std::vector<double> lengths = metric_lengths(made_.mesh(t));
    const Moments expected(lengths);
    const SummedValues& edges = made_.of_tiles[t].edges;
    EXPECT_EQ(edges.count(), expected.count);
    EXPECT_NEAR(edges.moments.mean(), expected.mean(), 1e-12);
    EXPECT_NEAR(edges.moments.stddev(), expected.deviation, 1e-9);
    EXPECT_EQ(edges.min, expected.min);
    EXPECT_EQ(edges.max, expected.max);
    EXPECT_NEAR(
        edges.share(),
        share_of(lengths,
                 [](double length) { return length >= kShortestUnit && length <= kLongestUnit; }),
        1e-12);
  }
}

TEST_P(SummaryOf, ATileMeasuresLengthsInSpace) {
  for (std::size_t t = 0; t < made_.of_tiles.size(); ++t) {
    const PolyMesh& mesh = made_.mesh(t);
    std::vector<double> lengths;
    for (const EdgeHandle eh : mesh.edges()) lengths.push_back(mesh.calc_edge_length(eh));
    const Moments expected(lengths);
    const SummedValues& found = made_.of_tiles[t].lengths;
    EXPECT_EQ(found.count(), expected.count);
    EXPECT_NEAR(found.moments.mean(), expected.mean(), 1e-12);
    EXPECT_NEAR(found.moments.stddev(), expected.deviation, 1e-12);
    EXPECT_EQ(found.min, expected.min);
    EXPECT_EQ(found.max, expected.max);
  }
}

TEST_P(SummaryOf, ATileMeasuresItsTriangles) {
  for (std::size_t t = 0; t < made_.of_tiles.size(); ++t) {
    const std::vector<double> qualities = triangle_qualities(made_.mesh(t));
    const Moments expected(qualities);
    const SummedValues& found = made_.of_tiles[t].qualities;
    ASSERT_EQ(found.count(), expected.count);
    if (expected.count == 0) continue;
    EXPECT_NEAR(found.moments.mean(), expected.mean(), 1e-12);
    EXPECT_EQ(found.min, expected.min);
    EXPECT_NEAR(found.share(), share_of(qualities, [](double q) { return q < 0.3; }), 1e-12);
    expect_worst(made_.of_tiles[t].worst, qualities, made_.mesh(t));
  }
}

TEST_P(SummaryOf, ATileMeasuresItsQuads) {
  for (std::size_t t = 0; t < made_.of_tiles.size(); ++t) {
    const TileSummary& summary = made_.of_tiles[t];
    const PolyMesh& mesh = made_.mesh(t);
    if (summary.quads == 0) {
      EXPECT_EQ(summary.jacobians.count() + summary.space_jacobians.count(), 0u);
      continue;
    }
    const std::vector<double> in_metric = quad_jacobians(mesh), in_space = space_jacobians(mesh);
    const Moments metric(in_metric), space(in_space);
    EXPECT_EQ(summary.jacobians.count(), metric.count);
    EXPECT_NEAR(summary.jacobians.moments.mean(), metric.mean(), 1e-12);
    EXPECT_EQ(summary.jacobians.min, metric.min);
    EXPECT_NEAR(summary.jacobians.share(),
                share_of(in_metric, [](double value) { return value < kFlatQuad; }), 1e-12);
    EXPECT_EQ(summary.space_jacobians.count(), space.count);
    EXPECT_NEAR(summary.space_jacobians.moments.mean(), space.mean(), 1e-12);
    EXPECT_EQ(summary.space_jacobians.min, space.min);
    EXPECT_EQ(summary.inverted,
              std::count_if(in_metric.begin(), in_metric.end(), [](double j) { return j < 0; }));
    expect_worst(summary.worst_quad, in_metric, mesh);
    expect_worst(summary.worst_quad_in_space, in_space, mesh);
  }
}

/// Values of all tiles in one list.
template <class Measure>
std::vector<double> of_all(const Summaries& made, Measure measure) {
  std::vector<double> values;
  for (std::size_t t = 0; t < made.of_tiles.size(); ++t) {
    const std::vector<double> more = measure(made.mesh(t));
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

std::size_t count_of(const std::vector<HistogramBin>& bins) {
  std::size_t count = 0;
  for (const HistogramBin& bin : bins) count += bin.count;
  return count;
}

TEST_P(SummaryOf, AllTilesIsThatOfAllTheirElements) {
  const SummaryOfTiles all = sum_of(made_.of_tiles, meshed_.tiled.model.patches.size());
  const Moments edges(of_all(made_, metric_lengths));
  EXPECT_EQ(all.edges.count, edges.count);
  EXPECT_NEAR(all.edges.mean, edges.mean(), 1e-12);
  EXPECT_NEAR(all.edges.stddev, edges.deviation, 1e-9);
  EXPECT_EQ(all.edges.min, edges.min);
  EXPECT_EQ(all.edges.max, edges.max);
  EXPECT_EQ(count_of(all.edges.histogram), all.edges.count);
  const Moments qualities(of_all(made_, triangle_qualities));
  EXPECT_EQ(all.quality.count, qualities.count);
  EXPECT_EQ(count_of(all.quality.histogram), all.quality.count);
  if (qualities.count > 0) {
    EXPECT_NEAR(all.quality.mean, qualities.mean(), 1e-12);
    EXPECT_EQ(all.quality.min, qualities.min);
  }
  EXPECT_EQ(all.triangles, all.quality.count);
  EXPECT_EQ(all.quads, all.quad_statistics.count);
}

TEST_P(SummaryOf, AllTilesIsThatOfAllTheirQuads) {
  const SummaryOfTiles all = sum_of(made_.of_tiles, meshed_.tiled.model.patches.size());
  const QuadStatistics& quads = all.quad_statistics;
  EXPECT_EQ(GetParam().has_quads, all.quads > 0);
  EXPECT_EQ(count_of(quads.histogram), quads.count);
  if (all.quads == 0) return;
  const std::vector<double> in_metric = of_all(made_, quad_jacobians);
  const std::vector<double> in_space = of_all(made_, space_jacobians);
  EXPECT_NEAR(quads.mean_jacobian, Moments(in_metric).mean(), 1e-12);
  EXPECT_EQ(quads.min_jacobian, Moments(in_metric).min);
  EXPECT_NEAR(quads.mean_space_jacobian, Moments(in_space).mean(), 1e-12);
  EXPECT_EQ(quads.min_space_jacobian, Moments(in_space).min);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(quads.flat),
            std::count_if(in_metric.begin(), in_metric.end(),
                          [](double value) { return value < kFlatQuad; }));
  EXPECT_EQ(static_cast<std::ptrdiff_t>(quads.folded),
            std::count_if(in_space.begin(), in_space.end(), [](double j) { return j < 0; }));
  EXPECT_EQ(quads.fraction,
            static_cast<double>(all.quads) / static_cast<double>(all.quads + all.triangles));
}

TEST_P(SummaryOf, AllTilesKnowsTheWorstOfEachPatch) {
  const std::size_t patches = meshed_.tiled.model.patches.size();
  const SummaryOfTiles all = sum_of(made_.of_tiles, patches + 1);
  std::vector<double> least(patches + 1, std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < made_.of_tiles.size(); ++t) {
    double& of_patch = least[made_.results[t].mesh.patch()];
    of_patch = std::min(of_patch, Moments(triangle_qualities(made_.mesh(t))).min);
  }
  EXPECT_EQ(all.quality.min_of_patches, least);
  if (all.worst < 0) {
    EXPECT_EQ(all.triangles, 0u);
  } else {
    const TileSummary& worst = made_.of_tiles[static_cast<std::size_t>(all.worst)];
    EXPECT_EQ(worst.qualities.min, all.quality.min);
  }
}

/// In none of these cases tiles are made proper together.
TEST_P(SummaryOf, AllTilesHasTheFacesOfTheResult) {
  const PolyMesh result = meshed_.assembled();
  const SummaryOfTiles all = sum_of(made_.of_tiles, meshed_.tiled.model.patches.size());
  ASSERT_EQ(all.triangles + all.quads, result.n_faces());
  const QualityStatistics quality = measure_quality(result);
  EXPECT_EQ(all.quality.count, quality.count);
  EXPECT_NEAR(all.quality.min, quality.min, 1e-12);
  EXPECT_NEAR(all.quality.mean, quality.mean, 1e-12);
  double area = 0;
  for (const TileSummary& tile : made_.of_tiles) area += tile.area;
  EXPECT_NEAR(area, area_of(result), 1e-9 * area);
  if (all.quads == 0) return;
  const QuadStatistics quads = measure_quads(result);
  EXPECT_NEAR(all.quad_statistics.min_jacobian, quads.min_jacobian, 1e-12);
  EXPECT_NEAR(all.quad_statistics.min_space_jacobian, quads.min_space_jacobian, 1e-12);
}

/// The measures of a mesh, but for the places of faces.
void expect_same(const EdgeStatistics& a, const EdgeStatistics& b) {
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_DOUBLE_EQ(a.stddev, b.stddev);
  EXPECT_EQ(a.unit_fraction, b.unit_fraction);
  EXPECT_EQ(a.histogram, b.histogram);
}

TEST_P(SummaryOf, OneTileIsWhatItsMeshMeasures) {
  for (std::size_t t = 0; t < std::min<std::size_t>(3, made_.of_tiles.size()); ++t) {
    const PolyMesh& mesh = made_.mesh(t);
    const SummaryOfTiles one = sum_of({&made_.of_tiles[t], 1}, meshed_.tiled.model.patches.size());
    expect_same(one.edges, measure_edges(mesh));
    const QualityStatistics quality = measure_quality(mesh);
    EXPECT_EQ(one.quality.count, quality.count);
    EXPECT_EQ(one.quality.mean, quality.mean);
    EXPECT_EQ(one.quality.below_0_3, quality.below_0_3);
    EXPECT_EQ(one.quality.histogram, quality.histogram);
    if (one.quads == 0) continue;
    const QuadStatistics quads = measure_quads(mesh);
    EXPECT_EQ(one.quad_statistics.mean_jacobian, quads.mean_jacobian);
    EXPECT_EQ(one.quad_statistics.inverted, quads.inverted);
    EXPECT_DOUBLE_EQ(one.quad_statistics.irregular_share, quads.irregular_share);
    EXPECT_EQ(one.quad_statistics.fraction, quads.fraction);
    EXPECT_EQ(one.quad_statistics.histogram, quads.histogram);
  }
}

INSTANTIATE_TEST_SUITE_P(Tiles, SummaryOf, ::testing::ValuesIn(testing::tiled_cases()),
                         [](const auto& test) { return test.param.name; });

// --- sums of tiles ---

TEST(SumOf, NoTilesIsNothing) {
  const SummaryOfTiles all = sum_of({}, 2);
  EXPECT_EQ(all.triangles + all.quads, 0u);
  EXPECT_EQ(all.worst, -1);
  EXPECT_EQ(all.worst_quad, -1);
  EXPECT_EQ(all.quality.min_of_patches,
            std::vector<double>(2, std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(all.quality.histogram.empty());
}

TEST(SumOf, QuadsAndTrianglesTellsTheShareOfQuads) {
  TileSummary triangles, quads;
  triangles.triangles = 30;
  quads.quads = 90;
  quads.patch = 1;
  quads.jacobians = sums_of({0.5, 0.25});
  quads.irregular_share = 0.1;
  quads.inverted = 2;
  const SummaryOfTiles all = sum_of(std::vector{triangles, quads, quads}, 2);
  EXPECT_EQ(all.quads, 180u);
  EXPECT_DOUBLE_EQ(all.quad_statistics.fraction, 180.0 / 210);
  EXPECT_DOUBLE_EQ(all.quad_statistics.irregular_share, 0.1);
  EXPECT_EQ(all.quad_statistics.inverted, 4u);
  EXPECT_EQ(all.quad_statistics.min_of_patches[1], 0.25);
  EXPECT_TRUE(std::isinf(all.quad_statistics.min_of_patches[0]));
  EXPECT_EQ(all.worst_quad, 1);
}

TEST(SumOf, TilesNamesTheFirstOfTheWorst) {
  std::vector<TileSummary> tiles(4);
  tiles[0].qualities = sums_of({0.9});
  tiles[1].qualities = sums_of({0.4, 0.8});
  tiles[2].qualities = sums_of({0.4});
  EXPECT_EQ(sum_of(tiles, 1).worst, 1);
}

}  // namespace
}  // namespace surfmesh
