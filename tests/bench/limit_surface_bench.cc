// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <cmath>

#include "cage/cages.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/cage/subdivision.hh"

namespace surfmesh {
namespace {

/// A torus of 64 × 64 quads. With pinned corners every third vertex is a corner, which makes all
/// its faces irregular.
Cage torus(bool is_irregular) {
  constexpr int n = 64;
  Cage cage;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double a = 2 * M_PI * i / n, b = 2 * M_PI * j / n, r = 3 + std::cos(b);
      cage.points.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
      if (is_irregular && (i + j) % 3 == 0) cage.corners.push_back({j * n + i, 10});
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int right = (i + 1) % n, up = (j + 1) % n;
      cage.faces.push_back({j * n + i, j * n + right, up * n + right, up * n + i});
    }
  }
  return cage;
}

/// Argument 0: 0 regular, 1 irregular faces. Time per face is 1 / items per second.
void BM_SetUp(benchmark::State& state) {
  const Cage cage = torus(state.range(0) != 0);
  for (auto _ : state) benchmark::DoNotOptimize(make_limit_surfaces(cage, Scheme::CatmullClark));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cage.faces.size()));
}
BENCHMARK(BM_SetUp)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void evaluate(benchmark::State& state, const Surface& surface, Order order) {
  double t = 0;
  for (auto _ : state) {
    t = t < 0.5 ? t + 0.0123 : t - 0.4911;
    benchmark::DoNotOptimize(surface.evaluate({t, 0.49 - t / 2}, order));
  }
}

/// Argument: order of the derivatives.
void BM_RegularByHand(benchmark::State& state) {
  const auto surface = make_limit_surfaces(torus(false), Scheme::CatmullClark)[0];
  evaluate(state, *surface, static_cast<Order>(state.range(0)));
}
BENCHMARK(BM_RegularByHand)->DenseRange(0, 2);

/// The same face in a block of 4,096.
void BM_RegularInBlock(benchmark::State& state) {
  const Model model = model_from_cage(torus(false));
  evaluate(state, *model.patches[0].surface, static_cast<Order>(state.range(0)));
}
BENCHMARK(BM_RegularInBlock)->DenseRange(0, 2);

/// Argument: 0 faces, 1 blocks.
void BM_Model(benchmark::State& state) {
  const Cage cage = torus(true);
  const PatchKind kind = state.range(0) == 0 ? PatchKind::Faces : PatchKind::Blocks;
  for (auto _ : state) benchmark::DoNotOptimize(model_from_cage(cage, {.patches = kind}));
}
BENCHMARK(BM_Model)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void BM_RegularByBfr(benchmark::State& state) {
  const Cage cage = torus(false);
  const CageTopology topology = make_topology(cage, Scheme::CatmullClark);
  const auto surface = make_limit_surfaces(*topology.refiner, cage.points, {8, false})[0];
  evaluate(state, *surface, static_cast<Order>(state.range(0)));
}
BENCHMARK(BM_RegularByBfr)->DenseRange(0, 2);

void BM_Irregular(benchmark::State& state) {
  const auto surface = make_limit_surfaces(torus(true), Scheme::CatmullClark)[0];
  evaluate(state, *surface, static_cast<Order>(state.range(0)));
}
BENCHMARK(BM_Irregular)->DenseRange(0, 2);

void BM_RegularLoop(benchmark::State& state) {
  const auto surface = make_limit_surfaces(testing::halved_quads(torus(false)), Scheme::Loop)[0];
  evaluate(state, *surface, static_cast<Order>(state.range(0)));
}
BENCHMARK(BM_RegularLoop)->DenseRange(0, 2);

void BM_IrregularLoop(benchmark::State& state) {
  const auto surface = make_limit_surfaces(testing::halved_quads(torus(true)), Scheme::Loop)[0];
  evaluate(state, *surface, static_cast<Order>(state.range(0)));
}
BENCHMARK(BM_IrregularLoop)->DenseRange(0, 2);

}  // namespace
}  // namespace surfmesh

BENCHMARK_MAIN();
