// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/fit_lengths.hh"

#include <algorithm>
#include <vector>

#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

class LengthFit {
 public:
  LengthFit(DelaunayMesh& delaunay, VertexMoves& moves, const RunContext& context)
      : delaunay_(delaunay), moves_(moves), context_(context) {}

  FitReport run() {
    // Downwards: what takes the place of a collapsed edge has been looked at.
    for (std::size_t i = delaunay_.n_edges(); i > 0; --i) {
      if (i % kStepsBetweenCancellation == 0) context_.throw_if_cancelled();
      if (i > delaunay_.n_edges()) continue;
      const EdgeHandle eh(static_cast<int>(i - 1));
      if (delaunay_.is_constrained(eh)) continue;
      const HalfedgeHandle heh = mesh().halfedge_handle(eh, 0);
      const double length = metric_length(heh);
      if (length < kShortestUnit) {
        if (!try_collapse(heh)) try_collapse(mesh().opposite_halfedge_handle(heh));
      } else if (length > kLongestUnit) {
        try_split(eh);
      }
    }
    return report_;
  }

 private:
  const PolyMesh& mesh() const { return delaunay_.mesh(); }

  MetricCorner origin(HalfedgeHandle heh) const {
    return corner(delaunay_, mesh().from_vertex_handle(heh));
  }

  MetricCorner tip(HalfedgeHandle heh) const {
    return corner(delaunay_, mesh().to_vertex_handle(heh));
  }

  double metric_length(HalfedgeHandle heh) const { return distance(origin(heh), tip(heh)); }

  static double distance(const MetricCorner& a, const MetricCorner& b) {
    return fast_edge_length(a.uv, a.metric, b.uv, b.metric);
  }

  /// Least quality of the triangles around the origin after its merger with the tip; negative if
  /// one is inverted or an edge gets too long.
  double quality_after_collapse(const MetricCorner& tip) const {
    double least = 1;
    const MetricCorner* previous = &star_.ring().back();
    for (const MetricCorner& next : star_.ring()) {
      if (!(previous->uv == tip.uv) && !(next.uv == tip.uv)) {
        if (orient2d(tip.uv, previous->uv, next.uv) <= 0) return -1;
        if (std::max(distance(tip, *previous), distance(tip, next)) > kLongestUnit) return -1;
        least = std::min(least, triangle_quality(tip, *previous, next));
      }
      previous = &next;
    }
    return least;
  }

  bool try_collapse(HalfedgeHandle heh) {
    const VertexHandle gone = mesh().from_vertex_handle(heh);
    if (!star_.collect(delaunay_, gone)) return false;
    const double before = star_.quality(corner(delaunay_, gone));
    if (quality_after_collapse(tip(heh)) < std::min(before, kGoodQuality)) return false;
    VertexHandle kept = mesh().to_vertex_handle(heh);
    delaunay_.collapse(heh);
    // The last vertex has taken the number of the one that went.
    if (index(kept) == delaunay_.n_vertices()) kept = gone;
    ++report_.collapsed;
    smooth_around(kept);
    return true;
  }

  bool try_split(EdgeHandle eh) {
    const HalfedgeHandle heh = mesh().halfedge_handle(eh, 0);
    const HalfedgeHandle back = mesh().opposite_halfedge_handle(heh);
    const MetricCorner a = origin(heh), b = tip(heh);
    const MetricCorner left = tip(mesh().next_halfedge_handle(heh));
    const MetricCorner right = tip(mesh().next_halfedge_handle(back));
    const MetricCorner middle = moves_.at(lerp(a.uv, b.uv, 0.5));
    const double shortest = std::min({distance(a, middle), distance(b, middle),
                                      distance(left, middle), distance(right, middle)});
    const double before = std::min(triangle_quality(a, b, left), triangle_quality(b, a, right));
    double after = 1;
    for (const auto& [from, to] : {std::pair(b, left), {left, a}, {a, right}, {right, b}}) {
      if (orient2d(middle.uv, from.uv, to.uv) <= 0) return false;
      after = std::min(after, triangle_quality(middle, from, to));
    }
    if (shortest < kShortestUnit || after < std::min(before, kGoodQuality)) return false;
    const VertexHandle vh = delaunay_.split_edge(eh, middle.uv);
    delaunay_.metric(vh) = middle.metric;
    ++report_.split;
    smooth_around(vh);
    return true;
  }

  void smooth_around(VertexHandle vh) {
    neighbours_.assign(1, vh);
    for (const VertexHandle neighbour : mesh().vv_range(vh)) neighbours_.push_back(neighbour);
    for (const VertexHandle neighbour : neighbours_) moves_.smooth(neighbour, Smoothing::Best);
  }

  DelaunayMesh& delaunay_;
  VertexMoves& moves_;
  const RunContext& context_;
  Star star_;
  std::vector<VertexHandle> neighbours_;
  FitReport report_;
};

}  // namespace

FitReport fit_lengths(DelaunayMesh& delaunay, VertexMoves& moves, const RunContext& context) {
  const FitReport report = LengthFit(delaunay, moves, context).run();
  delaunay.shrink();
  return report;
}

}  // namespace surfmesh
