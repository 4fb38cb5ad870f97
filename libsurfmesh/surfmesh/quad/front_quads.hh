// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/quad/front_edge.hh"
#include "surfmesh/quad/front_parity.hh"

namespace surfmesh {

/// Makes single quads at fronts. What it makes is strictly convex, and leaves no region of an odd
/// number of triangles.
class FrontQuads {
 public:
  FrontQuads(FrontMesh& mesh, bool has_odd_loops) : mesh_(mesh), parity_(mesh, has_odd_loops) {}

  /// Merge the triangle at a front edge with a neighbour, after a swap of one of their edges where
  /// that makes a better quad.
  ///
  /// Returns  the quad; an invalid handle if there is none of the least scaled Jacobian asked for
  /// Source   Lee and Lo, A new scheme for the generation of a graded quadrilateral mesh (1994)
  FaceHandle merge(const FrontEdge& edge, double least_jacobian);

  /// Put a quad on a front edge: find its side edges, recover its top edge, and take up the
  /// triangles between.
  ///
  /// A side edge is the front edge at that end, or one to the vertex nearest to where a unit square
  /// has its corner: over an edge, or a swapped one, or to a new vertex. A vertex that no quad has
  /// yet is moved to that place.
  ///
  /// Returns  the quad; an invalid handle if there is none of the least scaled Jacobian asked for;
  ///          the triangles may be changed then
  /// Source   Owen, Staten, Canann, Saigal, Q-Morph: an indirect approach to advancing front quad
  ///          meshing (1999)
  FaceHandle advance(const FrontEdge& edge, double least_jacobian);

  /// Merge the two triangles and the one quad at the origin of a front halfedge.
  ///
  /// Such a vertex has a reflex angle before it, or will have a quad that is nearly straight there.
  /// The quad may be inverted, and can be undone.
  FaceHandle drop_corner(HalfedgeHandle heh);

 private:
  /// A quad of two triangles, after a swap.
  struct Merger {
    double score;
    EdgeHandle swapped;  ///< invalid if there is none
    QuadCycle cycle;
  };
  /// A vertex for the end of a side edge.
  struct SideTip {
    VertexHandle vertex;
    double distance;     ///< from where it should be
    EdgeHandle swapped;  ///< to reach it, if it is not joined yet
  };
  enum class End { From, To };

  FaceHandle make(HalfedgeHandle base, const QuadCycle& cycle, double least_jacobian);

  // merge():
  void collect_mergers(const FrontEdge& edge, End end);
  void add_merger(const FrontEdge& edge, EdgeHandle swapped, const QuadCycle& cycle);
  VertexHandle apex_beyond(HalfedgeHandle heh) const;
  QuadCycle cycle_at(const FrontEdge& edge, End end, VertexHandle side, VertexHandle top) const;

  // advance():
  VertexHandle side_tip(const FrontEdge& edge, End end, VertexHandle taken, EdgeHandle kept);
  void collect_fan(const FrontEdge& edge, End end);
  void collect_tips(const FrontEdge& edge, End end, Uv place, EdgeHandle kept);
  VertexHandle split_towards(const FrontEdge& edge, const FrontEnd& end, Uv place, EdgeHandle kept);

  FrontMesh& mesh_;
  FrontParity parity_;
  std::vector<Merger> mergers_;
  std::vector<HalfedgeHandle> fan_;  ///< sides of the triangles at an end, opposite to it
  std::vector<SideTip> tips_;
};

}  // namespace surfmesh
