// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/smooth_within_sag.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "surfmesh/improve/shape_moves.hh"
#include "surfmesh/patch/corner_triangles.hh"
#include "surfmesh/patch/sag_meter.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh::detail {
namespace {

constexpr int kSmoothingSweeps = 2;

/// Nodes whose triangles are all of a better quality stay where they are.
constexpr double kGoodQuality = 0.9;

/// Gain of the lower quality beside an edge for which it is swapped.
constexpr double kLeastSwapGain = 0.01;

/// For nodes with triangles below this shape in space, better places are searched; the steps in
/// units of the metric, and the least gain of shape for one.
constexpr double kPoorShape = 0.52;
constexpr std::array<double, 4> kSearchSteps = {0.3, 0.15, 0.07, 0.03};
constexpr double kLeastSmoothingGain = 0.01;

/// Unit vectors around a circle.
constexpr double kDiagonal = std::numbers::sqrt2 / 2;
constexpr std::array<Uv, 8> kDirections = {{{1, 0},
                                            {kDiagonal, kDiagonal},
                                            {0, 1},
                                            {-kDiagonal, kDiagonal},
                                            {-1, 0},
                                            {-kDiagonal, -kDiagonal},
                                            {0, -1},
                                            {kDiagonal, -kDiagonal}}};

class SmoothingWithinSag {
 public:
  SmoothingWithinSag(TriangulatedPatch& patch, double aim, const RunContext& context)
      : patch_(patch),
        delaunay_(*patch.delaunay),
        context_(context),
        meter_(*patch.surface, aim),
        moves_(delaunay_, *patch.field),
        first_inner_(boundary_vertices(patch.boundary).size()) {}

  void run() {
    for (int sweep = 0; sweep < kSmoothingSweeps; ++sweep) {
      for_each_node([this](VertexHandle vh) { smooth(vh); });
      swap_edges();
    }
    for (int sweep = 0; sweep < kSmoothingSweeps; ++sweep) {
      for_each_node([this](VertexHandle vh) { search(vh); });
    }
  }

 private:
  template <class Visit>
  void for_each_node(Visit visit) {
    for (std::size_t v = first_inner_; v < delaunay_.n_vertices(); ++v) {
      if (v % kSearchesBetweenCancellation == 0) context_.throw_if_cancelled();
      visit(VertexHandle(static_cast<int>(v)));
    }
  }

  void smooth(VertexHandle vh) {
    moves_.smooth(vh, kGoodQuality, [&](Uv uv) {
      const PatchCorner there = corner_at(patch_, uv);
      const CornerTriangles moved = star_of(patch_, vh, there);
      if (shape_of(moved) <= 0 || !meter_.holds(moved)) return false;
      place(vh, there);
      return true;
    });
  }

  void place(VertexHandle vh, const PatchCorner& there) {
    patch_.points[index(vh)] = there.point;
    patch_.normals[index(vh)] = there.normal;
  }

  void swap_edges() {
    for (std::size_t e = 0; e < delaunay_.n_edges(); ++e) {
      if (e % kSearchesBetweenCancellation == 0) context_.throw_if_cancelled();
      const EdgeHandle eh(static_cast<int>(e));
      if (!is_inner(patch_, eh) || !delaunay_.can_flip(eh) || !gains_by_swap(eh)) continue;
      const CornerTriangles swapped = diamond_of(patch_, eh).swapped();
      if (shape_of(swapped) > 0 && meter_.holds(swapped)) delaunay_.flip(eh);
    }
  }

  bool gains_by_swap(EdgeHandle eh) const {
    const PolyMesh& mesh = delaunay_.mesh();
    const HalfedgeHandle there = mesh.halfedge_handle(eh, 0), back = mesh.halfedge_handle(eh, 1);
    const auto tip = [&](HalfedgeHandle heh) {
      return corner(delaunay_, mesh.to_vertex_handle(heh));
    };
    const MetricCorner a = tip(back), b = tip(there);
    const MetricCorner left = tip(mesh.next_halfedge_handle(there));
    const MetricCorner right = tip(mesh.next_halfedge_handle(back));
    const double before = std::min(triangle_quality(a, b, left), triangle_quality(b, a, right));
    return std::min(triangle_quality(right, b, left), triangle_quality(left, a, right)) >=
           before + kLeastSwapGain;
  }

  /// A place for a node, and the least shape of the triangles around in space and in the metric.
  struct Place {
    PatchCorner corner;
    double score;
  };

  /// Search around a node with triangles of poor shape in space for the best place.
  void search(VertexHandle vh) {
    if (!star_.collect(delaunay_, vh)) return;
    const MetricCorner old = corner(delaunay_, vh);
    const PatchCorner start = corner_of(patch_, vh);
    const double shape = shape_of(star_of(patch_, vh, start));
    if (shape >= kPoorShape) return;
    Place best{start, std::min(shape, star_.quality(old))};
    for (const double step : kSearchSteps) {
      const Uv centre = best.corner.uv;
      for (const Uv direction : kDirections) {
        take_if_better(vh, {centre + unit_step(old.metric, step * direction), old.metric}, best);
      }
    }
    if (best.corner.uv == start.uv) return;
    delaunay_.uv(vh) = best.corner.uv;
    delaunay_.metric(vh) = patch_.field->at(best.corner.uv, hint_);
    place(vh, best.corner);
  }

  void take_if_better(VertexHandle vh, const MetricCorner& there, Place& best) const {
    const double least = best.score + kLeastSmoothingGain;
    const double quality = star_.quality(there);
    if (best.score >= kPoorShape || quality < least) return;
    const PatchCorner corner = corner_at(patch_, there.uv);
    const CornerTriangles moved = star_of(patch_, vh, corner);
    const double score = std::min(quality, shape_of(moved));
    if (score >= least && meter_.holds(moved)) best = {corner, score};
  }

  /// A step of units of the metric in (u,v): by its inverse Cholesky factor.
  static Uv unit_step(const Metric& metric, Uv step) {
    const double l11 = std::sqrt(metric.m11), l21 = metric.m12 / l11;
    const double l22 = std::sqrt(std::max(0.0, metric.m22 - l21 * l21));
    if (!(l22 > 0)) return {0, 0};  // singular by rounding
    const double y = step.v / l22;
    return {(step.u - l21 * y) / l11, y};
  }

  TriangulatedPatch& patch_;
  DelaunayMesh& delaunay_;
  const RunContext& context_;
  SagMeter meter_;
  ShapeMoves moves_;
  Star star_;
  std::size_t first_inner_;
  QueryHint hint_;
};

}  // namespace

void smooth_within_sag(TriangulatedPatch& patch, double aim, const RunContext& context) {
  SmoothingWithinSag(patch, aim, context).run();
}

}  // namespace surfmesh::detail
