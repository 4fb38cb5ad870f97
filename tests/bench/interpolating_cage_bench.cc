// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "surfmesh/cage/fit_cage.hh"
#include "surfmesh/cage/interpolating_cage.hh"

namespace surfmesh {
namespace {

/// The mesh of a torus of about so many triangles, or half as many quads.
Cage torus(std::int64_t triangles, bool is_quads = false) {
  const int n = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 2));
  Cage cage;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double a = 2 * M_PI * i / n, b = 2 * M_PI * j / n, r = 3 + std::cos(b);
      cage.points.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int right = (i + 1) % n, up = (j + 1) % n;
      const std::array<int, 4> q = {j * n + i, j * n + right, up * n + right, up * n + i};
      if (is_quads) {
        cage.faces.push_back({q[0], q[1], q[2], q[3]});
      } else {
        cage.faces.push_back({q[0], q[1], q[2]});
        cage.faces.push_back({q[0], q[2], q[3]});
      }
    }
  }
  return cage;
}

void count_faces(benchmark::State& state, const Cage& cage) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cage.faces.size()));
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Arg(2'000)->Arg(20'000)->Arg(100'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
}

void BM_Triangles(benchmark::State& state) {
  const Cage cage = torus(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(interpolating_cage(cage));
  count_faces(state, cage);
}
BENCHMARK(BM_Triangles)->Apply(sizes);

void BM_Quads(benchmark::State& state) {
  const Cage cage = torus(state.range(0), true);
  for (auto _ : state) benchmark::DoNotOptimize(interpolating_cage(cage));
  count_faces(state, cage);
}
BENCHMARK(BM_Quads)->Apply(sizes);

/// With a fit of a tenth of the edges.
void BM_Fit(benchmark::State& state) {
  const Cage cage = torus(state.range(0));
  const double fit = 0.6 / std::sqrt(static_cast<double>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(interpolating_cage(cage, {.fit = Length::units(fit)}));
  }
  count_faces(state, cage);
}
BENCHMARK(BM_Fit)->Apply(sizes);

/// All that a mesh takes before its model is made: measures, features, interpolation, waves.
void BM_FitCage(benchmark::State& state) {
  const Cage mesh = torus(state.range(0));
  for (auto _ : state) {
    Cage cage = mesh;
    benchmark::DoNotOptimize(detail::fit_cage({}, Scheme::Loop, cage));
  }
  count_faces(state, mesh);
}
BENCHMARK(BM_FitCage)->Apply(sizes);

}  // namespace
}  // namespace surfmesh
