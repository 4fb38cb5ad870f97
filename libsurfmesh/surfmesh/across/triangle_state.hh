// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/across/vertex_chart.hh"
#include "surfmesh/core/face_editor.hh"

namespace surfmesh {

/// An inner edge of a mesh of triangles and the two corners beside it.
struct EdgeSurroundings {
  HalfedgeHandle halfedge, opposite;
  VertexHandle origin, tip, left, right;
};

/// Triangles on several patches while they are improved.
struct TriangleState {
  PolyMesh& mesh;
  FaceEditor& editor;
  std::vector<VertexChart>& charts;  ///< by vertex
  ChartMaker& maker;
  std::vector<char> is_border = {};  ///< by vertex; others are beyond its end

  /// Charts are those of the vertices of the mesh.
  TriangleState(PolyMesh& triangles, FaceEditor& triangle_editor,
                std::vector<VertexChart>& vertex_charts, ChartMaker& chart_maker)
      : mesh(triangles), editor(triangle_editor), charts(vertex_charts), maker(chart_maker) {
    for (const VertexHandle vh : mesh.vertices()) is_border.push_back(mesh.is_boundary(vh));
  }

  const VertexChart& chart(VertexHandle vh) const { return charts[index(vh)]; }

  bool is_at_border(VertexHandle vh) const {
    return index(vh) < is_border.size() && is_border[index(vh)] != 0;
  }

  bool is_inner(EdgeHandle eh) const {
    return !mesh.is_boundary(mesh.halfedge_handle(eh, 0)) &&
           !mesh.is_boundary(mesh.halfedge_handle(eh, 1));
  }

  /// Pre      the edge is an inner one
  EdgeSurroundings around(EdgeHandle eh) const {
    const HalfedgeHandle a = mesh.halfedge_handle(eh, 0), b = mesh.halfedge_handle(eh, 1);
    return {a,
            b,
            mesh.to_vertex_handle(b),
            mesh.to_vertex_handle(a),
            mesh.to_vertex_handle(mesh.next_halfedge_handle(a)),
            mesh.to_vertex_handle(mesh.next_halfedge_handle(b))};
  }

  /// True if a new edge may join two vertices. Two of the border may be joined elsewhere.
  bool may_join(VertexHandle a, VertexHandle b) const {
    if (a == b || (is_at_border(a) && is_at_border(b))) return false;
    for (const VertexHandle vh : mesh.vv_range(a)) {
      if (vh == b) return false;
    }
    return true;
  }

  /// True if a vertex may have one triangle less.
  bool can_lose_triangle(VertexHandle vh) const { return is_at_border(vh) || mesh.valence(vh) > 3; }

  void set_chart(VertexHandle vh, const VertexChart& chart) {
    if (index(vh) >= charts.size()) charts.resize(mesh.n_vertices());
    charts[index(vh)] = chart;
  }
};

}  // namespace surfmesh
