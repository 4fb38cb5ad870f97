// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh::detail {

/// Corners of a face of a patch: triangles and quads.
inline constexpr std::size_t kMostCorners = 4;

/// What a corner of the result holds, as its patch sees it.
struct CornerValue {
  Uv uv;
  Metric metric;
};

/// A corner of a face, and the contour of the side from it to the next corner.
struct LooseCorner {
  int vertex = -1;   ///< of the result
  int contour = -1;  ///< -1 inside the patch
  CornerValue value;
};

/// A face that is no copy of one of the piece's mesh: one of the fan around a pole, or a quad of
/// which two corners are one vertex of the result.
struct LooseFace {
  std::array<LooseCorner, kMostCorners> corners;
  std::size_t count = 0;
  int number = -1;  ///< among the faces of its piece
};

/// A face of a piece's mesh that is not copied, for two of its corners are one vertex of the
/// result.
struct CollapsedFace {
  FaceHandle face;
  bool is_dropped = false;  ///< less than a triangle is left
  int dropped_so_far = 0;   ///< how many are dropped up to this one
};

/// An edge of a piece's mesh that is not copied with its two sides.
struct BorderEdge {
  EdgeHandle edge;
  HalfedgeHandle side;  ///< of a face that is copied; invalid if there is none
};

/// A side of a face that is glued to others by its vertices: at the border of its piece, or of a
/// loose face.
struct BorderSide {
  int from = -1;     ///< vertex of the result
  int to = -1;       ///< vertex of the result
  int contour = -1;  ///< -1 inside the patch
  int patch = -1;
};

/// The vertex of the result for each of a piece's mesh: the piece's own vertices have numbers in a
/// row.
class PieceVertices {
 public:
  PieceVertices(const PatchBoundary& boundary, std::size_t vertex_count, int first_own)
      : border_(boundary_vertices(boundary)), end_of_own_(first_own) {
    for (int& vertex : border_) {
      if (vertex < 0) vertex = end_of_own_++;
    }
    const int border_count = static_cast<int>(border_.size());
    offset_ = end_of_own_ - border_count;
    end_of_own_ += static_cast<int>(vertex_count) - border_count;
  }

  int operator()(VertexHandle vh) const {
    return index(vh) < border_.size() ? border_[index(vh)] : vh.idx() + offset_;
  }

  /// Nodes of the loops, the first vertices of the mesh.
  std::size_t border_count() const { return border_.size(); }

  /// The number after the piece's own ones.
  int end_of_own() const { return end_of_own_; }

  /// Give all of them new numbers; those of own vertices are less by `fewer`.
  template <class NewNumber>
  void renumber(NewNumber new_number, int fewer) {
    for (int& vertex : border_) vertex = new_number(vertex);
    offset_ -= fewer;
    end_of_own_ -= fewer;
  }

 private:
  std::vector<int> border_;
  int offset_ = 0;
  int end_of_own_ = 0;
};

/// How many elements a result has, or a part of it.
struct ElementCounts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
};

/// A patch, or a part of one, on its way into the result: its mesh, and how its faces are to be
/// joined to others. What lies inside is a copy of the mesh, with edges at other places.
struct Piece {
  int number = 0;  ///< among all pieces
  PatchMesh source;
  bool is_turned = false;  ///< its faces go around the other way in the result
  PieceVertices vertices;

  // By survey_border
  std::vector<BorderEdge> border_edges = {};  ///< ascending
  std::vector<CollapsedFace> collapsed = {};  ///< ascending
  std::vector<LooseFace> loose_faces = {};
  int face_count = 0;  ///< in the result
  /// Those of the border edges, in their order, then those of the loose faces.
  std::vector<BorderSide> sides = {};

  // By number_elements
  int first_edge = 0;  ///< of the copied ones in the result
  int first_face = 0;  ///< in the result

  // By give_halfedges
  std::span<const HalfedgeHandle> halfedges = {};  ///< of the result, by side

  // By place_edges
  std::vector<int> edge_places = {};  ///< by edge, the number that its halfedge 0 gets

  int copied_edge_count() const {
    return static_cast<int>(source.mesh->n_edges() - border_edges.size());
  }
};

}  // namespace surfmesh::detail
