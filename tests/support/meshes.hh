// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh::testing {

/// A mesh from points and index triples.
template <class Mesh = PolyMesh>
Mesh mesh_of(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& faces) {
  Mesh mesh;
  for (const Vec3& point : points) mesh.add_vertex(to_openmesh(point));
  for (const std::vector<int>& face : faces) {
    std::vector<VertexHandle> corners;
    for (const int i : face) corners.push_back(VertexHandle(i));
    mesh.add_face(corners);
  }
  return mesh;
}

/// Give a flat result mesh the corner properties: (u,v) is (x,y), one metric, patch 0.
inline void attach_plane_properties(PolyMesh& mesh, const Metric& metric = {1, 0, 1}) {
  const auto uv = attach(mesh, keys::corner_uv);
  attach(mesh, keys::corner_metric, metric);
  attach(mesh, keys::face_patch, 0);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    const Vec3 point = to_eigen(mesh.point(mesh.to_vertex_handle(heh)));
    mesh.property(uv, heh) = {point.x(), point.y()};
  }
}

/// The plane [0, columns] × [0, rows], unit squares cut along their rising diagonals, with corner
/// properties.
inline PolyMesh plane_grid(int columns, int rows, const Metric& metric = {1, 0, 1}) {
  std::vector<Vec3> points;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) points.push_back({1.0 * i, 1.0 * j, 0});
  }
  std::vector<std::vector<int>> faces;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, d = a + columns + 1, c = d + 1;
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  }
  PolyMesh mesh = mesh_of(points, faces);
  attach_plane_properties(mesh, metric);
  return mesh;
}

/// A fan of `count` triangles around the origin with radius 1, with corner properties. Of six
/// triangles all are equilateral.
inline PolyMesh disc(int count, const Metric& metric = {1, 0, 1}) {
  std::vector<Vec3> points = {Vec3::Zero()};
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    faces.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  PolyMesh mesh = mesh_of(points, faces);
  attach_plane_properties(mesh, metric);
  return mesh;
}

/// The closed octahedron with corners on the axes, oriented outwards, without properties.
template <class Mesh = PolyMesh>
Mesh octahedron() {
  const std::vector<Vec3> points = {{1, 0, 0},  {0, 1, 0}, {-1, 0, 0},
                                    {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  return mesh_of<Mesh>(
      points,
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

}  // namespace surfmesh::testing
