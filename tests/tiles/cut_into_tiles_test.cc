// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/tiles/cut_into_tiles.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "support/domain_meshes.hh"
#include "support/tiled_model.hh"
#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/boundary/segment_shape.hh"
#include "surfmesh/geometry/crossing_segments.hh"
#include "surfmesh/refine/boundary_triangulation.hh"

namespace surfmesh {
namespace {

using testing::area_of;
using testing::FieldOn;
using testing::sizes_of;
using testing::TiledModel;
using testing::unit_triangles;

struct Case {
  std::string name;
  testing::MakeModel model;
  FieldOn sizes;
  double most = 300;
  int multiple = 1;
  double least_share = 0.4;  ///< of the triangles asked for, that tiles have
};

void PrintTo(const Case& a, std::ostream* out) { *out << a.name; }

Model thin_strip() { return testing::model_of({testing::rectangle(0, 0, 20, 0.08)}); }

/// Sizes along and across a direction.
FieldOn directed(Uv along, double size_along, double size_across) {
  return sizes_of(
      testing::constant_field(testing::directed_metric(along, size_along, size_across)));
}

std::vector<Case> cases() {
  std::vector<Case> all = {
      {"Square", testing::unit_square, sizes_of(0.03)},
      {"SquareOfGradedSizes", testing::unit_square, sizes_of(testing::four_point_field()), 500},
      {"SquareOfStretchedSizes", testing::unit_square, directed({1, 0}, 0.15, 0.005)},
      {"SquareOfObliqueSizes", testing::unit_square, directed({0.8, 0.6}, 0.03, 0.012)},
      // Halves are less even beside the shock.
      {"SquareWithAShock", testing::unit_square, sizes_of(testing::shock_field(30, 0.04)), 200, 1,
       0.25},
      {"SquareWithALayer", testing::unit_square, sizes_of(testing::ring_field(0.001)), 500},
      {"SquareWithAHole", [] { return testing::square_with_hole(0.4); }, sizes_of(0.06)},
      {"SquareWithTouchingHoles", testing::square_with_touching_holes, sizes_of(0.06)},
      {"NarrowRing", [] { return testing::narrow_ring(0.9); }, sizes_of(0.025)},
      {"ThinStrip", thin_strip, sizes_of(0.02)},
      {"Sphere", [] { return testing::sphere_of(1); }, sizes_of(0.1)},
      {"SphereOfThree", [] { return testing::sphere_of(3); }, sizes_of(0.06)},
      {"Torus", [] { return testing::torus_of(1); }, sizes_of(0.2)},
      {"Cone", [] { return testing::cone_of(1); }, sizes_of(0.06)},
      {"MobiusBand", testing::mobius_band, sizes_of(0.05)},
      {"Cylinder", [] { return testing::cylinder_of(1); }, sizes_of(0.1)},
  };
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) {
    Case quads = all[i];
    quads.name += "ForQuads";
    quads.multiple = 2;
    all.push_back(quads);
  }
  return all;
}

/// A segment of a loop, by the places of its ends.
using Ends = std::array<double, 4>;

struct Segment {
  int from = -1, to = -1;  ///< vertices
  int contour = -1;

  auto operator<=>(const Segment&) const = default;
};

using Segments = std::multimap<Ends, Segment>;

Segments segments_of(const PatchBoundary& boundary) {
  Segments segments;
  for (const BoundaryLoop& loop : boundary.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BoundaryNode &a = loop[i], &b = loop[(i + 1) % loop.size()];
      segments.insert({{a.uv.u, a.uv.v, b.uv.u, b.uv.v}, {a.vertex, b.vertex, a.contour}});
    }
  }
  return segments;
}

Segments segments_of(const std::vector<Tile>& tiles) {
  Segments segments;
  for (const Tile& tile : tiles) segments.merge(segments_of(tile.boundary));
  return segments;
}

std::size_t node_count(const PatchBoundary& boundary) {
  std::size_t count = 0;
  for (const BoundaryLoop& loop : boundary.loops) count += loop.size();
  return count;
}

std::vector<BoundaryNode> all_nodes(const PatchBoundary& boundary) {
  std::vector<BoundaryNode> nodes;
  for (const BoundaryLoop& loop : boundary.loops) {
    nodes.insert(nodes.end(), loop.begin(), loop.end());
  }
  return nodes;
}

std::vector<std::vector<Uv>> places_of(const PatchBoundary& boundary) {
  std::vector<std::vector<Uv>> loops;
  for (const BoundaryLoop& loop : boundary.loops) {
    for (std::vector<Uv>& places = loops.emplace_back(); const BoundaryNode& node : loop) {
      places.push_back(node.uv);
    }
  }
  return loops;
}

const PoleFan& fan_at(const PatchBoundary& boundary, int pole) {
  return *std::find_if(boundary.fans.begin(), boundary.fans.end(),
                       [pole](const PoleFan& fan) { return fan.pole == pole; });
}

/// Equal in all that a boundary has.
void expect_same(const PatchBoundary& a, const PatchBoundary& b) {
  EXPECT_EQ(a.patch, b.patch);
  EXPECT_EQ(segments_of(a), segments_of(b));
  EXPECT_EQ(places_of(a), places_of(b));
  ASSERT_EQ(a.fans.size(), b.fans.size());
  for (std::size_t f = 0; f < a.fans.size(); ++f) {
    EXPECT_EQ(a.fans[f].pole, b.fans[f].pole);
    EXPECT_EQ(a.fans[f].ring, b.fans[f].ring);
    EXPECT_EQ(a.fans[f].last_share, b.fans[f].last_share);
  }
}

/// The first patch of a model, cut into tiles.
class TilesOf : public ::testing::TestWithParam<Case> {
 protected:
  TilesOf()
      : tiled_(GetParam().model(), GetParam().sizes,
               {.most = GetParam().most, .multiple = GetParam().multiple}) {}

  const PatchBoundary& whole() const { return tiled_.whole[0]; }
  const Tiles& result() const { return tiled_.of_patches[0]; }
  const std::vector<Tile>& tiles() const { return result().tiles; }
  const MetricField& field() const { return tiled_.fields[0]; }
  int first_vertex() const { return tiled_.first_vertex[0]; }

  /// Call `visit(a, b)` for the segments of cuts, in both directions.
  template <class Visit>
  void for_each_cut_segment(Visit visit) const {
    const Segments of_whole = segments_of(whole());
    for (const auto& [ends, segment] : segments_of(tiles())) {
      if (!of_whole.contains(ends)) visit(Uv{ends[0], ends[1]}, Uv{ends[2], ends[3]});
    }
  }

  TiledModel tiled_;
};

TEST_P(TilesOf, AreAboutAsManyAsAsked) {
  const double wanted = std::ceil(tiled_.triangles[0] / GetParam().most);
  EXPECT_GE(wanted, 3);
  EXPECT_EQ(result().refused, 0u);
  EXPECT_NEAR(static_cast<double>(tiles().size()), wanted, 0.25 * wanted);
}

TEST_P(TilesOf, FillThePatch) {
  double area = 0;
  for (const Tile& tile : tiles()) {
    EXPECT_EQ(tile.boundary.patch, whole().patch);
    EXPECT_GT(area_of(tile.boundary), 0);
    area += area_of(tile.boundary);
  }
  EXPECT_NEAR(area, area_of(whole()), 1e-12 * area);
}

TEST_P(TilesOf, HaveEachSegmentOfThePatchOnce) {
  const Segments of_tiles = segments_of(tiles());
  for (const auto& [ends, segment] : segments_of(whole())) {
    ASSERT_EQ(of_tiles.count(ends), 1u);
    const Segment& in_tile = of_tiles.find(ends)->second;
    EXPECT_EQ(in_tile.contour, segment.contour);
    for (const auto end : {&Segment::from, &Segment::to}) {
      if (segment.*end >= 0) {
        EXPECT_EQ(in_tile.*end, segment.*end);
      } else {
        EXPECT_GE(in_tile.*end, first_vertex());  // of a ring
      }
    }
  }
}

TEST_P(TilesOf, HaveEachSegmentOfACutInBothDirections) {
  const Segments of_whole = segments_of(whole()), of_tiles = segments_of(tiles());
  std::size_t on_cuts = 0;
  for (const auto& [ends, segment] : of_tiles) {
    if (of_whole.contains(ends)) continue;
    ++on_cuts;
    EXPECT_EQ(segment.contour, -1);
    ASSERT_EQ(of_tiles.count(ends), 1u);
    const auto back = of_tiles.find(Ends{ends[2], ends[3], ends[0], ends[1]});
    ASSERT_NE(back, of_tiles.end());
    EXPECT_EQ(back->second, (Segment{segment.to, segment.from, -1}));
  }
  EXPECT_GE(on_cuts, 2 * 3u);
}

TEST_P(TilesOf, NumberTheNodesTheyShareWithoutGaps) {
  std::map<int, std::set<std::pair<double, double>>> places;
  for (const Tile& tile : tiles()) {
    for (const BoundaryNode& node : all_nodes(tile.boundary)) {
      EXPECT_GE(node.vertex, 0);
      if (node.vertex >= first_vertex()) places[node.vertex].insert({node.uv.u, node.uv.v});
    }
  }
  ASSERT_EQ(places.size(), static_cast<std::size_t>(result().shared_nodes));
  ASSERT_FALSE(places.empty());
  EXPECT_EQ(places.begin()->first, first_vertex());
  EXPECT_EQ(places.rbegin()->first, first_vertex() + result().shared_nodes - 1);
  for (const auto& [vertex, of_vertex] : places) EXPECT_EQ(of_vertex.size(), 1u) << vertex;
}

TEST_P(TilesOf, HaveLoopsThatDoNotCross) {
  for (const Tile& tile : tiles()) {
    EXPECT_TRUE(detail::crossing_segments(places_of(tile.boundary)).empty());
  }
}

TEST_P(TilesOf, CanBeTriangulated) {
  for (const Tile& tile : tiles()) {
    const BoundaryTriangulation made = triangulate_boundary(places_of(tile.boundary), field());
    const double area = area_of(tile.boundary);
    EXPECT_NEAR(testing::valid_area(*made.delaunay), area, 1e-12 * area);
  }
}

TEST_P(TilesOf, HaveNodesOnCutsAboutAUnitApart) {
  // Three segments at least on 2.5 units, and for quads one more or less than the nearest number.
  const double least = GetParam().multiple == 2 ? 2.5 / 4 : 2.5 / 3;
  const double greatest = GetParam().multiple == 2 ? 4.0 / 3 : 3.5 / 3;
  constexpr double kError = 0.02;  // of the table of arcs
  for_each_cut_segment([&](Uv a, Uv b) {
    const double length = MetricArc(SegmentCurve(a, b), field()).length();
    EXPECT_GE(length, least - kError);
    EXPECT_LE(length, greatest + kError);
  });
}

TEST_P(TilesOf, HaveAMultipleOfNodesAroundEach) {
  const auto multiple = static_cast<std::size_t>(GetParam().multiple);
  ASSERT_EQ(node_count(whole()) % multiple, 0u);
  for (const Tile& tile : tiles()) EXPECT_EQ(node_count(tile.boundary) % multiple, 0u);
}

TEST_P(TilesOf, ShareTheTrianglesOut) {
  double sum = 0;
  for (const Tile& tile : tiles()) sum += tile.triangles;
  EXPECT_NEAR(sum, tiled_.triangles[0], 1e-9 * sum);
}

TEST_P(TilesOf, PredictTheirTriangles) {
  for (const Tile& tile : tiles()) {
    const double expected = unit_triangles(tile.boundary, field());
    EXPECT_NEAR(tile.triangles, expected, 0.1 * expected);
  }
}

TEST_P(TilesOf, AreOfAboutTheSizeAskedFor) {
  const double wanted = tiled_.triangles[0] / std::ceil(tiled_.triangles[0] / GetParam().most);
  for (const Tile& tile : tiles()) {
    EXPECT_GE(tile.triangles, GetParam().least_share * wanted);
    EXPECT_LE(tile.triangles, 1.6 * wanted);
  }
}

TEST_P(TilesOf, DivideTheFansAmongThem) {
  std::map<int, std::vector<std::pair<double, double>>> shares;  // by pole
  std::map<int, std::size_t> segments;
  for (const Tile& tile : tiles()) {
    const std::vector<BoundaryNode> nodes = all_nodes(tile.boundary);
    for (const PoleFan& fan : tile.boundary.fans) {
      shares[fan.pole].push_back({fan.first_share, fan.last_share});
      segments[fan.pole] += fan.ring.size() - 1;
      const PoleFan& of_whole = fan_at(whole(), fan.pole);
      EXPECT_EQ(fan.contour_to, fan.first_share == 0 ? of_whole.contour_to : -1);
      EXPECT_EQ(fan.contour_from, fan.last_share == 1 ? of_whole.contour_from : -1);
      EXPECT_EQ(fan.segments_per_face, GetParam().multiple);
      EXPECT_EQ((fan.ring.size() - 1) % static_cast<std::size_t>(fan.segments_per_face), 0u);
      for (std::size_t k = 0; k + 1 < fan.ring.size(); ++k) {
        EXPECT_EQ(nodes[static_cast<std::size_t>(fan.ring[k])].contour, -1);
      }
    }
  }
  EXPECT_EQ(shares.size(), whole().fans.size());
  for (const PoleFan& fan : whole().fans) {
    EXPECT_EQ(segments[fan.pole], fan.ring.size() - 1);
    std::vector<std::pair<double, double>>& of_pole = shares[fan.pole];
    std::sort(of_pole.begin(), of_pole.end());
    EXPECT_EQ(of_pole.front().first, 0);
    EXPECT_EQ(of_pole.back().second, 1);
    for (std::size_t i = 0; i + 1 < of_pole.size(); ++i) {
      EXPECT_EQ(of_pole[i].second, of_pole[i + 1].first);
    }
  }
}

TEST_P(TilesOf, KeepTheRingsOfFansInOrder) {
  for (const Tile& tile : tiles()) {
    const std::vector<BoundaryNode> nodes = all_nodes(tile.boundary);
    const Segments of_whole = segments_of(whole());
    for (const PoleFan& fan : tile.boundary.fans) {
      for (std::size_t k = 0; k + 1 < fan.ring.size(); ++k) {
        const Uv a = nodes[static_cast<std::size_t>(fan.ring[k])].uv;
        const Uv b = nodes[static_cast<std::size_t>(fan.ring[k + 1])].uv;
        EXPECT_TRUE(of_whole.contains(Ends{a.u, a.v, b.u, b.v}));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Patches, TilesOf, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

// --- patches that stay whole ---

void expect_whole(const TiledModel& tiled, std::size_t refused) {
  const Tiles& result = tiled.of_patches[0];
  ASSERT_EQ(result.tiles.size(), 1u);
  expect_same(result.tiles[0].boundary, tiled.whole[0]);
  EXPECT_EQ(result.tiles[0].triangles, tiled.triangles[0]);
  EXPECT_TRUE(result.tiles[0].required_points.empty());
  EXPECT_EQ(result.shared_nodes, 0);
  EXPECT_EQ(result.refused, refused);
}

TEST(CutIntoTiles, LeavesASmallPatchWhole) {
  for (const Model& model :
       {testing::unit_square(), testing::square_with_hole(0.4), testing::sphere_of(1)}) {
    const TiledModel tiled(model, sizes_of(0.3), {.most = 10'000});
    expect_whole(tiled, 0);
    EXPECT_EQ(tiled.of_patches[0].queries.total(), 0u);
  }
}

TEST(CutIntoTiles, LeavesAPatchWholeIfItIsOff) {
  const TiledModel tiled(testing::sphere_of(1), sizes_of(0.1), {.most = 0});
  EXPECT_GT(tiled.triangles[0], 1000);
  expect_whole(tiled, 0);
}

TEST(CutIntoTiles, TellsOfAPatchThatNoLineCuts) {
  // One unit wide: cuts would be too short.
  const Model model = testing::model_of({testing::rectangle(0, 0, 10, 0.02)});
  const TiledModel tiled(model, sizes_of(0.02), {.most = 100});
  EXPECT_GT(tiled.triangles[0], 1000);
  expect_whole(tiled, 1);
}

TEST(CutIntoTiles, TellsOfAPatchThatIsObliqueToItsMetric) {
  // All lines meet the sides under 4° in the metric.
  const TiledModel tiled(testing::unit_square(), directed({0.8, 0.6}, 0.15, 0.005), {.most = 300});
  EXPECT_GT(tiled.triangles[0], 1000);
  expect_whole(tiled, 1);
}

TEST(CutIntoTiles, LeavesAPatchWholeWhereTheMetricIsNotFinite) {
  TiledModel tiled(testing::unit_square(), sizes_of(0.05), {.most = 0});
  const testing::FunctionField nowhere([](Uv) { return Metric{kUnset, kUnset, kUnset}; });
  const TileTask task{
      .surface = tiled.model.surface(0), .field = nowhere, .triangles = 1000, .most = 100};
  const Tiles result = cut_into_tiles(tiled.whole[0], task, 1000);
  ASSERT_EQ(result.tiles.size(), 1u);
  expect_same(result.tiles[0].boundary, tiled.whole[0]);
  EXPECT_EQ(result.refused, 1u);
}

// --- others ---

TEST(CutIntoTiles, CutsAcrossTheLongerDirectionInTheMetric) {
  // Twice as long in v, but of four times the size there.
  const Model model = testing::model_of({testing::rectangle(0, 0, 1, 2)});
  const testing::FunctionField field = testing::constant_field({400, 0, 25});
  const TiledModel tiled(model, sizes_of(field), {.most = 300});
  ASSERT_EQ(tiled.of_patches[0].tiles.size(), 2u);
  for (const Tile& tile : tiled.of_patches[0].tiles) {
    for (const BoundaryNode& node : all_nodes(tile.boundary)) {
      if (node.vertex < tiled.first_vertex[0]) continue;
      EXPECT_NEAR(node.uv.u, 0.5, 1e-9);
    }
  }
}

TEST(CutIntoTiles, CountsItsQueries) {
  const TiledModel tiled(testing::square_with_hole(0.4), sizes_of(0.06), {.most = 0});
  const testing::FunctionField field = testing::isotropic_field(0.06);
  const TileTask task{.surface = tiled.model.surface(0),
                      .field = field,
                      .triangles = tiled.triangles[0],
                      .most = 300};
  const std::size_t counted = cut_into_tiles(tiled.whole[0], task, 1000).queries.total();
  EXPECT_EQ(counted, field.queries());
  EXPECT_GT(counted, 0u);
}

TEST(CutIntoTiles, HoldsTheSagOnCuts) {
  for (const double sag : {0.05, 0.02}) {
    const TiledModel tiled(testing::sphere_of(1), sizes_of(0.4), {.most = 50, .sag = sag});
    ASSERT_GT(tiled.of_patches[0].tiles.size(), 2u);
    const Segments of_whole = segments_of(tiled.whole[0]);
    double greatest = 0;
    for (const auto& [ends, segment] : segments_of(tiled.of_patches[0].tiles)) {
      if (of_whole.contains(ends)) continue;
      const SegmentCurve line({ends[0], ends[1]}, {ends[2], ends[3]});
      greatest = std::max(greatest, segment_sag(tiled.model.surface(0), line, 0, 1));
    }
    EXPECT_LE(greatest, sag);
    EXPECT_GT(greatest, 0.2 * sag);
  }
}

/// One size, and points to be resolved.
class FieldWithPoints : public MetricField {
 public:
  FieldWithPoints(double size, const std::vector<Uv>& places)
      : metric_(testing::isotropic_metric(size)) {
    for (const Uv uv : places) points_.push_back({uv, metric_});
  }

  Metric at(Uv, QueryHint&) const override { return metric_; }
  std::span<const MetricCorner> required_points() const override { return points_; }

 private:
  Metric metric_;
  std::vector<MetricCorner> points_;
};

TEST(CutIntoTiles, HandsRequiredPointsToTheTilesInWhichTheyLie) {
  const TiledModel tiled(testing::square_with_hole(0.4), sizes_of(0.06), {.most = 0});
  std::vector<Uv> places;
  for (int i = 0; i < 400; ++i) places.push_back({-0.97 + 0.1 * (i % 20), -0.97 + 0.1 * (i / 20)});
  const FieldWithPoints field(0.06, places);
  const TileTask task{.surface = tiled.model.surface(0),
                      .field = field,
                      .triangles = tiled.triangles[0],
                      .most = 200};
  const Tiles result = cut_into_tiles(tiled.whole[0], task, 1000);
  ASSERT_GT(result.tiles.size(), 8u);
  std::size_t inside = 0, handed = 0;
  for (const Tile& tile : result.tiles) {
    const auto& points = tile.required_points;
    handed += points.size();
    for (const Uv place : places) {
      if (!testing::is_inside(tile.boundary.loops, place)) continue;
      ++inside;
      EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                              [&](const MetricCorner& point) { return point.uv == place; }));
    }
  }
  EXPECT_EQ(inside,
            static_cast<std::size_t>(std::count_if(places.begin(), places.end(), [&](Uv uv) {
              return testing::is_inside(tiled.whole[0].loops, uv);
            })));
  // Slanted cuts and the hole leave some to a tile that does not have them, but no more.
  EXPECT_LT(handed, 2 * places.size());
}

TEST(ShiftSharedNodes, AddsToTheirNumbersAlone) {
  const TiledModel tiled(testing::sphere_of(1), sizes_of(0.1), {.most = 300});
  const int first = tiled.first_vertex[0];
  for (const Tile& tile : tiled.of_patches[0].tiles) {
    PatchBoundary shifted = tile.boundary;
    shift_shared_nodes(shifted, first, 1000);
    const auto before = all_nodes(tile.boundary), after = all_nodes(shifted);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(after[i].vertex, before[i].vertex + (before[i].vertex >= first ? 1000 : 0));
      EXPECT_EQ(after[i].uv, before[i].uv);
      EXPECT_EQ(after[i].contour, before[i].contour);
    }
  }
}

}  // namespace
}  // namespace surfmesh
