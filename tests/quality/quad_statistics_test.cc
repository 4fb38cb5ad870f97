// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/quad_statistics.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/errors.hh"
#include "support/quad_meshes.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::attach_plane_properties;
using testing::GridNumbers;
using testing::mesh_of;

/// One flat face with corner properties.
PolyMesh polygon(const std::vector<Vec3>& points, const Metric& metric = {1, 0, 1}) {
  std::vector<int> face;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) face.push_back(i);
  PolyMesh mesh = mesh_of(points, {face});
  attach_plane_properties(mesh, metric);
  return mesh;
}

PolyMesh unit_square(const Metric& metric = {1, 0, 1}) {
  return polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, metric);
}

PolyMesh rhombus(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return polygon({{0, 0, 0}, {1, 0, 0}, {1 + c, s, 0}, {c, s, 0}});
}

/// A square with its third corner pushed in beyond the diagonal.
PolyMesh dart() { return polygon({{0, 0, 0}, {1, 0, 0}, {0.25, 0.25, 0}, {0, 1, 0}}); }

PolyMesh grid(int columns, int rows) {
  PolyMesh mesh = testing::quad_grid(GridNumbers(columns, rows));
  attach_plane_properties(mesh);
  return mesh;
}

/// Turn the patch over in its parameters: (u,v) is (−x, y).
void reverse_parameters(PolyMesh& mesh) {
  const auto uv = require(mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    mesh.property(uv, heh).u = -mesh.property(uv, heh).u;
  }
}

TEST(QuadStatistics, OfASquareAreOne) {
  const QuadStatistics s = measure_quads(unit_square());
  EXPECT_EQ(s.count, 1u);
  EXPECT_EQ(s.fraction, 1);
  EXPECT_NEAR(s.min_jacobian, 1, 1e-15);
  EXPECT_NEAR(s.mean_jacobian, 1, 1e-15);
  EXPECT_NEAR(s.min_space_jacobian, 1, 1e-15);
  EXPECT_NEAR(s.mean_space_jacobian, 1, 1e-15);
  EXPECT_EQ(s.inverted, 0u);
  EXPECT_EQ(s.flat, 0u);
  EXPECT_EQ(s.worst_face, 0);
}

TEST(QuadStatistics, OfARectangleAreOne) {
  EXPECT_NEAR(measure_quads(polygon({{0, 0, 0}, {9, 0, 0}, {9, 1, 0}, {0, 1, 0}})).min_jacobian, 1,
              1e-15);
  EXPECT_NEAR(measure_quads(unit_square({1e4, 0, 1e-4})).min_jacobian, 1, 1e-14);
}

TEST(QuadStatistics, OfARhombusAreTheSineOfItsAngle) {
  for (const double angle : {0.2, 0.8, 1.2, 2.0, 2.9}) {
    const QuadStatistics s = measure_quads(rhombus(angle));
    EXPECT_NEAR(s.min_jacobian, std::sin(angle), 1e-14);
    EXPECT_NEAR(s.min_space_jacobian, std::sin(angle), 1e-14);
  }
}

TEST(QuadStatistics, OfASquareAreTheSineOfTheAngleThatTheMetricSees) {
  const double angle = 0.6;
  const QuadStatistics s = measure_quads(unit_square({1, std::cos(angle), 1}));
  EXPECT_NEAR(s.min_jacobian, std::sin(angle), 1e-14);
  EXPECT_NEAR(s.min_space_jacobian, 1, 1e-15);
}

TEST(QuadStatistics, TakeTheMeanOfTheLeastOfEachQuad) {
  PolyMesh mesh =
      mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.5, 0.5, 0}, {1.5, 1.5, 0}},
              {{0, 1, 2, 3}, {1, 4, 5, 2}});
  attach_plane_properties(mesh);
  const QuadStatistics s = measure_quads(mesh);
  EXPECT_NEAR(s.min_jacobian, std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(s.mean_jacobian, 0.5 * (1 + std::sqrt(0.5)), 1e-14);
  EXPECT_EQ(s.worst_face, 1);
  ASSERT_EQ(s.histogram.size(), 11u);
  EXPECT_EQ(s.histogram[8], (HistogramBin{0.7, 0.8, 1}));
  EXPECT_EQ(s.histogram[10], (HistogramBin{0.9, 1, 1}));
}

TEST(QuadStatistics, CountInvertedQuads) {
  const QuadStatistics s = measure_quads(dart());
  EXPECT_LT(s.min_jacobian, 0);
  EXPECT_LT(s.min_space_jacobian, 0);
  EXPECT_EQ(s.inverted, 1u);
  EXPECT_EQ(s.flat, 1u);
  EXPECT_EQ(s.histogram.front().count, 1u);
}

TEST(QuadStatistics, CountFlatQuadsThatAreNotInverted) {
  const QuadStatistics s = measure_quads(rhombus(std::asin(0.09)));
  EXPECT_EQ(s.inverted, 0u);
  EXPECT_EQ(s.flat, 1u);
  EXPECT_EQ(measure_quads(rhombus(std::asin(0.11))).flat, 0u);
}

TEST(QuadStatistics, AreTheSameInAPatchThatIsReversed) {
  PolyMesh mesh = grid(3, 2), bad = dart();
  reverse_parameters(mesh);
  EXPECT_NEAR(measure_quads(mesh).min_jacobian, 1, 1e-15);
  EXPECT_EQ(measure_quads(mesh).inverted, 0u);
  const double before = measure_quads(bad).min_jacobian;
  reverse_parameters(bad);
  EXPECT_NEAR(measure_quads(bad).min_jacobian, before, 1e-15);
}

TEST(QuadStatistics, JudgeEachPatchByItsOwnOrientation) {
  PolyMesh mesh = grid(2, 1);
  mesh.property(require(mesh, keys::face_patch), FaceHandle(1)) = 1;
  const auto uv = require(mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh.fh_range(FaceHandle(1))) {
    mesh.property(uv, heh).u = -mesh.property(uv, heh).u;
  }
  EXPECT_EQ(measure_quads(mesh).inverted, 0u);
  mesh.property(require(mesh, keys::face_patch), FaceHandle(1)) = 0;
  EXPECT_EQ(measure_quads(mesh).inverted, 1u);
}

TEST(QuadStatistics, TellTheLeastOfEachPatch) {
  PolyMesh mesh = grid(3, 1);
  const auto patch = require(mesh, keys::face_patch);
  mesh.property(patch, FaceHandle(1)) = 2;
  mesh.property(patch, FaceHandle(2)) = 2;
  const std::vector<double> least = measure_quads(mesh).min_of_patches;
  ASSERT_EQ(least.size(), 3u);
  EXPECT_NEAR(least[0], 1, 1e-15);
  EXPECT_EQ(least[1], std::numeric_limits<double>::infinity());
  EXPECT_NEAR(least[2], 1, 1e-15);
}

/// A quad whose third corner is straight in (u,v), with other points in space.
PolyMesh with_straight_corner(const Vec3& third) {
  PolyMesh mesh = polygon({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}});
  mesh.set_point(VertexHandle(2), to_openmesh(third));
  return mesh;
}

TEST(QuadStatistics, MeasureACornerThatIsStraightInParametersInSpace) {
  const QuadStatistics bent = measure_quads(with_straight_corner({2, 2, 0}));
  EXPECT_NEAR(bent.min_jacobian, std::sqrt(0.5), 1e-12);  // of the corners beside it, in (u,v)
  const QuadStatistics straight = measure_quads(with_straight_corner({1, 1, 0}));
  EXPECT_NEAR(straight.min_jacobian, 0, 1e-12);
  const QuadStatistics turned = measure_quads(with_straight_corner({0.5, 0.5, 0}));
  EXPECT_EQ(turned.min_jacobian, 0);
  EXPECT_EQ(turned.inverted, 0u);  // it is not turned over in (u,v)
}

TEST(QuadStatistics, MeasureACornerOfNoAngleAsZero) {
  const QuadStatistics s = measure_quads(polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(s.min_jacobian, 0);
  EXPECT_EQ(s.min_space_jacobian, 0);
}

TEST(QuadStatistics, MeasureASideOfNoLengthAsZero) {
  EXPECT_EQ(measure_quads(polygon({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}})).min_jacobian, 0);
}

TEST(QuadStatistics, FindNoIrregularVertexInALattice) {
  EXPECT_EQ(measure_quads(grid(4, 3)).irregular_share, 0);
  EXPECT_EQ(measure_quads(unit_square()).irregular_share, 0);
}

/// A hexagon of three rhombi around its centre.
TEST(QuadStatistics, TellTheShareOfIrregularInnerVertices) {
  std::vector<Vec3> points = {Vec3::Zero()};
  for (int i = 0; i < 6; ++i) {
    points.push_back({std::cos(pi * i / 3), std::sin(pi * i / 3), 0});
  }
  PolyMesh mesh = mesh_of(points, {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}});
  attach_plane_properties(mesh);
  EXPECT_EQ(measure_quads(mesh).irregular_share, 1);
}

TEST(QuadStatistics, LeaveTrianglesOut) {
  PolyMesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.1, 0.5, 0}},
                          {{0, 1, 2, 3}, {1, 4, 2}});
  attach_plane_properties(mesh);
  const QuadStatistics s = measure_quads(mesh);
  EXPECT_EQ(s.count, 1u);
  EXPECT_EQ(s.fraction, 0.5);
  EXPECT_NEAR(s.mean_jacobian, 1, 1e-15);
}

TEST(QuadStatistics, OfTrianglesAloneAreNone) {
  EXPECT_EQ(measure_quads(testing::plane_grid(2, 2)), QuadStatistics());
  EXPECT_EQ(measure_quads(testing::plane_grid(2, 2)).worst_face, -1);
}

TEST(QuadStatistics, CountNoVertexBesideATriangleAsIrregular) {
  // Two triangles and three quads around the vertex in the middle of four squares.
  PolyMesh mesh = mesh_of({{0, 0, 0},
                           {1, 0, 0},
                           {2, 0, 0},
                           {0, 1, 0},
                           {1, 1, 0},
                           {2, 1, 0},
                           {0, 2, 0},
                           {1, 2, 0},
                           {2, 2, 0}},
                          {{0, 1, 4}, {0, 4, 3}, {1, 2, 5, 4}, {4, 5, 8, 7}, {3, 4, 7, 6}});
  attach_plane_properties(mesh);
  EXPECT_EQ(measure_quads(mesh).irregular_share, 0);
}

TEST(QuadStatistics, RefuseACornerThatIsNotSet) {
  PolyMesh mesh = grid(2, 1);
  const HalfedgeHandle corner = mesh.halfedge_handle(FaceHandle(1));
  mesh.property(require(mesh, keys::corner_metric), corner) = Metric();
  EXPECT_EQ(error_of([&] { measure_quads(mesh); }).rfind("invalid input: face 1: ", 0), 0u)
      << error_of([&] { measure_quads(mesh); });
  PolyMesh other = grid(2, 1);
  other.property(require(other, keys::corner_uv), corner) = Uv();
  EXPECT_NE(error_of([&] { measure_quads(other); }).find("is not set"), std::string::npos);
}

TEST(QuadStatistics, RefuseAMeshWithoutParameters) {
  const PolyMesh mesh = testing::quad_grid(GridNumbers(1, 1));
  EXPECT_NE(error_of([&] { measure_quads(mesh); }).find("surf:"), std::string::npos);
}

}  // namespace
}  // namespace surfmesh
