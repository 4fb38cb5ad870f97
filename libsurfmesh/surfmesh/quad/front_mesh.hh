// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/core/face_editor.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/quad/patch_geometry.hh"

namespace surfmesh {

/// The four corners of a quad, counter-clockwise.
using QuadCycle = std::array<VertexHandle, 4>;

using VertexPair = std::array<VertexHandle, 2>;

/// The triangles of a patch while they are converted to quads from the fronts on.
///
/// A front halfedge has a triangle on its side, and a quad or the open boundary on the other. All
/// faces are strictly convex in (u,v), and every change keeps them so. The first `fixed` vertices
/// are those of the boundary and stay where they are.
///
/// As a geometry, only corners of quads have an energy, and no move inverts a face.
///
/// Reads, writes  surf:uv, surf:metric (vertex)
class FrontMesh : public PatchGeometry {
 public:
  /// Mesh, editor and field must outlive this.
  FrontMesh(PolyMesh& mesh, FaceEditor& editor, const MetricField& field, std::size_t fixed)
      : PatchGeometry(mesh, field, fixed),
        mesh_(mesh),
        editor_(editor),
        uv_(require(mesh, keys::vertex_uv)),
        metric_(require(mesh, keys::vertex_metric)) {}

  // --- geometry ---

  const PolyMesh& mesh() const { return mesh_; }
  Uv uv(VertexHandle vh) const { return mesh_.property(uv_, vh); }
  const Metric& metric(VertexHandle vh) const { return mesh_.property(metric_, vh); }

  bool collect(VertexHandle vh, std::vector<CornerTerms>& star) const override;
  bool move(VertexHandle vh, ChartStep step) override;

  /// The least scaled Jacobian of the corners of a quad, each in the metric there.
  double least_jacobian(const QuadCycle& cycle) const;

  /// True if a face is strictly convex.
  bool is_valid(FaceHandle fh) const;

  /// The faces around a vertex that are not.
  int count_invalid(VertexHandle vh) const;

  /// Move a vertex, or half, a quarter, an eighth of the way, so that no face around is inverted.
  /// Returns  false if it stays
  bool move_towards(VertexHandle vh, Uv target);

  // --- fronts ---

  bool is_triangle(FaceHandle fh) const;
  bool is_front(HalfedgeHandle heh) const;

  /// The front halfedge that follows, or goes before, along the triangles at a vertex.
  /// Pre      the halfedge is a front halfedge
  HalfedgeHandle next_front(HalfedgeHandle heh) const;
  HalfedgeHandle previous_front(HalfedgeHandle heh) const;

  /// True if a vertex is not fixed and has only triangles.
  bool is_untouched(VertexHandle vh) const;

  /// The halfedge between two vertices; invalid if they are not joined.
  HalfedgeHandle find_halfedge(VertexHandle from, VertexHandle to) const;

  // --- changes of triangles ---

  /// True if there are triangles on both sides that form a strictly convex quadrilateral.
  bool can_flip(EdgeHandle eh) const;
  void flip(EdgeHandle eh) { surfmesh::flip(mesh_, eh); }

  /// Join two vertices by an edge, by swaps of the edges that lie between.
  /// Returns  false if there is a quad, the boundary or a vertex between them; some edges may be
  ///          swapped then
  /// Cost     O(edges between them)
  bool connect(VertexHandle from, VertexHandle to);

  /// Put a new vertex on the edge between two triangles, at a share of it.
  VertexHandle split(HalfedgeHandle heh, double share);

  /// Merge a vertex that is untouched into another one beside it.
  /// Returns  false, and does nothing, if a triangle would be inverted
  bool absorb(VertexHandle vh, VertexHandle into);

  /// Swap the edges of the triangles at a vertex where that makes them better in the metric.
  void swap_around(VertexHandle vh);

  // --- quads ---

  /// Put a quad in place of all triangles within its four sides.
  /// Returns  the quad; an invalid handle if a side is no edge or a front runs within the sides
  /// Cost     O(triangles within)
  FaceHandle make_quad(HalfedgeHandle base, const QuadCycle& cycle);

  /// Close a gap of two triangles by merging the corner of a front halfedge's origin into the
  /// opposite one.
  /// Returns  the vertex of both; invalid, with nothing done, if there is no such gap, the vertex
  ///          is fixed, or two vertices would be joined twice
  VertexHandle close_gap(HalfedgeHandle heh);

  /// Sew a front halfedge and the one before it together where one triangle lies between: merge
  /// their free ends.
  /// Returns  as close_gap()
  VertexHandle sew(HalfedgeHandle heh);

  /// Take a front halfedge's origin away that has one quad and two triangles: one quad of other
  /// corners goes in their place.
  /// Returns  the quad, which may be inverted; invalid, with nothing done, if the vertex is fixed
  ///          or has other faces
  FaceHandle drop_corner(HalfedgeHandle heh);

  /// Close a gap of two triangles by two quads, where one would be straight at the boundary: the
  /// origin of the front halfedge, which is fixed, gets an edge to a neighbour of the corner
  /// opposite, which is split in two along it.
  /// Returns  both parts of that corner, between which faces may be inverted; invalid, with nothing
  ///          done, if there is no such gap or no such edge
  VertexPair open_corner(HalfedgeHandle heh);

  /// True if a side of a quad is beside a gap of two triangles that one quad cannot close: it
  /// would be straight or reflex at a fixed vertex.
  bool leaves_straight_gap(FaceHandle quad) const;

  /// Undo the last make_quad(), drop_corner(), close_gap(), sew() or open_corner(), or agree with
  /// it for good. One of both must come before any other change of faces.
  void undo();
  void keep();

 private:
  bool is_convex_at(HalfedgeHandle heh) const;
  HalfedgeHandle crossed_from(VertexHandle from, Uv to) const;
  bool collect_crossed(VertexHandle from, VertexHandle to);
  bool collect_within(HalfedgeHandle base, const std::array<HalfedgeHandle, 4>& sides);
  void collect_enclosed(const QuadCycle& cycle);
  void dissolve(QuadCycle& cycle, std::size_t corner);
  void replace_corner(HalfedgeHandle heh, VertexHandle by);
  bool has_corner(FaceHandle fh, VertexHandle vh) const;
  VertexHandle merge(VertexHandle from, VertexHandle into);
  /// The vertex opposite the origin of a front halfedge between four fronts; invalid if there are
  /// others. Between these fronts may lie more than two triangles.
  VertexHandle opposite_in_gap(HalfedgeHandle heh) const;
  VertexHandle opposite_in_gap_of_two(HalfedgeHandle heh) const;
  bool is_worth_swapping(EdgeHandle eh) const;
  double quality(VertexHandle a, VertexHandle b, VertexHandle c) const;

  PolyMesh& mesh_;
  FaceEditor& editor_;
  decltype(keys::vertex_uv)::Handle uv_;
  decltype(keys::vertex_metric)::Handle metric_;
  // Scratch space:
  std::vector<EdgeHandle> crossed_;
  std::vector<FaceHandle> faces_, made_;
  std::vector<VertexHandle> enclosed_;  ///< vertices that have lost their faces
  VertexHandle added_;                  ///< by the last change, if it can be undone
  std::vector<VertexHandle> cycle_;
  std::vector<EdgeHandle> edges_;
  FaceCycles fresh_;
};

}  // namespace surfmesh
