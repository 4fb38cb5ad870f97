// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "support/metric_fields.hh"
#include "support/quad_meshes.hh"
#include "surfmesh/core/face_editor.hh"
#include "surfmesh/quad/patch_geometry.hh"

namespace surfmesh::testing {

/// A patch of unit squares with its boundary first, ready to be changed.
struct GridPatch {
  GridNumbers number;
  PolyMesh mesh;
  FunctionField field;
  FaceEditor editor{mesh};
  PatchGeometry geometry{mesh, field, number.fixed()};

  GridPatch(int columns, int rows, FunctionField metrics = constant_field({1, 0, 1}))
      : number(columns, rows),
        mesh(with_places(quad_grid(number), metrics)),
        field(std::move(metrics)) {}
  GridPatch(const GridPatch&) = delete;
  GridPatch& operator=(const GridPatch&) = delete;

  VertexHandle vertex(int i, int j) const { return number(i, j); }
  FaceHandle face(int i, int j) const { return FaceHandle(j * number.columns() + i); }
  HalfedgeHandle halfedge(VertexHandle from, VertexHandle to) const {
    return halfedge_between(mesh, from, to);
  }

  Uv uv(VertexHandle vh) const { return mesh.property(require(mesh, keys::vertex_uv), vh); }
  const Metric& metric(VertexHandle vh) const {
    return mesh.property(require(mesh, keys::vertex_metric), vh);
  }

  /// Put a vertex somewhere, with the metric there.
  void put(VertexHandle vh, Uv at) {
    QueryHint hint;
    mesh.property(require(mesh, keys::vertex_uv), vh) = at;
    mesh.property(require(mesh, keys::vertex_metric), vh) = field.at(at, hint);
  }

  std::vector<Uv> positions() const {
    std::vector<Uv> result;
    for (const VertexHandle vh : mesh.vertices()) result.push_back(uv(vh));
    return result;
  }

 private:
  static PolyMesh with_places(PolyMesh mesh, const MetricField& metrics) {
    attach_places(mesh, metrics);
    return mesh;
  }
};

/// The bound of moves that may make everything worse.
inline constexpr int kAny = std::numeric_limits<int>::max();

/// The wanted numbers of faces at the vertices of the boundary.
inline std::vector<int> wanted_of(const GridPatch& patch) {
  std::vector<int> wanted(patch.number.fixed(), 2);
  const int m = patch.number.columns(), n = patch.number.rows();
  for (const auto& [i, j] : {std::pair{0, 0}, {m, 0}, {m, n}, {0, n}}) {
    wanted[index(patch.vertex(i, j))] = 1;
  }
  return wanted;
}

/// Least scaled Jacobian of the faces that are in use.
inline double least_jacobian(const GridPatch& patch) {
  double least = 1;
  for (std::size_t f = 0; f < patch.editor.face_bound(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    if (!patch.editor.is_used(fh)) continue;
    least = std::min(least, patch.geometry.measure(fh).least_jacobian);
  }
  return least;
}

}  // namespace surfmesh::testing
