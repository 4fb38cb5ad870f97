// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of one evaluation of a NURBS surface, by its degrees and the order (the argument: 0, 1, 2).
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "surfmesh/nurbs/nurbs_surface.hh"

namespace surfmesh {
namespace {

/// Clamped knots of a number of spans; uneven if `power` is not 1.
std::vector<double> clamped_knots(int degree, int spans, double power) {
  std::vector<double> knots(static_cast<std::size_t>(degree), 0.0);
  for (int i = 0; i <= spans; ++i) {
    knots.push_back(std::pow(static_cast<double>(i) / spans, power));
  }
  knots.insert(knots.end(), static_cast<std::size_t>(degree), 1.0);
  return knots;
}

NurbsNet wavy_net(int p, int q, int spans, bool is_rational, double power) {
  NurbsNet net{{p, q}, {clamped_knots(p, spans, power), clamped_knots(q, spans, power)}};
  for (int j = 0; j < q + spans; ++j) {
    std::vector<Vec3>& row = net.points.emplace_back();
    std::vector<double> weights;
    for (int i = 0; i < p + spans; ++i) {
      row.push_back({1.0 * i, 1.0 * j, std::sin(i + 2.0 * j)});
      weights.push_back(1 + 0.2 * std::cos(i + j));
    }
    if (is_rational) net.weights.push_back(weights);
  }
  return net;
}

void evaluate(benchmark::State& state, int p, int q, bool is_rational, double power) {
  const NurbsSurface surface(wavy_net(p, q, 8, is_rational, power));
  std::vector<Uv> at;
  for (int i = 1; i <= 1024; ++i) {
    const double s = 0.6180339887498949 * i, t = 0.7548776662466927 * i;
    at.push_back({s - std::floor(s), t - std::floor(t)});
  }
  const auto order = static_cast<Order>(state.range(0));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(surface.evaluate(at[i++ % at.size()], order));
  }
}

BENCHMARK_CAPTURE(evaluate, 1x1, 1, 1, false, 1)->DenseRange(0, 2);
BENCHMARK_CAPTURE(evaluate, 2x1_rational, 2, 1, true, 1)->DenseRange(0, 2);
BENCHMARK_CAPTURE(evaluate, 3x3, 3, 3, false, 1)->DenseRange(0, 2);
BENCHMARK_CAPTURE(evaluate, 3x3_uneven, 3, 3, false, 2)->DenseRange(0, 2);
BENCHMARK_CAPTURE(evaluate, 3x3_rational, 3, 3, true, 1)->DenseRange(0, 2);
BENCHMARK_CAPTURE(evaluate, 5x5, 5, 5, false, 1)->DenseRange(0, 2);
BENCHMARK_CAPTURE(evaluate, 13x1, 13, 1, false, 1)->DenseRange(0, 2);
BENCHMARK_CAPTURE(evaluate, 14x3, 14, 3, false, 1)->DenseRange(0, 2);

}  // namespace
}  // namespace surfmesh
