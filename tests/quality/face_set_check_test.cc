// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/face_set_check.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surfmesh {
namespace {

MeshArrays set_of(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& faces) {
  MeshArrays set;
  set.points = points;
  for (const auto& face : faces) set.faces.add(face);
  return set;
}

const std::vector<Vec3> kCorners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

const std::vector<std::vector<int>> kCube = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                             {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/// Expect this one kind of fault, this often.
void expect_fault(const MeshArrays& set, const std::string& kind, std::size_t count,
                  const std::string& place) {
  const FaceSetCheck check = check_face_set(set);
  ASSERT_EQ(check.faults.size(), 1u) << kind;
  EXPECT_EQ(check.faults[0].kind, kind);
  EXPECT_EQ(check.faults[0].count, count);
  EXPECT_EQ(check.faults[0].places.at(0), place);
}

TEST(CheckFaceSet, CountsACube) {
  const FaceSetCheck check = check_face_set(set_of(kCorners, kCube));
  EXPECT_EQ(check.vertices, 8u);
  EXPECT_EQ(check.edges, 12u);
  EXPECT_EQ(check.quads, 6u);
  EXPECT_EQ(check.euler, 2);
  EXPECT_EQ(check.components, 1u);
  EXPECT_TRUE(check.is_closed && check.is_manifold && check.is_oriented);
  EXPECT_TRUE(check.faults.empty());
}

TEST(CheckFaceSet, CountsBoundaryLoopsAndComponents) {
  auto faces = kCube;
  faces.erase(faces.begin(), faces.begin() + 2);
  const FaceSetCheck tube = check_face_set(set_of(kCorners, faces));
  EXPECT_EQ(tube.boundary_loops, 2u);
  EXPECT_EQ(tube.boundary_edges, 8u);
  EXPECT_EQ(tube.euler, 0);
  EXPECT_FALSE(tube.is_closed);
  const FaceSetCheck lids = check_face_set(set_of(kCorners, {kCube[0], kCube[1]}));
  EXPECT_EQ(lids.components, 2u);
  EXPECT_EQ(lids.boundary_loops, 2u);
}

TEST(CheckFaceSet, FindsNonManifoldEdges) {
  const MeshArrays set = set_of(kCorners, {{0, 1, 2}, {1, 0, 4}, {0, 1, 3}});
  const FaceSetCheck check = check_face_set(set);
  EXPECT_FALSE(check.is_manifold);
  EXPECT_EQ(check.faults[0].kind, "non_manifold_edge");
  EXPECT_EQ(check.faults[0].places[0], "edge 0-1 at (0.5, 0, 0), of 3 faces");
}

TEST(CheckFaceSet, FindsTurnedNeighbours) {
  auto faces = kCube;
  std::reverse(faces[1].begin(), faces[1].end());
  expect_fault(set_of(kCorners, faces), "turned_neighbour", 4,
               "faces 1 and 2, edge 4-5 at (0.5, 0, 1)");
  EXPECT_FALSE(check_face_set(set_of(kCorners, faces)).is_oriented);
}

TEST(CheckFaceSet, FindsVerticesInWhichSheetsTouch) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  expect_fault(set_of(points, {{0, 1, 2}, {0, 3, 4}}), "non_manifold_vertex", 1,
               "vertex 0 at (0, 0, 0)");
}

TEST(CheckFaceSet, FindsDegenerateFaces) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  expect_fault(set_of(points, {{0, 1, 2}}), "degenerate_face", 1, "face 0 at (0, 0, 0)");
  EXPECT_TRUE(
      check_face_set(set_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{0, 1, 2}})).faults.empty());
}

TEST(CheckFaceSet, FindsDuplicates) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                    {2, 0, 0}, {1, 1, 0}, {3, 1, 0}};
  expect_fault(set_of(points, {{0, 1, 2}, {3, 5, 4}}), "duplicate_vertex", 1,
               "vertices 2 and 4 at (1, 1, 0)");
}

TEST(CheckFaceSet, FindsDuplicateFaces) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  expect_fault(set_of(points, {{0, 1, 2}, {2, 1, 0}}), "duplicate_face", 1,
               "faces 0 and 1 at (0, 1, 0)");
}

TEST(CheckFaceSet, FindsUnusedVertices) {
  expect_fault(set_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}}), "unused_vertex",
               1, "vertex 3 at (5, 5, 5)");
}

TEST(CheckFaceSet, KeepsTenPlaces) {
  std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (int i = 0; i < 30; ++i) points.push_back({5, 5, 1.0 * i});
  const FaceSetCheck check = check_face_set(set_of(points, {{0, 1, 2}}));
  EXPECT_EQ(check.faults.at(0).count, 30u);
  EXPECT_EQ(check.faults.at(0).places.size(), 10u);
}

TEST(MeasureShape, KnowsTheAnglesOfASetSquare) {
  const double root3 = std::numbers::sqrt3;
  const ShapeStatistics shape =
      measure_shape(set_of({{0, 0, 0}, {1, 0, 0}, {0, root3, 0}}, {{0, 1, 2}}));
  EXPECT_NEAR(shape.min_angle, std::numbers::pi / 6, 1e-15);
  EXPECT_NEAR(shape.max_angle, std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(shape.quality.mean, 4 * root3 * (root3 / 2) / 8, 1e-15);
  EXPECT_NEAR(shape.max_edge, 2, 1e-15);
  ASSERT_EQ(shape.quality.histogram.size(), 11u);
  EXPECT_EQ(shape.quality.histogram[8], (HistogramBin{0.7, 0.8, 1}));
  std::size_t sum = 0;
  for (const HistogramBin& bin : shape.angles) sum += bin.count;
  EXPECT_EQ(sum, 3u);
}

TEST(MeasureShape, HoldsForLengthsWhoseProductsAreNoNumbers) {
  for (const double length : {1e-200, 1e-3, 1e200}) {
    const ShapeStatistics shape = measure_shape(
        set_of({{0, 0, 0}, {length, 0, 0}, {length / 2, length * std::numbers::sqrt3 / 2, 0}},
               {{0, 1, 2}}));
    EXPECT_NEAR(shape.quality.min, 1, 1e-14) << length;
    EXPECT_NEAR(shape.max_angle, std::numbers::pi / 3, 1e-14) << length;
    EXPECT_NEAR(shape.max_edge / length, 1, 1e-14);
    EXPECT_EQ(shape.quality.below_0_3, 0);
  }
}

TEST(MeasureShape, TakesAFaceThatIsLongerThanAnyNumber) {
  const ShapeStatistics shape =
      measure_shape(set_of({{-1e308, 0, 0}, {1e308, 0, 0}, {0, 1e308, 0}}, {{0, 1, 2}}));
  EXPECT_EQ(shape.quality.min, 0);
  EXPECT_TRUE(std::isinf(shape.max_edge));
}

TEST(MeasureShape, LeavesQuadsOutOfTheQuality) {
  const ShapeStatistics shape = measure_shape(set_of(kCorners, kCube));
  EXPECT_EQ(shape.quality.count, 0u);
  EXPECT_TRUE(shape.quality.histogram.empty());
  EXPECT_NEAR(shape.min_angle, std::numbers::pi / 2, 1e-15);
}

}  // namespace
}  // namespace surfmesh
