// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "cage/cages.hh"
#include "cage/region_topology.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// A torus of 6 n² triangles, half of whose vertices are irregular.
Cage fine_torus(int n) { return testing::triangulated(testing::torus(3 * n, n)); }

const std::vector<std::int64_t> kSizes = {18, 58, 130,
                                          183};  // 2,000, 20,000, 100,000 and 200,000 triangles

void set_rate(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

/// Faces a second.
void BM_GatherRegions(benchmark::State& state) {
  const testing::RegionTopology cage(fine_torus(static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(cage.regions());
  set_rate(state, cage.sets.size());
}

/// Faces a second, with their limit surfaces.
void BM_ModelOfRegions(benchmark::State& state) {
  const Cage cage = fine_torus(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(model_from_cage(cage));
  set_rate(state, cage.faces.size());
}

/// Faces a second, with elements five times as large as faces.
void BM_MeshWithLargeElements(benchmark::State& state) {
  const auto n = static_cast<int>(state.range(0));
  const Model model = model_from_cage(fine_torus(n));
  PipelineOptions options;
  options.sizing.hmin = options.sizing.hmax = Length::units(5 * 2 * M_PI / n);
  options.threads = 1;
  for (auto _ : state) benchmark::DoNotOptimize(mesh_model(model, {}, options).mesh.n_faces());
  set_rate(state, static_cast<std::size_t>(6 * n * n));
}

BENCHMARK(BM_GatherRegions)->ArgsProduct({kSizes})->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ModelOfRegions)->ArgsProduct({kSizes})->Unit(benchmark::kMillisecond);
BENCHMARK(BM_MeshWithLargeElements)->ArgsProduct({kSizes})->Unit(benchmark::kMillisecond);

/// Evaluations a second of a chart (1) and of its faces (0), of order 0 to 2.
void BM_Evaluate(benchmark::State& state) {
  CageOptions options;
  options.patches = state.range(0) != 0 ? PatchKind::Regions : PatchKind::Faces;
  const Model model = model_from_cage(fine_torus(18), options);
  const auto order = static_cast<Order>(state.range(1));
  std::size_t i = 0;
  for (auto _ : state) {
    ++i;
    const Surface& surface = model.surface(static_cast<int>(i % model.patches.size()));
    const Domain domain = surface.domain();
    const double s = 0.3 + 0.4 * std::fmod(0.618 * static_cast<double>(i), 1.0);
    benchmark::DoNotOptimize(surface.evaluate(domain.at(s, 0.98 - s), order));
  }
  set_rate(state, 1);
}
BENCHMARK(BM_Evaluate)->ArgsProduct({{0, 1}, {0, 1, 2}});

}  // namespace
}  // namespace surfmesh
