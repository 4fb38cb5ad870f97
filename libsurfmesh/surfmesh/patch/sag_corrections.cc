// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/sag_corrections.hh"

#include <algorithm>
#include <array>
#include <vector>

#include "surfmesh/geometry/predicates.hh"
#include "surfmesh/patch/corner_triangles.hh"
#include "surfmesh/patch/sag_meter.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh::detail {
namespace {

constexpr int kMostCorrections = 8;

/// Beside half of the triangles of a patch, so many may be corrected.
constexpr std::size_t kFreeFaces = 20;

/// Shape (1 for an equilateral triangle) below which a swap or a node must not lead, unless it was
/// worse before.
constexpr double kLeastShape = 0.3;

/// Shape below which no node must lead at all.
constexpr double kLeastSplitShape = 0.2;

/// Shares of the way to the middle of its triangle by which a node is moved, and the shape below
/// which that must not lead, unless it was worse before.
constexpr std::array<double, 2> kMovedShares = {0.25, 0.5};
constexpr double kLeastMovedShape = 0.5;

/// Ratio of the sags after and before from which a node is worth it.
constexpr double kLeastReduction = 0.99;

/// Shares of an edge between which a bend is sought, and the first and last steps of the search.
constexpr double kFirstBend = 0.05, kLastBend = 0.95;
constexpr double kFirstBendStep = 0.125, kLastBendStep = 0.002;

/// Least gain of shape for which an edge is swapped or a node moved.
constexpr double kLeastCorrectionGain = 0.01;

/// Nodes whose triangles all have this shape stay where they are.
constexpr double kGoodShape = 0.6;

/// Corrects the triangles of one patch.
class SagCorrector {
 public:
  SagCorrector(TriangulatedPatch& patch, double aim, const RunContext& context)
      : patch_(patch),
        delaunay_(*patch.delaunay),
        aim_(aim),
        context_(context),
        meter_(*patch.surface, aim) {}

  SagCorrections run() {
    boundary_count_ = boundary_vertices(patch_.boundary).size();
    measure_new_faces();
    const std::size_t limit = kFreeFaces + delaunay_.n_faces() / 2;
    for (int round = 0; round < kMostCorrections; ++round) {
      const std::vector<FaceHandle> far = far_faces();
      // Where most triangles are too far the sizes are to blame, or hmin is in the way.
      if (far.empty() || far.size() > limit || result_.nodes > limit) break;
      const SagCorrections before = result_;
      for (const FaceHandle fh : far) {
        context_.throw_if_cancelled();
        correct(fh);
      }
      if (result_.swaps == before.swaps && result_.nodes == before.nodes) break;
    }
    return result_;
  }

 private:
  const PolyMesh& mesh() const { return delaunay_.mesh(); }

  double& sag(FaceHandle fh) { return sags_[index(fh)]; }

  double sag_now(FaceHandle fh) const {
    const TriangleVertices v = vertices(mesh(), fh);
    double sag = meter_.sag_of(
        CornerTriangle{corner_of(patch_, v[0]), corner_of(patch_, v[1]), corner_of(patch_, v[2])});
    for (const EdgeHandle eh : inner_edges(patch_, fh)) {
      sag = std::max(sag, meter_.ridge_sag(diamond_of(patch_, eh).triangles(), kSharpCosine));
    }
    return sag;
  }

  void measure_new_faces() {
    while (sags_.size() < delaunay_.n_faces()) {
      if (sags_.size() % kSearchesBetweenCancellation == 0) context_.throw_if_cancelled();
      sags_.push_back(sag_now(FaceHandle(static_cast<int>(sags_.size()))));
    }
  }

  std::vector<FaceHandle> far_faces() const {
    std::vector<FaceHandle> faces;
    for (std::size_t f = 0; f < sags_.size(); ++f) {
      if (sags_[f] > aim_) faces.emplace_back(static_cast<int>(f));
    }
    return faces;
  }

  void flip(EdgeHandle eh) {
    delaunay_.flip(eh);
    for (const unsigned int side : {0u, 1u}) {
      const FaceHandle fh = mesh().face_handle(mesh().halfedge_handle(eh, side));
      sag(fh) = sag_now(fh);
    }
    ++result_.swaps;
  }

  void correct(FaceHandle fh) {
    if (sag(fh) <= aim_) return;
    const std::vector<EdgeHandle> edges = inner_edges(patch_, fh);
    const bool is_swapped =
        std::any_of(edges.begin(), edges.end(), [this](EdgeHandle eh) { return swap_for_sag(eh); });
    if (!is_swapped && !move_for_sag(fh)) split_longest(edges);
  }

  /// Move an inner node of the face towards its middle if that brings all triangles around near
  /// enough: those beside have often room to spare.
  bool move_for_sag(FaceHandle fh) {
    const TriangleVertices corners = vertices(mesh(), fh);
    Uv middle{0, 0};
    for (const VertexHandle vh : corners) middle = middle + 1.0 / 3 * delaunay_.uv(vh);
    for (const double share : kMovedShares) {
      for (const VertexHandle vh : corners) {
        if (index(vh) < boundary_count_) continue;
        const PatchCorner now = corner_of(patch_, vh);
        const PatchCorner then = corner_at(patch_, lerp(now.uv, middle, share));
        if (!can_move(vh, now, then)) continue;
        move(vh, then);
        return true;
      }
    }
    return false;
  }

  /// True if no triangle around a node is turned, of a bad shape that was better before, or too
  /// far, were the node elsewhere.
  bool can_move(VertexHandle vh, const PatchCorner& now, const PatchCorner& then) const {
    const CornerTriangles moved = star_of(patch_, vh, then);
    return are_upright(moved) &&
           shape_of(moved) >= std::min(kLeastMovedShape, shape_of(star_of(patch_, vh, now))) &&
           meter_.holds(moved);
  }

  /// True if none is turned in the parameters.
  static bool are_upright(const CornerTriangles& triangles) {
    return std::all_of(triangles.begin(), triangles.end(), [](const CornerTriangle& t) {
      return orient2d(t[0].uv, t[1].uv, t[2].uv) > 0;
    });
  }

  /// Swap the edge if both new triangles are near enough and no worse in shape than is allowed.
  bool swap_for_sag(EdgeHandle eh) {
    if (!delaunay_.can_flip(eh)) return false;
    const Diamond diamond = diamond_of(patch_, eh);
    const double shape = shape_of(diamond.swapped());
    if (shape < kLeastShape && shape < shape_of(diamond.triangles())) return false;
    if (!meter_.holds(diamond.swapped())) return false;
    flip(eh);
    return true;
  }

  void swap_for_shape(EdgeHandle eh) {
    if (!is_inner(patch_, eh) || !delaunay_.can_flip(eh)) return;
    const Diamond diamond = diamond_of(patch_, eh);
    if (shape_of(diamond.swapped()) < shape_of(diamond.triangles()) + kLeastCorrectionGain) return;
    if (is_nearer(diamond.swapped(), diamond.triangles())) flip(eh);
  }

  /// Give a node to the middle of the longest edge where that helps, else to the ridge of a bend
  /// across one; without a node the sizes are to blame.
  void split_longest(std::vector<EdgeHandle> edges) {
    std::sort(edges.begin(), edges.end(), [this](EdgeHandle a, EdgeHandle b) {
      return squared_length(patch_, a) > squared_length(patch_, b);
    });
    for (const EdgeHandle eh : edges) {
      if (split_if_that_helps(eh, 0.5)) return;
    }
    for (const EdgeHandle eh : edges) {
      if (split_if_that_helps(eh, bend_of(eh))) return;
    }
  }

  bool split_if_that_helps(EdgeHandle eh, double share) {
    if (!helps_to_split(eh, share) || !split_chord(patch_, eh, share)) return false;
    tidy_new_node();
    return true;
  }

  /// The share of an edge at which the surface is farthest from it: the ridge of a narrow bend.
  double bend_of(EdgeHandle eh) const {
    const Diamond diamond = diamond_of(patch_, eh);
    const Vec3 direction = (diamond.tip.point - diamond.origin.point).stableNormalized();
    const auto distance = [&](double share) {
      const Uv uv = lerp(diamond.origin.uv, diamond.tip.uv, share);
      const Vec3 point = patch_.surface->evaluate(uv, Order::Position).point;
      return direction.cross(point - diamond.origin.point).norm();
    };
    double bend = 0.5, greatest = distance(bend);
    for (double step = kFirstBendStep; step >= kLastBendStep;) {
      const double before = bend;
      for (const double share : {before - step, before + step}) {
        if (share < kFirstBend || share > kLastBend) continue;
        const double there = distance(share);
        if (!(there > greatest)) continue;
        greatest = there;
        bend = share;
      }
      if (bend == before) step /= 2;
    }
    return bend;
  }

  /// True if a node at a share of an edge brings the triangles nearer to the surface and leaves no
  /// slivers: these are never near, for their planes stand across the surface.
  bool helps_to_split(EdgeHandle eh, double share) const {
    const Diamond diamond = diamond_of(patch_, eh);
    const auto after =
        diamond.split_at(corner_at(patch_, lerp(diamond.origin.uv, diamond.tip.uv, share)));
    return shape_of(after) >= kLeastSplitShape &&
           is_nearer(after, diamond.triangles(), kLeastReduction);
  }

  /// True if triangles are near enough, or no farther than a share of what others are.
  bool is_nearer(const CornerTriangles& after, const CornerTriangles& before,
                 double share = 1) const {
    return meter_.holds(after) || meter_.sag_of(after) <= share * meter_.sag_of(before);
  }

  /// Measure the triangles of the last node, and make them better.
  void tidy_new_node() {
    ++result_.nodes;
    evaluate_vertices(patch_);
    const VertexHandle vh(static_cast<int>(delaunay_.n_vertices()) - 1);
    measure_new_faces();
    measure_around(vh);
    for (int sweep = 0; sweep < 2; ++sweep) {
      std::vector<EdgeHandle> rim;
      for (const HalfedgeHandle heh : mesh().voh_range(vh)) {
        rim.push_back(mesh().edge_handle(mesh().next_halfedge_handle(heh)));
      }
      for (const EdgeHandle eh : rim) swap_for_shape(eh);
      smooth(vh);
      for (const VertexHandle near : ring_of(patch_, vh)) smooth(near);
    }
  }

  void measure_around(VertexHandle vh) {
    for (const HalfedgeHandle heh : mesh().voh_range(vh)) {
      if (mesh().is_boundary(heh)) continue;
      const FaceHandle fh = mesh().face_handle(heh);
      sag(fh) = sag_now(fh);
    }
  }

  /// Move an inner node towards the middle of its neighbours if that makes the shapes around
  /// better.
  void smooth(VertexHandle vh) {
    if (index(vh) < boundary_count_) return;
    const PatchCorner now = corner_of(patch_, vh);
    const double shape = shape_of(star_of(patch_, vh, now));
    if (shape > kGoodShape) return;
    Uv middle{0, 0};
    const std::vector<VertexHandle> neighbours = ring_of(patch_, vh);
    for (const VertexHandle near : neighbours) middle = middle + delaunay_.uv(near);
    middle = 1.0 / static_cast<double>(neighbours.size()) * middle;
    for (const double share : {1.0, 0.5, 0.25}) {
      const PatchCorner then = corner_at(patch_, lerp(now.uv, middle, share));
      const CornerTriangles moved = star_of(patch_, vh, then);
      if (!are_upright(moved) || shape_of(moved) < shape + kLeastCorrectionGain) continue;
      if (!is_nearer(moved, star_of(patch_, vh, now))) continue;
      move(vh, then);
      return;
    }
  }

  void move(VertexHandle vh, const PatchCorner& to) {
    const auto v = index(vh);
    QueryHint hint;
    delaunay_.uv(vh) = to.uv;
    delaunay_.metric(vh) = patch_.field->at(to.uv, hint);
    patch_.points[v] = to.point;
    patch_.normals[v] = to.normal;
    measure_around(vh);
  }

  TriangulatedPatch& patch_;
  DelaunayMesh& delaunay_;
  double aim_;
  const RunContext& context_;
  SagMeter meter_;
  std::size_t boundary_count_ = 0;
  std::vector<double> sags_;  ///< by face
  SagCorrections result_;
};

}  // namespace

SagCorrections correct_sag(TriangulatedPatch& patch, double aim, const RunContext& context) {
  const SagCorrections result = SagCorrector(patch, aim, context).run();
  patch.delaunay->shrink();
  return result;
}

}  // namespace surfmesh::detail
