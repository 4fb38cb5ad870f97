// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/space_moves.hh"

#include <array>
#include <cmath>

#include "surfmesh/improve/vertex_search.hh"

namespace surfmesh {
namespace {

using namespace vertex_search;

const std::array<ChartStep, 8> kDirections = directions<ChartStep>();

ChartStep scaled(double factor, ChartStep step) { return {factor * step.x, factor * step.y}; }

/// A chart as it would be after a step if nothing but the position changed.
VertexChart shifted(VertexChart chart, ChartStep step) {
  const Uv ahead = chart.in_parameters(step);
  chart.point += chart.in_space(step);
  chart.place.uv = chart.place.uv + ahead;
  return chart;
}

}  // namespace

bool SpaceMoves::smooth(VertexHandle vh) {
  if (!star_.collect(state_.mesh, vh)) return false;
  const VertexChart& old = state_.chart(vh);
  ChartStep step = star_.spring_step(old);
  const double length = std::hypot(step.x, step.y);
  if (!(length >= kLeastMove && length < INFINITY)) return false;
  for (int attempt = 0; attempt < 2; ++attempt, step = scaled(0.5, step)) {
    // Far moves that invert a triangle are not worth an evaluation.
    if (!star_.sees(old, old.point + old.in_space(step))) continue;
    const auto there = state_.maker.move(old, step);
    if (!there) continue;
    const double reached = star_.quality(*there, 0);
    if (reached <= 0) continue;
    if (reached < kGoodSpaceQuality && reached < star_.quality(old)) continue;
    state_.set_chart(vh, *there);
    return true;
  }
  return false;
}

/// The best of eight places around one, or that itself.
VertexChart SpaceMoves::best_around(const VertexChart& from, double step, double& best_score) {
  VertexChart best = from;
  for (const ChartStep direction : kDirections) {
    const ChartStep ahead = scaled(step, direction);
    // Most places are worse by far already in the metric of the vertex.
    const double enough = best_score - kMetricChange;
    if (star_.score(shifted(from, ahead), enough) <= enough) continue;
    const auto there = state_.maker.move(from, ahead);
    if (!there) continue;
    const double value = star_.score(*there, best_score + kLeastGain);
    if (value <= best_score + kLeastGain) continue;
    best_score = value;
    best = *there;
  }
  return best;
}

void SpaceMoves::search(VertexHandle vh) {
  if (!star_.collect(state_.mesh, vh)) return;
  VertexChart best = state_.chart(vh);
  const SurfacePlace old = best.place;
  double best_score = star_.score(best, -1);
  double step = kFirstStep;
  for (int round = 0; round < kMaxSearchRounds && step >= kLastStep; ++round) {
    const VertexChart next = best_around(best, step, best_score);
    if (next.place == best.place) step *= 0.5;
    best = next;
  }
  if (!(best.place == old)) state_.set_chart(vh, best);
}

}  // namespace surfmesh
