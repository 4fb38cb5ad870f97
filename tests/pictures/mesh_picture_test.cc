// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/mesh_picture.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "support/meshes.hh"

namespace surfmesh {
namespace {

/// n × n squares of the plane, cut in two, at heights of a function.
template <class Height>
PolyMesh net(int n, Height height) {
  PolyMesh mesh = testing::plane_grid(n, n);
  for (const VertexHandle vh : mesh.vertices()) {
    const auto& p = mesh.point(vh);
    mesh.set_point(vh, {p[0], p[1], height(p[0], p[1])});
  }
  return mesh;
}

std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(EdgeLines, RunThroughEveryEdgeOnce) {
  const PolyMesh mesh = net(12, [](double, double) { return 0.0; });
  const auto at = [](VertexHandle vh) { return PicturePoint{double(vh.idx()), 0}; };
  std::set<std::pair<int, int>> drawn;
  std::size_t steps = 0;
  const auto lines = edge_lines(mesh, at);
  for (const auto& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i, ++steps) {
      drawn.insert(std::minmax(int(line[i - 1].x), int(line[i].x)));
    }
  }
  EXPECT_EQ(steps, mesh.n_edges());
  EXPECT_EQ(drawn.size(), mesh.n_edges());
  EXPECT_LT(lines.size(), mesh.n_edges() / 4);
}

TEST(PlaneView, FitsARectangleIntoItsFrame) {
  const PlaneView view({Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 1)}, {{10, 20}, 100, 100});
  EXPECT_EQ(view.scale(), 50);
  EXPECT_EQ(view(-1, 0).x, 10);
  EXPECT_EQ(view(1, 0).x, 110);
  EXPECT_EQ(view(0, 0).y, 95);  // in the middle, upwards
  EXPECT_EQ(view(0, 1).y, 45);
}

TEST(DrawSurface, DrawsWhatIsSeenOfTheAskedPart) {
  const PolyMesh flat = net(10, [](double, double) { return 0.0; });
  const PictureFrame frame{{0, 0}, 200, 100};
  const auto faces_in = [&](const PolyMesh& mesh, const Vec3& upper) {
    Svg svg(200, 100);
    draw_surface(svg, mesh, {.camera = {.azimuth = -90, .elevation = 90}, .part = {-upper, upper}},
                 frame);
    return count_of(svg.text(), "z");
  };
  EXPECT_EQ(faces_in(flat, Vec3(10, 10, 9)), 200U);
  // The frame reaches columns to 6 and rows to 4, and one more of each touches it.
  EXPECT_EQ(faces_in(flat, Vec3(4, 4, 9)), 2U * 7 * 5);
  EXPECT_EQ(faces_in(flat, Vec3(0.5, 0.5, 9)), 0U);
  // The far side of a steep roof is not seen.
  const PolyMesh roof = net(10, [](double, double y) { return -5 * std::abs(y - 5); });
  Svg svg(200, 100);
  draw_surface(svg, roof, {.camera = {.azimuth = -90}, .part = {Vec3(0, 0, -99), Vec3(10, 10, 9)}},
               frame);
  EXPECT_EQ(count_of(svg.text(), "z"), 100U);
}

TEST(DrawSurface, DrawsFromBackToFront) {
  // A flat sheet in front of a steep one, which is turned from the light.
  const PolyMesh steps = net(40, [](double x, double y) { return y < 20 ? 0.0 : 120 - 3 * x; });
  Svg svg(400, 300);
  draw_surface(svg, steps,
               {.camera = {.azimuth = -90}, .part = {Vec3(0, 0, -9), Vec3(40, 40, 130)}},
               {{0, 0}, 400, 300});
  const std::string text = svg.text();
  const auto shade_at = [&](std::size_t at) {
    return std::stoi(text.substr(text.find("fill=\"#", at) + 7, 2), nullptr, 16);
  };
  const int first = shade_at(text.find("<path")), last = shade_at(text.rfind("<path"));
  EXPECT_LT(first, last - 20) << "the steep sheet is behind";
}

TEST(DrawSurface, OfNothingDrawsNothing) {
  Svg svg(10, 10);
  draw_surface(svg, PolyMesh(), {.part = {Vec3(0, 0, 0), Vec3(1, 1, 1)}}, {{0, 0}, 10, 10});
  EXPECT_EQ(svg.text(), Svg(10, 10).text());
}

}  // namespace
}  // namespace surfmesh
