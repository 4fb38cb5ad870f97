// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pictures/mesh_picture.hh"
#include "pictures/paint_order.hh"
#include "support/meshes.hh"

/// Meshes whose pictures are known.
namespace surfmesh::testing {

inline constexpr Rgb kRed = {0.8, 0.2, 0.2}, kBlue = {0.2, 0.2, 0.8}, kGreen = {0.2, 0.8, 0.2};

/// A cube of six quads from -half to half: the faces at -x, x, -y, y, -z and z.
inline PolyMesh cube(double half = 1) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) {
    points.push_back(half * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  return mesh_of(
      points, {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

/// Two squares that cross at the z axis: from -y, the first is in front where x < 0.
inline PolyMesh crossing_squares() {
  return mesh_of({{-1, -1, -1},
                  {1, 1, -1},
                  {1, 1, 1},
                  {-1, -1, 1},
                  {-1, 1, -1},
                  {1, -1, -1},
                  {1, -1, 1},
                  {-1, 1, 1}},
                 {{0, 1, 2, 3}, {4, 5, 6, 7}});
}

/// Seen from a side, everything fills a square.
inline SpaceView seen_from(double azimuth, double elevation) {
  SpaceView view;
  view.camera = {.azimuth = azimuth, .elevation = elevation};
  return view;
}

/// A scene in a square of 100 pixels.
inline Scene scene_of(const PolyMesh& mesh, const std::vector<Rgb>& colours,
                      const SpaceView& view) {
  return scene_in_space(mesh, {colours}, view, {{0, 0}, 100, 100});
}

/// Scenes need not come from meshes: triangles in pixels and depths.
inline Scene scene_of_triangles(const std::vector<std::array<ScenePoint, 3>>& triangles) {
  Scene scene;
  for (const auto& corners : triangles) {
    const int first = static_cast<int>(scene.points.size());
    scene.points.insert(scene.points.end(), corners.begin(), corners.end());
    scene.triangles.push_back(
        {{first, first + 1, first + 2}, static_cast<PackedRgb>(scene.triangles.size() + 1)});
  }
  return scene;
}

}  // namespace surfmesh::testing
