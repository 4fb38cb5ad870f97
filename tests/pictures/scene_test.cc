// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/scene.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pictures/scenes.hh"
#include "pictures/visible_lines.hh"
#include "support/errors.hh"

namespace surfmesh {
namespace {

using testing::cube;
using testing::scene_of;
using testing::seen_from;

std::vector<Rgb> white(const PolyMesh& mesh) { return std::vector<Rgb>(mesh.n_faces(), {1, 1, 1}); }

std::size_t contours(const PolyMesh& mesh) {
  const std::vector<char> edges = contour_edges(mesh);
  return static_cast<std::size_t>(std::count(edges.begin(), edges.end(), 1));
}

TEST(ContourEdges, AreSharpEdgesAndBordersWithoutPatches) {
  EXPECT_EQ(contours(cube()), 12U);
  EXPECT_EQ(contours(cube(1e-200)), 12U);
  PolyMesh grid = testing::plane_grid(3, 2);
  detach(grid, keys::face_patch);
  EXPECT_EQ(contours(grid), 10U);
}

TEST(ContourEdges, LieBetweenPatches) {
  PolyMesh grid = testing::plane_grid(3, 2);
  const auto patch_of = require(grid, keys::face_patch);
  for (const FaceHandle fh : grid.faces()) grid.property(patch_of, fh) = fh.idx() < 6 ? 0 : 1;
  EXPECT_EQ(contours(grid), 13U);
}

TEST(ContourEdges, AreThoseThatTheMeshKnows) {
  PolyMesh mesh = cube();
  const auto contour_of = attach(mesh, keys::edge_contour, -1);
  mesh.property(contour_of, EdgeHandle(3)) = 0;
  EXPECT_EQ(contours(mesh), 1U);
}

TEST(SceneInSpace, FillsItsFrameWithAParallelView) {
  const Scene scene = scene_of(cube(), white(cube()), seen_from(-90, 0));
  ASSERT_EQ(scene.points.size(), 8U);
  EXPECT_EQ(scene.triangles.size(), 12U);
  EXPECT_EQ(scene.edges.size(), 12U);
  // Corner 0 is at (-1, -1, -1): lower left, near. All eight lie in the corners of the square.
  EXPECT_NEAR(scene.points[0].x, 0, 1e-9);
  EXPECT_NEAR(scene.points[0].y, 100, 1e-9);
  EXPECT_NEAR(scene.points[0].depth - scene.points[2].depth, 100, 1e-9);
}

TEST(SceneInSpace, MakesWhatIsFarSmallInPerspective) {
  SpaceView view = seen_from(-90, 0);
  view.camera.lens = Lens::Perspective;
  const Scene scene = scene_of(cube(), white(cube()), view);
  const double near = scene.points[1].x - scene.points[0].x,
               far = scene.points[3].x - scene.points[2].x;
  EXPECT_NEAR(near, 100, 1e-9);
  const double eye = 4 * std::sqrt(3.0);
  EXPECT_NEAR(far / near, (eye - 1) / (eye + 1), 1e-9);
}

TEST(SceneInSpace, ZoomsAndLooksAtAPoint) {
  SpaceView view = seen_from(-90, 0);
  view.zoom = 2;
  view.look_at = Vec3(-1, 0, -1);
  const Scene scene = scene_of(cube(), white(cube()), view);
  EXPECT_NEAR(scene.points[0].x, 50, 1e-9);
  EXPECT_NEAR(scene.points[0].y, 50, 1e-9);
  EXPECT_NEAR(scene.points[1].x, 250, 1e-9);
}

TEST(SceneInSpace, LooksOnlyAtPointsInFrontOfTheEye) {
  SpaceView view = seen_from(-90, 0);
  view.camera.lens = Lens::Perspective;
  const double eye = -4 * std::sqrt(3.0);  // on the y axis
  for (const double y : {eye, 1.001 * eye, 2 * eye, -1e300}) {
    view.look_at = Vec3(0.5, y, 0);
    SCOPED_TRACE(y);
    EXPECT_TRUE(error_of([&] {
                  scene_of(cube(), white(cube()), view);
                }).starts_with("invalid option: the point to look at (0.5, "));
    view.camera.lens = Lens::Parallel;
    EXPECT_NO_THROW(scene_of(cube(), white(cube()), view));
    view.camera.lens = Lens::Perspective;
  }
  view.look_at = Vec3(0, 0.99 * eye, 0);
  EXPECT_NEAR(scene_of(cube(), white(cube()), view).points[0].x, 0, 1e-9);
}

TEST(SceneInSpace, FitsTheFacesThatAreAskedFor) {
  const PolyMesh grid = testing::plane_grid(10, 10);
  SpaceView view = seen_from(-90, 90);
  view.part = {Vec3(0, 0, -1), Vec3(5, 5, 1)};
  EXPECT_NEAR(scene_of(grid, white(grid), view).points[5].x, 100, 1e-9);
  view.shown.assign(grid.n_faces(), 0);
  view.shown[0] = view.shown[1] = 1;
  EXPECT_NEAR(scene_of(grid, white(grid), view).points[1].x, 100, 1e-9);
}

TEST(SceneInSpace, IsTheSameFarAwayHugeAndTiny) {
  const PolyMesh mesh = cube();
  const Scene scene = scene_of(mesh, white(mesh), seen_from(-60, 30));
  for (const auto& [scale, move] :
       {std::pair(1e-200, 0.0), {1e200, 0.0}, {1.0, 1e9}, {4e307, 0.0}}) {
    PolyMesh other = mesh;
    for (const VertexHandle vh : other.vertices()) {
      other.set_point(vh,
                      to_openmesh(Vec3(scale * to_eigen(mesh.point(vh)) + Vec3::Constant(move))));
    }
    const Scene same = scene_of(other, white(other), seen_from(-60, 30));
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_NEAR(same.points[i].x, scene.points[i].x, 1e-4) << scale;
      EXPECT_NEAR(same.points[i].y, scene.points[i].y, 1e-4) << scale;
    }
    for (std::size_t t = 0; t < 12; ++t) {
      EXPECT_EQ(same.triangles[t].colour, scene.triangles[t].colour) << scale;
    }
  }
}

TEST(SceneInSpace, LightsBothSidesAlikeFromTheUpperLeft) {
  PolyMesh mesh = testing::plane_grid(1, 1);
  const Scene above = scene_of(mesh, white(mesh), seen_from(-60, 40));
  const Scene below = scene_of(mesh, white(mesh), seen_from(-60, -40));
  EXPECT_NE(above.triangles[0].colour, below.triangles[0].colour) << "light from above";
  const Scene box = scene_of(cube(), std::vector<Rgb>(6, {0.8, 0.8, 0.8}), seen_from(-45, 30));
  // Seen are x (to the right), -y (to the left) and z.
  const PackedRgb right = box.triangles[2].colour, left = box.triangles[4].colour,
                  top = box.triangles[10].colour;
  EXPECT_GT(top, left);
  EXPECT_GT(left, right);
}

TEST(SceneInSpace, DividesFacesBetweenTheirCorners) {
  const PolyMesh mesh = cube();
  const MeshPaint paint{std::vector<Rgb>(8, {1, 1, 1}), true};
  const Scene scene = scene_in_space(mesh, paint, seen_from(-60, 30), {{0, 0}, 100, 100});
  EXPECT_EQ(scene.triangles.size(), 48U);
  EXPECT_EQ(scene.edges.size(), 12U);
}

TEST(SceneInPlane, ShowsTheParametersOfAPatch) {
  PolyMesh grid = testing::plane_grid(4, 2);
  const auto patch_of = require(grid, keys::face_patch);
  for (const FaceHandle fh : grid.faces()) grid.property(patch_of, fh) = fh.idx() < 8 ? 0 : 1;
  const PlaneScene plane = scene_in_plane(grid, 1, {white(grid)}, {{0, 0}, 80, 80});
  EXPECT_EQ(plane.scene.triangles.size(), 8U);
  EXPECT_EQ(plane.box.min(), Eigen::Vector2d(0, 1));
  EXPECT_EQ(plane.box.max(), Eigen::Vector2d(4, 2));
  EXPECT_EQ(plane.place({0, 1}).x, 0);
  EXPECT_EQ(plane.place({4, 2}).x, 80);
  EXPECT_EQ(plane.place({4, 2}).y, 30) << "one scale for both axes";
}

TEST(SceneInPlane, StretchesVeryNarrowDomains) {
  PolyMesh grid = testing::plane_grid(20, 1);
  const PlaneScene plane = scene_in_plane(grid, 0, {white(grid)}, {{0, 0}, 80, 80});
  EXPECT_EQ(plane.place({20, 1}).y, 0);
  EXPECT_EQ(plane.place({20, 0}).y, 80);
}

TEST(SceneInPlane, ShowsBothSidesOfASeam) {
  // Two triangles that share an edge in space, but not in the parameters.
  PolyMesh mesh =
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  testing::attach_plane_properties(mesh);
  const auto uv = require(mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh.fh_range(FaceHandle(1))) {
    mesh.property(uv, heh).u += 3;
  }
  const PlaneScene plane = scene_in_plane(mesh, 0, {white(mesh)}, {{0, 0}, 80, 80});
  EXPECT_EQ(plane.scene.points.size(), 6U);
  ASSERT_EQ(plane.scene.edges.size(), 6U);
  for (const SceneEdge& edge : plane.scene.edges) EXPECT_TRUE(edge.is_contour);
}

TEST(SceneInPlane, NeedsAFace) {
  const PolyMesh grid = testing::plane_grid(1, 1);
  EXPECT_THROW(scene_in_plane(grid, 4, {white(grid)}, {{0, 0}, 80, 80}), Error);
  EXPECT_THROW(scene_in_plane(cube(), 0, {white(cube())}, {{0, 0}, 80, 80}), Error);
}

/// Lengths of all visible lines of a kind.
double length_of(const std::vector<StyledLines>& all, double width) {
  double sum = 0;
  for (const auto& [style, lines] : all) {
    if (style.width != width) continue;
    for (const PicturePoints& line : lines) {
      for (std::size_t i = 1; i < line.size(); ++i) {
        sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
      }
    }
  }
  return sum;
}

TEST(VisibleLines, AreThoseThatNothingHides) {
  const Scene scene = scene_of(cube(), white(cube()), seen_from(-60, 30));
  const DepthBuffer buffer(scene, 100, 100, 4);
  // Nine of the twelve edges are seen, those at corner 2 are not.
  double expected = 0;
  for (const SceneEdge& edge : scene.edges) {
    if (edge.from == 2 || edge.to == 2) continue;
    const ScenePoint &a = scene.points[std::size_t(edge.from)],
                     &b = scene.points[std::size_t(edge.to)];
    expected += std::hypot(b.x - a.x, b.y - a.y);
  }
  const double seen = length_of(visible_lines(scene, buffer, {.contour_width = 2}), 2);
  EXPECT_NEAR(seen, expected, 3);
}

TEST(VisibleLines, EndWhereSomethingIsInFront) {
  // A long strip behind a narrow one.
  const PolyMesh mesh = testing::mesh_of({{-4, 1, -1},
                                          {4, 1, -1},
                                          {4, 1, 1},
                                          {-4, 1, 1},
                                          {-1, 0, -4},
                                          {1, 0, -4},
                                          {1, 0, 4},
                                          {-1, 0, 4}},
                                         {{0, 1, 2, 3}, {4, 5, 6, 7}});
  const Scene scene = scene_of(mesh, white(mesh), seen_from(-90, 0));
  const DepthBuffer buffer(scene, 100, 100, 4);
  const double unit = 100 / 8.0;
  EXPECT_NEAR(length_of(visible_lines(scene, buffer, {.contour_width = 2}), 2),
              unit * (2 * 6 + 2 * 2 + 2 * 2 + 2 * 8), 4);
}

TEST(VisibleLines, FadeWhereFacesAreNarrow) {
  const auto darkest = [](int columns) {
    const PolyMesh grid = testing::plane_grid(columns, columns);
    const Scene scene = scene_of(grid, white(grid), seen_from(-90, 90));
    double opacity = 0;
    for (const auto& [style, lines] :
         visible_lines(scene, DepthBuffer(scene, 100, 100, 2), {.contours = false})) {
      opacity = std::max(opacity, style.opacity);
    }
    return opacity;
  };
  EXPECT_EQ(darkest(4), 1);
  EXPECT_LT(darkest(40), 0.6);
  EXPECT_EQ(darkest(100), 0) << "no line of a pixel's width";
}

TEST(VisibleLines, AreNoneWhereTheyAreOff) {
  const Scene scene = scene_of(cube(), white(cube()), seen_from(-60, 30));
  const DepthBuffer buffer(scene, 100, 100, 2);
  EXPECT_TRUE(visible_lines(scene, buffer, {.edges = false, .contours = false}).empty());
}

}  // namespace
}  // namespace surfmesh
