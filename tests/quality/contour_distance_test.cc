// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/contour_distance.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "support/meshes.hh"
#include "support/models.hh"
#include "surfmesh/model/join_sides.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

constexpr double kTolerance = 1e-6;

/// The unit disc, cut out of a square by a circle.
Model disc() {
  const auto circle = std::make_shared<CallableCurve>([](double t) {
    return Uv{std::cos(2 * pi * t), std::sin(2 * pi * t)};
  });
  return model_from_patches({{"disc", testing::rectangle(-2, -2, 2, 2), {{"rim"}}}},
                            {{"rim", nullptr, {{"disc", circle}}}});
}

/// Triangles around the origin, with corners on the unit circle.
PolyMesh fan(int count) {
  std::vector<Vec3> points{Vec3::Zero()};
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    faces.push_back({0, i + 1, (i + 1) % count + 1});
  }
  return testing::mesh_of(points, faces);
}

double greatest(const std::vector<ContourDistance>& far) {
  double distance = 0;
  for (const ContourDistance& point : far) distance = std::max(distance, point.distance);
  return distance;
}

TEST(SharpContours, AreBordersAndCreases) {
  // A smooth joint at x = 1, a crease at x = 2, and borders all around.
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1),
                         std::make_shared<test::PlanePatch>(Vec3(2, 0, 0), Vec3::UnitZ(),
                                                            Vec3::UnitY(), Domain{0, 1, 0, 1})});
  int borders = 0, creases = 0;
  for (const SharpContour& contour : sharp_contours(model, kTolerance)) {
    ++(contour.is_border ? borders : creases);
    if (contour.is_border) continue;
    for (const Vec3& point : contour.points) EXPECT_EQ(point.x(), 2);
  }
  EXPECT_EQ(borders, 8);
  EXPECT_EQ(creases, 1);
}

TEST(SharpContours, HaveChordsWithinTheTolerance) {
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const std::vector<SharpContour> contours = sharp_contours(disc(), tolerance);
    ASSERT_EQ(contours.size(), 1u);
    const std::vector<Vec3>& points = contours[0].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      EXPECT_LE(1 - (0.5 * (points[i] + points[i - 1])).norm(), tolerance);
    }
  }
}

// The mesh of a disc has no distance from its plane, however few corners it has.
TEST(FarContourPoints, SeesWhatTheBorderCutsOff) {
  const std::vector<SharpContour> contours = sharp_contours(disc(), kTolerance);
  for (const int count : {3, 8, 50}) {
    const double sagitta = 1 - std::cos(pi / count);
    const auto far = far_contour_points(fan(count), contours, 0.5 * sagitta);
    EXPECT_NEAR(greatest(far), sagitta, 2 * kTolerance) << count;
    for (const ContourDistance& point : far) {
      EXPECT_NEAR(point.point.norm(), 1, 1e-12);
      EXPECT_TRUE(point.face.is_valid());
      EXPECT_GT(point.distance, 0.5 * sagitta);
    }
    EXPECT_TRUE(far_contour_points(fan(count), contours, sagitta + kTolerance).empty());
  }
}

TEST(FarContourPoints, NamesTheNearestFace) {
  const PolyMesh mesh = fan(8);
  const auto all = far_contour_points(mesh, sharp_contours(disc(), kTolerance), 0.03);
  ASSERT_GT(all.size(), 8u);
  for (const ContourDistance& far : all) {
    const Vec3 middle = to_eigen(mesh.calc_face_centroid(far.face));
    EXPECT_GT(middle.normalized().dot(far.point), std::cos(pi / 8) - 1e-9);
  }
}

TEST(FarContourPoints, ComparesCreasesWithTriangles) {
  // A roof over [-1,1]x[0,1], its ridge at x = 0 cut off at half its height.
  const std::vector<SharpContour> ridge{{0, false, {{0, 0, 1}, {0, 0.5, 1}, {0, 1, 1}}}};
  const PolyMesh mesh = testing::mesh_of({{-1, 0, 0},
                                          {-0.5, 0, 0.5},
                                          {0.5, 0, 0.5},
                                          {1, 0, 0},
                                          {-1, 1, 0},
                                          {-0.5, 1, 0.5},
                                          {0.5, 1, 0.5},
                                          {1, 1, 0}},
                                         {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}});
  const auto far = far_contour_points(mesh, ridge, 0);
  ASSERT_EQ(far.size(), 3u);
  for (const ContourDistance& point : far) {
    EXPECT_NEAR(point.distance, 0.5, 1e-12);
    EXPECT_EQ(point.face.idx(), 1);
  }
}

TEST(FarContourPoints, FindsNothingWithoutABorder) {
  const std::vector<SharpContour> contours = sharp_contours(disc(), kTolerance);
  EXPECT_TRUE(far_contour_points(PolyMesh(), contours, 0).empty());
}

}  // namespace
}  // namespace surfmesh
