// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "support/meshes.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/metric/metric_field.hh"

/// Meshes of quads in the plane, with parameters and metrics on vertices.
namespace surfmesh::testing {

/// Give the vertices of a flat mesh (u,v), which is (x,y), and the metric of a field there.
inline void attach_places(PolyMesh& mesh, const MetricField& field) {
  const auto uv = attach(mesh, keys::vertex_uv);
  const auto metric = attach(mesh, keys::vertex_metric);
  QueryHint hint;
  for (const VertexHandle vh : mesh.vertices()) {
    const Vec3 point = to_eigen(mesh.point(vh));
    mesh.property(uv, vh) = {point.x(), point.y()};
    mesh.property(metric, vh) = field.at(mesh.property(uv, vh), hint);
  }
}

/// The numbers of the vertices of columns × rows squares: those of the boundary come first,
/// counter-clockwise from the corner (0,0) on, as in a patch; then row by row.
class GridNumbers {
 public:
  GridNumbers(int columns, int rows) : columns_(columns), rows_(rows) {
    for (int i = 0; i < columns; ++i) add(i, 0);
    for (int j = 0; j < rows; ++j) add(columns, j);
    for (int i = columns; i > 0; --i) add(i, rows);
    for (int j = rows; j > 0; --j) add(0, j);
    fixed_ = places_.size();
    for (int j = 1; j < rows; ++j) {
      for (int i = 1; i < columns; ++i) add(i, j);
    }
  }

  VertexHandle operator()(int i, int j) const {
    for (std::size_t v = 0; v < places_.size(); ++v) {
      if (places_[v] == std::array{i, j}) return VertexHandle(static_cast<int>(v));
    }
    return VertexHandle();
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t fixed() const { return fixed_; }  ///< vertices of the boundary
  const std::vector<std::array<int, 2>>& places() const { return places_; }

 private:
  void add(int i, int j) { places_.push_back({i, j}); }

  int columns_, rows_;
  std::size_t fixed_ = 0;
  std::vector<std::array<int, 2>> places_;  ///< by vertex
};

/// Unit squares on [0, columns] × [0, rows], face j · columns + i at (i, j), without properties.
inline PolyMesh quad_grid(const GridNumbers& number) {
  std::vector<Vec3> points;
  for (const auto& [i, j] : number.places()) points.push_back({1.0 * i, 1.0 * j, 0});
  std::vector<std::vector<int>> faces;
  for (int j = 0; j < number.rows(); ++j) {
    for (int i = 0; i < number.columns(); ++i) {
      faces.push_back({number(i, j).idx(), number(i + 1, j).idx(), number(i + 1, j + 1).idx(),
                       number(i, j + 1).idx()});
    }
  }
  return mesh_of(points, faces);
}

/// The halfedge from one vertex to another; invalid if there is none.
inline HalfedgeHandle halfedge_between(const PolyMesh& mesh, VertexHandle from, VertexHandle to) {
  for (const HalfedgeHandle heh : mesh.voh_range(from)) {
    if (mesh.to_vertex_handle(heh) == to) return heh;
  }
  return HalfedgeHandle();
}

/// The vertices of a face, from its halfedge on.
inline std::vector<VertexHandle> cycle_of(const PolyMesh& mesh, FaceHandle fh) {
  std::vector<VertexHandle> cycle;
  for (const VertexHandle vh : mesh.fv_range(fh)) cycle.push_back(vh);
  return cycle;
}

}  // namespace surfmesh::testing
