// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/improve.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/improve/star.hh"

namespace surfmesh {
namespace {

/// Metric length below which a move is not worth its metric query.
constexpr double kLeastMove = 0.01;

/// A vertex may lose quality in favour of edge lengths down to this.
constexpr double kGoodQuality = 0.8;

/// Gain of score for which a vertex is moved: far above rounding, so that a search ends.
constexpr double kLeastGain = 1e-6;

/// By so much the score of a place within a fifth of a unit may differ with its own metric and with
/// that of the vertex.
constexpr double kMetricChange = 0.02;

/// Steps of a search for a better place; four halvings and a few moves are usual.
constexpr int kMaxSearchRounds = 40;

/// Triangles below this quality are repaired.
constexpr double kBadQuality = 0.85;

class Improvement {
 public:
  Improvement(DelaunayMesh& delaunay, const MetricField& field, Observer* observer)
      : delaunay_(delaunay), field_(field), observer_(observer) {}

  void smooth() {
    for (std::size_t i = 0; i < delaunay_.n_vertices(); ++i) {
      if (i % kStepsBetweenCancellation == 0) throw_if_cancelled(observer_);
      const VertexHandle vh(static_cast<int>(i));
      if (star_.collect(delaunay_, vh)) smooth(vh);
    }
  }

  /// Search better places for the vertices of bad triangles, then swap around them.
  /// Returns  false if there was nothing to repair
  bool repair() {
    std::vector<EdgeHandle> edges;
    std::vector<char> is_searched(delaunay_.n_vertices(), 0);
    for (std::size_t i = 0; i < delaunay_.n_faces(); ++i) {
      if (i % kStepsBetweenCancellation == 0) throw_if_cancelled(observer_);
      const FaceHandle fh(static_cast<int>(i));
      if (quality(delaunay_, fh) >= kBadQuality) continue;
      HalfedgeHandle heh = delaunay_.mesh().halfedge_handle(fh);
      for (int k = 0; k < 3; ++k, heh = delaunay_.mesh().next_halfedge_handle(heh)) {
        const VertexHandle vh = delaunay_.mesh().to_vertex_handle(heh);
        char& searched = is_searched[static_cast<std::size_t>(vh.idx())];
        if (!searched && star_.collect(delaunay_, vh)) search(vh);
        searched = 1;
        edges.push_back(delaunay_.mesh().edge_handle(heh));
      }
    }
    if (edges.empty()) return false;
    report_.swapped += swap_edges(delaunay_, std::move(edges));
    return true;
  }

  void swap() { report_.swapped += swap_edges(delaunay_); }

  ImproveReport report() const {
    ImproveReport report = report_;
    report.queries = hint_.answers;
    return report;
  }

 private:
  MetricCorner at(Uv p) {
    return {p, field_.at(p, hint_)};
  }

  void move(VertexHandle vh, const MetricCorner& p) {
    delaunay_.uv(vh) = p.uv;
    delaunay_.metric(vh) = p.metric;
    ++report_.moved;
  }

  /// Gauss-Newton step for Σ (l − 1)² over the edges of the vertex.
  Uv spring_step(const MetricCorner& centre) const {
    double a11 = 0, a12 = 0, a22 = 0, b1 = 0, b2 = 0;
    for (const MetricCorner& neighbour : star_.ring()) {
      const Metric m = mean(centre.metric, neighbour.metric);
      const Uv edge = centre.uv - neighbour.uv;
      const double length = fast_edge_length(centre.uv, centre.metric, neighbour.uv,
                                             neighbour.metric);
      const double g1 = (m.m11 * edge.u + m.m12 * edge.v) / length;
      const double g2 = (m.m12 * edge.u + m.m22 * edge.v) / length;
      a11 += g1 * g1;
      a12 += g1 * g2;
      a22 += g2 * g2;
      b1 += g1 * (1 - length);
      b2 += g2 * (1 - length);
    }
    const double determinant = a11 * a22 - a12 * a12;
    return {(a22 * b1 - a12 * b2) / determinant, (a11 * b2 - a12 * b1) / determinant};
  }

  void smooth(VertexHandle vh) {
    const MetricCorner old = corner(delaunay_, vh);
    Uv step = spring_step(old);
    const double length = std::sqrt(squared_length(old.metric, step));
    if (!(length >= kLeastMove && length < INFINITY)) return;
    for (int attempt = 0; attempt < 2; ++attempt) {
      const Uv place = old.uv + step;
      // Far moves that invert a triangle are not worth a query.
      if (star_.sees(place)) {
        const MetricCorner p = at(place);
        const double reached = star_.quality(p);
        if (reached >= kGoodQuality || reached >= star_.quality(old)) {
          move(vh, p);
          return;
        }
      }
      step = 0.5 * step;
    }
  }

  /// Least quality around the vertex less half the excess of its edges over the unit range.
  double score(const MetricCorner& p) const {
    const double least = star_.quality(p);
    if (least <= 0) return least;
    double excess = 0;
    for (const MetricCorner& neighbour : star_.ring()) {
      const double length = fast_edge_length(p.uv, p.metric, neighbour.uv, neighbour.metric);
      excess = std::max({excess, 1 / std::numbers::sqrt2 - length, length - std::numbers::sqrt2});
    }
    // A valid place never scores below an inverted one.
    return std::max(least - 0.5 * excess, 0.0);
  }

  void search(VertexHandle vh) {
    constexpr double first_step = 0.2, last_step = 0.02;
    constexpr int directions = 8;
    MetricCorner best = corner(delaunay_, vh);
    double best_score = score(best);
    bool is_moved = false;
    double step = first_step;
    for (int round = 0; round < kMaxSearchRounds && step >= last_step; ++round) {
      const MetricCorner from = best;
      // Unit steps in the metric: the columns of its inverse Cholesky factor.
      const double l11 = std::sqrt(from.metric.m11), l21 = from.metric.m12 / l11;
      const double l22 = std::sqrt(from.metric.m22 - l21 * l21);
      if (!(l22 > 0)) break;  // singular by rounding
      for (int i = 0; i < directions; ++i) {
        const double angle = 2 * std::numbers::pi * i / directions;
        const double y = step * std::sin(angle) / l22;
        const Uv place = from.uv + Uv{(step * std::cos(angle) - l21 * y) / l11, y};
        // Most places are worse by far already in the metric of the vertex.
        if (score({place, from.metric}) <= best_score - kMetricChange) continue;
        const MetricCorner p = at(place);
        const double value = score(p);
        if (value > best_score + kLeastGain) {
          best_score = value;
          best = p;
        }
      }
      if (best.uv == from.uv) {
        step *= 0.5;
      } else {
        is_moved = true;
      }
    }
    if (is_moved) move(vh, best);
  }

  DelaunayMesh& delaunay_;
  const MetricField& field_;
  Observer* observer_;
  MetricField::Hint hint_;
  Star star_;
  ImproveReport report_;
};

}  // namespace

void check(const ImproveOptions& options) {
  if (options.sweeps < 0 || options.repairs < 0) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("smoothing = {} sweeps and {} repairs is outside its range: 0 or above",
                            options.sweeps, options.repairs));
  }
}

ImproveReport improve(DelaunayMesh& delaunay, const MetricField& field,
                      const ImproveOptions& options) {
  check(options);
  Improvement improvement(delaunay, field, options.observer);
  for (int i = 0; i < options.sweeps; ++i) improvement.smooth();
  if (options.sweeps > 0) improvement.swap();
  for (int i = 0; i < options.repairs; ++i) {
    if (!improvement.repair()) break;
  }
  return improvement.report();
}

}  // namespace surfmesh
