// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/vertex_moves.hh"

#include <algorithm>
#include <array>
#include <cmath>

#include "surfmesh/improve/vertex_search.hh"
#include "surfmesh/metric/perpendicular.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

using namespace vertex_search;

const std::array<Uv, 8> kDirections = directions<Uv>();

/// True for the squares of lengths in the unit range, but for those next to its limits.
bool is_well_within_unit_range(double squared_length) {
  return squared_length > 0.501 && squared_length < 1.999;
}

/// Least height of a unit apex over its base, which may be longer than both sides together.
constexpr double kLeastHeight = 0.5;

/// The point left of the base from a to b that is a unit away from both in a metric.
Uv unit_apex(Uv a, Uv b, const Metric& m) {
  const Uv base = b - a;
  const double length = std::sqrt(squared_length(m, base));
  const double height =
      std::sqrt(std::max(1 - 0.25 * length * length, kLeastHeight * kLeastHeight));
  return 0.5 * (a + b) + height * unit_left_of(base, length, m);
}

}  // namespace

void VertexMoves::move(VertexHandle vh, const MetricCorner& p) {
  delaunay_.uv(vh) = p.uv;
  delaunay_.metric(vh) = p.metric;
  ++count_;
}

Uv VertexMoves::spring_step(const MetricCorner& centre) const {
  double a11 = 0, a12 = 0, a22 = 0, b1 = 0, b2 = 0;
  for (const MetricCorner& neighbour : star_.ring()) {
    const Metric m = mean(centre.metric, neighbour.metric);
    const Uv edge = centre.uv - neighbour.uv;
    const double length =
        fast_edge_length(centre.uv, centre.metric, neighbour.uv, neighbour.metric);
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

/// The mean of the neighbours, each as often as its distance tells.
Uv VertexMoves::laplace_step(const MetricCorner& centre) const {
  double total = 0;
  Uv sum{0, 0};
  for (const MetricCorner& neighbour : star_.ring()) {
    const Uv edge = neighbour.uv - centre.uv;
    const double length = std::sqrt(squared_length(centre.metric, edge));
    total += length;
    sum = sum + length * edge;
  }
  return (1 / total) * sum;
}

Uv VertexMoves::element_step(const MetricCorner& centre) {
  Uv sum{0, 0};
  const Uv* previous = &star_.ring().back().uv;
  for (const MetricCorner& next : star_.ring()) {
    const Uv middle = (1.0 / 3) * (centre.uv + *previous + next.uv);
    sum = sum + (unit_apex(*previous, next.uv, field_.at_unkept(middle, hint_)) - centre.uv);
    previous = &next.uv;
  }
  return (1 / static_cast<double>(star_.ring().size())) * sum;
}

Uv VertexMoves::smoothing_step(const MetricCorner& centre, Smoothing kind) {
  switch (kind) {
    case Smoothing::Laplace:
      return laplace_step(centre);
    case Smoothing::Element:
      return element_step(centre);
    default:
      return spring_step(centre);
  }
}

bool VertexMoves::smooth(VertexHandle vh, Smoothing kind) {
  if (!star_.collect(delaunay_, vh)) return false;
  const MetricCorner old = corner(delaunay_, vh);
  Uv step = smoothing_step(old, kind);
  const double length = std::sqrt(squared_length(old.metric, step));
  if (!(length >= kLeastMove && length < INFINITY)) return false;
  for (int attempt = 0; attempt < 2; ++attempt) {
    const Uv uv = old.uv + step;
    // Far moves that invert a triangle are not worth a query.
    if (star_.sees(uv)) {
      const MetricCorner p = at(uv);
      const double reached = star_.quality(p);
      if (reached >= kGoodQuality || reached >= star_.quality(old)) {
        move(vh, p);
        return true;
      }
    }
    step = 0.5 * step;
  }
  return false;
}

/// Least quality around the vertex less half the excess of its edges over the unit range. If that
/// is no more than `enough`, any value up to there may be the result.
double VertexMoves::score(const MetricCorner& p, double enough) const {
  const double least = star_.quality(p, enough);
  if (least <= std::max(enough, 0.0)) return least;
  double excess = 0;
  for (const MetricCorner& neighbour : star_.ring()) {
    const Uv step = neighbour.uv - p.uv;
    const double squared0 = squared_length(p.metric, step);
    const double squared1 = squared_length(neighbour.metric, step);
    // Most edges are: their length lies between those at their ends.
    if (is_well_within_unit_range(squared0) && is_well_within_unit_range(squared1)) continue;
    const double length = fast_edge_length(squared0, squared1);
    excess = std::max({excess, kShortestUnit - length, length - kLongestUnit});
  }
  // A valid position never scores below an inverted one.
  return std::max(least - 0.5 * excess, 0.0);
}

/// The best of eight points around one, or that itself.
MetricCorner VertexMoves::best_around(const MetricCorner& from, double step, double& best_score) {
  MetricCorner best = from;
  // Unit steps in the metric: the columns of its inverse Cholesky factor.
  const double l11 = std::sqrt(from.metric.m11), l21 = from.metric.m12 / l11;
  const double l22 = std::sqrt(from.metric.m22 - l21 * l21);
  if (!(l22 > 0)) return best;  // singular by rounding
  for (const Uv direction : kDirections) {
    const double y = step * direction.v / l22;
    const Uv uv = from.uv + Uv{(step * direction.u - l21 * y) / l11, y};
    // Most points are worse by far already in the metric of the vertex.
    const double enough = best_score - kMetricChange;
    if (score({uv, from.metric}, enough) <= enough) continue;
    const MetricCorner p = at(uv);
    const double value = score(p, best_score + kLeastGain);
    if (value > best_score + kLeastGain) {
      best_score = value;
      best = p;
    }
  }
  return best;
}

void VertexMoves::search(VertexHandle vh) {
  if (!star_.collect(delaunay_, vh)) return;
  const MetricCorner old = corner(delaunay_, vh);
  MetricCorner best = old;
  star_.begin_at_worst(old);
  double best_score = score(best, -1);
  double step = kFirstStep;
  for (int round = 0; round < kMaxSearchRounds && step >= kLastStep; ++round) {
    const MetricCorner next = best_around(best, step, best_score);
    if (next.uv == best.uv) step *= 0.5;
    best = next;
  }
  if (!(best.uv == old.uv)) move(vh, best);
}

}  // namespace surfmesh
