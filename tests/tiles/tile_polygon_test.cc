// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/tiles/tile_polygon.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "support/tiled_model.hh"
#include "tiles/flat_polygons.hh"

namespace surfmesh::detail {
namespace {

using testing::area_of;
using testing::FlatPolygon;

/// The square [0,4]² with a square hole [1,3]² and its sides cut in two.
FlatPolygon frame() {
  return {{{{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}},
           {{1, 1}, {1, 2}, {1, 3}, {2, 3}, {3, 3}, {3, 2}, {3, 1}, {2, 1}}}};
}

/// The side that begins at a point.
SidePlace side_at(const FlatPolygon& polygon, Uv uv) {
  SidePlace found;
  int count = 0;
  for_each_side(polygon.sides, [&](SidePlace place) {
    if (polygon.nodes[static_cast<std::size_t>(at(polygon.sides, place).node)].uv != uv) return;
    found = place;
    ++count;
  });
  EXPECT_EQ(count, 1) << uv.u << ' ' << uv.v;
  return found;
}

TileCut cut_between(const FlatPolygon& polygon, Uv from, Uv to, std::vector<int> inner = {}) {
  return {side_at(polygon, from), side_at(polygon, to), std::move(inner)};
}

std::vector<double> alongs(const std::vector<LineCrossing>& crossings) {
  std::vector<double> values;
  for (const LineCrossing& crossing : crossings) values.push_back(crossing.along);
  return values;
}

// --- places ---

TEST(SidePlace, IsFollowedByTheNextOfItsLoop) {
  const FlatPolygon polygon = frame();
  EXPECT_EQ(next(polygon.sides, {1, 3}), (SidePlace{1, 4}));
  EXPECT_EQ(next(polygon.sides, {1, 7}), (SidePlace{1, 0}));
  EXPECT_EQ(previous(polygon.sides, {0, 3}), (SidePlace{0, 2}));
  EXPECT_EQ(previous(polygon.sides, {0, 0}), (SidePlace{0, 7}));
}

TEST(SidePlace, IsVisitedOnceForEachSide) {
  const FlatPolygon polygon = frame();
  std::vector<int> nodes;
  for_each_side(polygon.sides,
                [&](SidePlace place) { nodes.push_back(at(polygon.sides, place).node); });
  std::vector<int> expected(16);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(nodes, expected);
  EXPECT_EQ(polygon.sides.side_count(), 16u);
}

TEST(UvBox, HoldsAllNodes) {
  const FlatPolygon polygon = frame();
  const UvBox box = box_of(polygon.sides, polygon.nodes);
  EXPECT_EQ(box.lower, (Uv{0, 0}));
  EXPECT_EQ(box.upper, (Uv{4, 4}));
  EXPECT_TRUE(box.contains({4, 0}));
  EXPECT_FALSE(box.contains({4.1, 0}));
  EXPECT_FALSE(box.contains({1, -0.1}));
}

// --- crossings ---

TEST(Crossings, ComeInOrderAlongTheLine) {
  const FlatPolygon polygon = frame();
  EXPECT_EQ(alongs(crossings(polygon.sides, polygon.nodes, 0, 2.5)),
            (std::vector<double>{0, 1, 3, 4}));
  EXPECT_EQ(alongs(crossings(polygon.sides, polygon.nodes, 1, 0.5)), (std::vector<double>{0, 4}));
}

TEST(Crossings, TellTheSideAndThePlaceOnIt) {
  const FlatPolygon polygon = frame();
  const auto found = crossings(polygon.sides, polygon.nodes, 0, 2.5);
  ASSERT_EQ(found.size(), 4u);
  const Uv starts[] = {{2, 0}, {3, 1}, {2, 3}, {4, 4}};
  const double shares[] = {0.25, 0.5, 0.5, 0.75};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].side, side_at(polygon, starts[i]));
    EXPECT_DOUBLE_EQ(found[i].share, shares[i]);
  }
}

TEST(Crossings, AreEvenWhereTheLineMeetsNodes) {
  const FlatPolygon polygon = frame();
  for (const int axis : {0, 1}) {
    for (const double value : {0.0, 1.0, 2.0, 3.0, 4.0}) {
      const auto found = crossings(polygon.sides, polygon.nodes, axis, value);
      EXPECT_EQ(found.size() % 2, 0u) << value;
      for (const LineCrossing& crossing : found) {
        EXPECT_GE(crossing.share, 0);
        EXPECT_LE(crossing.share, 1);
      }
    }
  }
}

TEST(Crossings, AreNoneOutside) {
  const FlatPolygon polygon = frame();
  EXPECT_TRUE(crossings(polygon.sides, polygon.nodes, 0, -0.1).empty());
  EXPECT_TRUE(crossings(polygon.sides, polygon.nodes, 1, 4.1).empty());
}

// --- divide ---

TEST(Divide, GivesBothSidesOfACut) {
  FlatPolygon polygon{{{0, 0}, {1, 0}, {3, 0}, {3, 2}, {1, 2}, {0, 2}}};
  polygon.nodes.push_back({{1, 1}});
  const CutPolygons divided =
      divide(polygon.sides, polygon.nodes, {cut_between(polygon, {1, 0}, {1, 2}, {6})});
  ASSERT_EQ(divided.parts.size(), 2u);
  ASSERT_EQ(divided.beside.size(), 1u);
  const auto [left, right] = divided.beside[0];
  EXPECT_DOUBLE_EQ(area_of(divided.parts[left], polygon.nodes), 2);
  EXPECT_DOUBLE_EQ(area_of(divided.parts[right], polygon.nodes), 4);
  for (const TilePolygon& part : divided.parts) {
    EXPECT_EQ(part.loops.size(), 1u);
    EXPECT_EQ(part.side_count(), 5u);
  }
}

TEST(Divide, KeepsTheSidesAndGivesCutsNoContour) {
  FlatPolygon polygon{{{0, 0}, {1, 0}, {3, 0}, {3, 2}, {1, 2}, {0, 2}}};
  polygon.nodes.push_back({{1, 1}});
  const CutPolygons divided =
      divide(polygon.sides, polygon.nodes, {cut_between(polygon, {1, 0}, {1, 2}, {6})});
  std::vector<int> on_contour, on_cut;
  for (const TilePolygon& part : divided.parts) {
    for_each_side(part, [&](SidePlace place) {
      (at(part, place).contour >= 0 ? on_contour : on_cut).push_back(at(part, place).node);
    });
  }
  std::sort(on_contour.begin(), on_contour.end());
  std::sort(on_cut.begin(), on_cut.end());
  EXPECT_EQ(on_contour, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(on_cut, (std::vector<int>{1, 4, 6, 6}));
}

TEST(Divide, TakesAHoleIntoTheOuterLoops) {
  const FlatPolygon polygon = frame();
  const CutPolygons divided =
      divide(polygon.sides, polygon.nodes,
             {cut_between(polygon, {2, 0}, {2, 1}), cut_between(polygon, {2, 3}, {2, 4})});
  ASSERT_EQ(divided.parts.size(), 2u);
  for (const TilePolygon& part : divided.parts) {
    EXPECT_EQ(part.loops.size(), 1u);
    EXPECT_DOUBLE_EQ(area_of(part, polygon.nodes), 6);
  }
  EXPECT_EQ(divided.beside[0], divided.beside[1]);
}

TEST(Divide, LeavesOnePartWhereACutOnlyReachesAHole) {
  const FlatPolygon polygon = frame();
  const CutPolygons divided =
      divide(polygon.sides, polygon.nodes, {cut_between(polygon, {2, 0}, {2, 1})});
  ASSERT_EQ(divided.parts.size(), 1u);
  EXPECT_EQ(divided.parts[0].loops.size(), 1u);
  EXPECT_EQ(divided.beside[0], (std::pair<std::size_t, std::size_t>{0, 0}));
  EXPECT_DOUBLE_EQ(area_of(divided.parts[0], polygon.nodes), 12);
}

TEST(Divide, GivesHolesToThePartAroundThem) {
  const std::vector<Uv> outer = {{0, 0}, {5, 0}, {10, 0}, {10, 4}, {5, 4}, {0, 4}};
  const std::vector<Uv> left = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  const std::vector<Uv> right = {{7, 1}, {7, 3}, {9, 3}, {9, 1}};
  const std::vector<Uv> upper_left = {{3, 2}, {3, 3}, {4, 3}};
  const FlatPolygon polygon{std::vector<std::vector<Uv>>{outer, left, right, upper_left}};
  const CutPolygons divided =
      divide(polygon.sides, polygon.nodes, {cut_between(polygon, {5, 0}, {5, 4})});
  ASSERT_EQ(divided.parts.size(), 2u);
  const auto [on_left, on_right] = divided.beside[0];
  EXPECT_EQ(divided.parts[on_left].loops.size(), 3u);
  EXPECT_EQ(divided.parts[on_right].loops.size(), 2u);
  EXPECT_DOUBLE_EQ(area_of(divided.parts[on_left], polygon.nodes), 20 - 1 - 0.5);
  EXPECT_DOUBLE_EQ(area_of(divided.parts[on_right], polygon.nodes), 20 - 4);
}

TEST(Divide, MakesThreePartsOfAForkedOne) {
  // A U, cut through both of its arms.
  const FlatPolygon polygon{{{0, 0},
                             {6, 0},
                             {6, 3},
                             {6, 5},
                             {4, 5},
                             {4, 3},
                             {4, 2},
                             {2, 2},
                             {2, 3},
                             {2, 5},
                             {0, 5},
                             {0, 3}}};
  const CutPolygons divided =
      divide(polygon.sides, polygon.nodes,
             {cut_between(polygon, {0, 3}, {2, 3}), cut_between(polygon, {4, 3}, {6, 3})});
  ASSERT_EQ(divided.parts.size(), 3u);
  std::vector<double> areas;
  for (const TilePolygon& part : divided.parts) areas.push_back(area_of(part, polygon.nodes));
  std::sort(areas.begin(), areas.end());
  EXPECT_EQ(areas, (std::vector<double>{4, 4, 16}));
  // The bottom is on the right of both cuts.
  EXPECT_EQ(divided.beside[0].second, divided.beside[1].second);
  EXPECT_NE(divided.beside[0].first, divided.beside[1].first);
}

// --- boundaries ---

/// Equal in all that a boundary has.
void expect_same(const PatchBoundary& a, const PatchBoundary& b) {
  EXPECT_EQ(a.patch, b.patch);
  ASSERT_EQ(a.loops.size(), b.loops.size());
  for (std::size_t l = 0; l < a.loops.size(); ++l) {
    ASSERT_EQ(a.loops[l].size(), b.loops[l].size());
    for (std::size_t i = 0; i < a.loops[l].size(); ++i) {
      EXPECT_EQ(a.loops[l][i].uv, b.loops[l][i].uv);
      EXPECT_EQ(a.loops[l][i].vertex, b.loops[l][i].vertex);
      EXPECT_EQ(a.loops[l][i].contour, b.loops[l][i].contour);
    }
  }
  ASSERT_EQ(a.fans.size(), b.fans.size());
}

TEST(BoundaryOf, APolygonIsThatItWasMadeOf) {
  for (const Model& model : {testing::unit_square(), testing::square_with_hole(0.4),
                             testing::torus_of(1), testing::square_with_touching_holes()}) {
    const testing::TiledModel tiled(model, testing::sizes_of(0.2), {});
    std::vector<TileNode> nodes;
    const TilePolygon polygon = polygon_of(tiled.whole[0], nodes);
    expect_same(boundary_of(polygon, nodes, tiled.whole[0]), tiled.whole[0]);
  }
}

/// The nodes of the ring of a fan.
std::vector<Uv> ring_of(const PatchBoundary& boundary, const PoleFan& fan) {
  std::vector<Uv> all, ring;
  for (const BoundaryLoop& loop : boundary.loops) {
    for (const BoundaryNode& node : loop) all.push_back(node.uv);
  }
  for (const int node : fan.ring) ring.push_back(all[static_cast<std::size_t>(node)]);
  return ring;
}

TEST(BoundaryOf, APolygonKeepsItsFansWhole) {
  for (const int multiple : {1, 2}) {
    const testing::TiledModel tiled(testing::sphere_of(1), testing::sizes_of(0.2),
                                    {.multiple = multiple});
    const PatchBoundary& whole = tiled.whole[0];
    std::vector<TileNode> nodes;
    const PatchBoundary copy = boundary_of(polygon_of(whole, nodes), nodes, whole);
    ASSERT_EQ(copy.fans.size(), 2u);
    for (const PoleFan& fan : copy.fans) {
      const auto same =
          std::find_if(whole.fans.begin(), whole.fans.end(),
                       [&fan](const PoleFan& other) { return other.pole == fan.pole; });
      ASSERT_NE(same, whole.fans.end());
      EXPECT_EQ(ring_of(copy, fan), ring_of(whole, *same));
      EXPECT_EQ(fan.contour_from, same->contour_from);
      EXPECT_EQ(fan.contour_to, same->contour_to);
      EXPECT_EQ(fan.segments_per_face, multiple);
      EXPECT_EQ(fan.first_share, 0);
      EXPECT_EQ(fan.last_share, 1);
    }
  }
}

TEST(PolygonOf, ARingLetsCutsEndBetweenFacesOnly) {
  const testing::TiledModel tiled(testing::sphere_of(1), testing::sizes_of(0.2), {.multiple = 2});
  const PatchBoundary& whole = tiled.whole[0];
  std::vector<TileNode> nodes;
  polygon_of(whole, nodes);
  std::size_t refused = 0;
  for (const PoleFan& fan : whole.fans) {
    for (std::size_t k = 0; k < fan.ring.size(); ++k) {
      EXPECT_EQ(nodes[static_cast<std::size_t>(fan.ring[k])].can_end_cut, k % 2 == 0);
      refused += k % 2;
    }
  }
  EXPECT_EQ(
      static_cast<std::size_t>(std::count_if(
          nodes.begin(), nodes.end(), [](const TileNode& node) { return !node.can_end_cut; })),
      refused);
  EXPECT_GT(refused, 0u);
}

}  // namespace
}  // namespace surfmesh::detail
