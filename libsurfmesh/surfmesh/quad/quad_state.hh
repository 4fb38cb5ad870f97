// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "surfmesh/core/face_editor.hh"
#include "surfmesh/quad/quad_geometry.hh"

namespace surfmesh {

/// A change of a mesh of quads: faces that go, the faces in their place, vertices that come or go.
struct Replacement {
  std::vector<FaceHandle> old;
  FaceCycles fresh;
  std::vector<VertexHandle> added;    ///< by FaceEditor::add_vertex
  std::vector<VertexHandle> removed;  ///< that only old faces have
  /// Vertices that get a place between others before anything is smoothed.
  struct Middle {
    VertexHandle vertex;
    std::vector<VertexHandle> others;
  };
  std::vector<Middle> middles;

  void clear() {
    old.clear();
    fresh.clear();
    added.clear();
    removed.clear();
    middles.clear();
  }
};

/// A mesh of quads while it is cleaned, with what is known of its faces and vertices.
struct QuadState {
  PolyMesh& mesh;
  FaceEditor& editor;
  QuadGeometry& geometry;
  std::vector<FaceMeasure> measures;  ///< by face
  std::vector<int> counts;            ///< by vertex: its faces
  std::vector<int> wanted;            ///< by vertex: the faces that fit best; 4 beyond its end

  /// `wanted_counts` are those of the first vertices.
  QuadState(PolyMesh& quads, FaceEditor& quad_editor, QuadGeometry& places,
            std::vector<int> wanted_counts);

  int count(VertexHandle vh) const { return counts[index(vh)]; }

  /// The faces a vertex has more than fit best.
  int excess(VertexHandle vh) const {
    return count(vh) - (index(vh) < wanted.size() ? wanted[index(vh)] : 4);
  }

  bool is_boundary(VertexHandle vh) const { return mesh.is_boundary(vh); }
};

}  // namespace surfmesh
