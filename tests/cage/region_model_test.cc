// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/region_model.hh"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cage/cages.hh"
#include "support/models.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/cage/creases.hh"
#include "surfmesh/geometry/crossing_segments.hh"
#include "surfmesh/model/finish_model.hh"

namespace surfmesh {
namespace {

Model regions_of(const Cage& cage) {
  CageOptions options;
  options.patches = PatchKind::Regions;
  return model_from_cage(cage, options);
}

/// The loops of a patch as polygons.
std::vector<detail::NodeLoop> polygons(const Model& model, const Patch& patch) {
  std::vector<detail::NodeLoop> loops;
  for (const PatchLoop& loop : patch.loops) {
    detail::NodeLoop& nodes = loops.emplace_back();
    for (const LoopEntry& entry : loop) {
      const ContourUse& use = model.use(entry);
      const int count = 5 * model.contour(entry).part_count();
      for (int i = 0; i < count; ++i) {
        const double t = double(i) / count;
        nodes.push_back(use.curve->evaluate(use.is_forward ? t : 1 - t));
      }
    }
  }
  return loops;
}

double area(const detail::NodeLoop& nodes) {
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sum += cross(nodes[i], nodes[(i + 1) % nodes.size()]) / 2;
  }
  return sum;
}

/// Laws of all models of regions.
void expect_valid_region_model(const Model& model) {
  check(model);
  for (const Contour& contour : model.contours) {
    EXPECT_LT(gap_of(model, contour), 1e-8 * model.diagonal) << contour.name;
    EXPECT_NE(contour.start, contour.end) << contour.name;
  }
  for (const Patch& patch : model.patches) {
    const auto loops = polygons(model, patch);
    EXPECT_TRUE(detail::crossing_segments(loops).empty()) << patch.name;
    const Domain domain = patch.surface->domain();
    for (std::size_t i = 0; i < loops.size(); ++i) {
      EXPECT_GE(patch.loops[i].size(), 3U) << patch.name;
      EXPECT_EQ(area(loops[i]) > 0, i == 0) << patch.name;
      for (const Uv uv : loops[i]) {
        EXPECT_TRUE(uv.u >= domain.u0 && uv.u <= domain.u1 && uv.v >= domain.v0 &&
                    uv.v <= domain.v1)
            << patch.name;
      }
    }
  }
}

std::size_t contours_with(const Model& model, std::size_t uses) {
  return static_cast<std::size_t>(
      std::count_if(model.contours.begin(), model.contours.end(),
                    [&](const Contour& c) { return c.uses.size() == uses; }));
}

TEST(RegionModel, UsesOfAContourAgree) {
  for (const Cage& cage : {testing::triangulated(testing::torus(60, 24)), testing::torus(40, 20),
                           testing::triangulated(testing::tube(40, 30, 6))}) {
    expect_valid_region_model(regions_of(cage));
  }
}

TEST(RegionModel, NamesPatchesAndContoursAfterTheCage) {
  const Model model = regions_of(testing::torus(40, 20));
  EXPECT_EQ(model.patches[0].name, "f0");
  std::size_t faces = 0;
  for (const Patch& patch : model.patches) {
    EXPECT_EQ(patch.name, fmt::format("f{}", patch.cage_faces.front()));
    faces += patch.cage_faces.size();
  }
  EXPECT_EQ(faces, 800U);
  for (const Contour& contour : model.contours) {
    EXPECT_EQ(contour.name.front(), 'e');
    EXPECT_NE(contour.name.find('-'), std::string::npos);
  }
}

/// Between two charts a contour does not follow the zigzag of the edges.
TEST(RegionModel, FreeContoursAreSmooth) {
  const Model model = regions_of(testing::triangulated(testing::torus(60, 24)));
  double length = 0, straight = 0;
  for (const Contour& contour : model.contours) {
    EXPECT_TRUE(contour.is_smooth);
    const int count = 4 * contour.part_count();
    Vec3 before = model.point(contour.uses[0], 0);
    straight += (model.point(contour.uses[0], 1) - before).norm();
    for (int i = 1; i <= count; ++i) {
      const Vec3 here = model.point(contour.uses[0], double(i) / count);
      length += (here - before).norm();
      before = here;
    }
  }
  // Along the edges it would be 1.3 and more.
  EXPECT_LT(length, 1.15 * straight);
}

TEST(RegionModel, CreasesAndBordersStayAtTheEdges) {
  Cage cage = testing::flat_sheet(20, 20);
  std::vector<int> line;
  for (int j = 0; j <= 20; ++j) line.push_back(j * 21 + 10);
  add_crease(line, 10, cage);
  const Model model = regions_of(cage);
  expect_valid_region_model(model);
  EXPECT_EQ(model.patches.size(), 2U);
  const auto crease = std::find_if(model.contours.begin(), model.contours.end(),
                                   [](const Contour& c) { return c.uses.size() == 2; });
  ASSERT_NE(crease, model.contours.end());
  EXPECT_FALSE(crease->is_smooth);
  EXPECT_EQ(contours_with(model, 2), 1U);
  EXPECT_EQ(crease->part_count(), 20);
  // The limit positions of regular vertices on a crease: a cubic B-spline, from either end.
  const auto at = [&](int j) { return cage.points[static_cast<std::size_t>(j * 21 + 10)]; };
  const bool is_upward = model.position(crease->start).y() < model.position(crease->end).y();
  for (int i = 1; i < 20; ++i) {
    const Vec3 point = model.point(crease->uses[0], (is_upward ? i : 20 - i) / 20.0);
    EXPECT_LT((point - (at(i - 1) + 4 * at(i) + at(i + 1)) / 6).norm(), 1e-12) << i;
  }
}

TEST(RegionModel, HasHoles) {
  Cage cage = testing::flat_sheet(20, 20);
  cage.holes = {210};
  const Model model = regions_of(cage);
  expect_valid_region_model(model);
  ASSERT_EQ(model.patches.size(), 1U);
  EXPECT_EQ(model.patches[0].loops.size(), 2U);
}

/// Polygons become quads first, whose patches are named after their parts.
TEST(RegionModel, TakesPolygons) {
  Cage cage = testing::flat_sheet(12, 12);
  cage.faces[0].insert(cage.faces[0].begin() + 1, static_cast<int>(cage.points.size()));
  cage.points.push_back((cage.points[0] + cage.points[1]) / 2);
  const Model model = regions_of(cage);
  expect_valid_region_model(model);
  EXPECT_EQ(model.patches[0].name, "f0.0");
  EXPECT_EQ(model.patches[0].cage_faces.size(), cage.faces.size());
}

TEST(RegionModel, MoebiusStripsHaveRegions) {
  const Model model = regions_of(testing::mobius_strip(60, 6));
  expect_valid_region_model(model);
  EXPECT_GE(model.patches.size(), 4U);
}

}  // namespace
}  // namespace surfmesh
