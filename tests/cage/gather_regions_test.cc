// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/gather_regions.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cage/cages.hh"
#include "cage/region_topology.hh"
#include "surfmesh/cage/creases.hh"
#include "surfmesh/cage/face_loops.hh"

namespace surfmesh {
namespace {

using testing::RegionTopology;

constexpr double kDegree = M_PI / 180;

/// Laws of all regions: each face is in one, they are connected, and charts are graphs.
void expect_valid(const RegionTopology& cage, const std::vector<FaceRegion>& regions) {
  const FaceNeighbours neighbours = cage.neighbours();
  std::vector<int> region_of(cage.sets.size(), -1);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    EXPECT_TRUE(std::is_sorted(regions[r].faces.begin(), regions[r].faces.end()));
    EXPECT_EQ(regions[r].is_chart, regions[r].faces.size() > 1);
    for (const int face : regions[r].faces) {
      EXPECT_EQ(std::exchange(region_of[static_cast<std::size_t>(face)], static_cast<int>(r)), -1);
    }
  }
  for (std::size_t f = 0; f < cage.sets.size(); ++f) {
    EXPECT_EQ(region_of[f] >= 0, cage.sets[f] >= 0) << "face " << f;
  }
  for (std::size_t r = 0; r < regions.size(); ++r) {
    std::set<int> reached = {regions[r].faces.front()};
    std::vector<int> stack = {regions[r].faces.front()};
    while (!stack.empty()) {
      const int face = stack.back();
      stack.pop_back();
      const Surface& surface = *cage.surfaces[static_cast<std::size_t>(face)];
      const Domain domain = surface.domain();
      for (int i = 0; i < neighbours.corner_count(); ++i) {
        if (regions[r].is_chart) {
          const Jet jet = surface.evaluate(domain.corner(i), Order::First);
          EXPECT_GT(jet.du.cross(jet.dv).normalized().dot(regions[r].frame.normal),
                    std::cos(69.1 * kDegree));
        }
        const int next = neighbours.across({face, i}).face;
        if (next < 0 || region_of[static_cast<std::size_t>(next)] != static_cast<int>(r)) continue;
        if (reached.insert(next).second) stack.push_back(next);
      }
    }
    EXPECT_EQ(reached.size(), regions[r].faces.size()) << "region " << r;
  }
}

TEST(GatherRegions, DividesATorusIntoFew) {
  const RegionTopology cage(testing::triangulated(testing::torus(60, 24)));
  const auto regions = cage.regions();
  expect_valid(cage, regions);
  // A plane sees 120° of 360° around the tube, and as much along it.
  EXPECT_GE(regions.size(), 12U);
  EXPECT_LE(regions.size(), 50U);
}

TEST(GatherRegions, DividesAFlatSheetByTheNumberOfFacesOnly) {
  const RegionTopology small(testing::flat_sheet(30, 30));
  EXPECT_EQ(small.regions().size(), 1U);
  const RegionTopology large(testing::flat_sheet(130, 130));
  expect_valid(large, large.regions());
  EXPECT_GE(large.regions().size(), 5U);
  EXPECT_LE(large.regions().size(), 17U);
}

TEST(GatherRegions, EndAtGroups) {
  std::vector<int> sets(900, 0);
  for (std::size_t f = 0; f < 300; ++f) sets[f] = 1;
  const RegionTopology cage(testing::flat_sheet(30, 30), sets);
  const auto regions = cage.regions();
  expect_valid(cage, regions);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].faces.size(), 300U);
  EXPECT_EQ(regions[0].margin.size(), 0U);
}

/// A crease that ends inside the sheet: a region around its end would have both sides of it.
TEST(GatherRegions, HaveNoCreaseInside) {
  Cage cage = testing::flat_sheet(20, 20);
  std::vector<int> line;
  for (int j = 0; j <= 12; ++j) line.push_back(j * 21 + 10);
  add_crease(line, 10, cage);
  const RegionTopology topology(cage);
  const auto regions = topology.regions();
  expect_valid(topology, regions);
  std::vector<int> region_of(cage.faces.size());
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const int face : regions[r].faces) {
      region_of[static_cast<std::size_t>(face)] = static_cast<int>(r);
    }
  }
  for (int j = 0; j < 12; ++j) {
    const auto left = static_cast<std::size_t>(j * 20 + 9);
    EXPECT_NE(region_of[left], region_of[left + 1]) << "row " << j;
  }
}

TEST(GatherRegions, LeaveOutHoles) {
  Cage cage = testing::flat_sheet(20, 20);
  cage.holes = {210, 211};
  const RegionTopology topology(cage);
  const auto regions = topology.regions();
  expect_valid(topology, regions);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].faces.size(), 398U);
}

/// A spiral ramp of two turns: normals are nearly upright everywhere, but it covers itself.
TEST(GatherRegions, DoNotCoverThemselves) {
  Cage cage;
  constexpr int n = 60;
  for (int i = 0; i <= n; ++i) {
    const double a = 4 * M_PI * i / n;
    for (int j = 0; j <= 4; ++j) {
      const double r = 2 + 0.25 * j;
      cage.points.emplace_back(r * std::cos(a), r * std::sin(a), 0.1 * a);
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 4; ++j) {
      const int at = i * 5 + j;
      cage.faces.push_back({at, at + 1, at + 6, at + 5});
    }
  }
  const RegionTopology topology(cage);
  const auto regions = topology.regions();
  expect_valid(topology, regions);
  for (const FaceRegion& region : regions) {
    // A whole turn is 120 faces.
    EXPECT_LE(region.faces.size(), 120U);
    EXPECT_GT(region.faces.size(), 10U);
  }
}

/// Faces that turn by themselves stay alone.
TEST(GatherRegions, LeaveSharplyBentFacesAlone) {
  const RegionTopology cage(testing::cube());
  const auto regions = cage.regions();
  expect_valid(cage, regions);
  EXPECT_EQ(regions.size(), 6U);
}

}  // namespace
}  // namespace surfmesh
