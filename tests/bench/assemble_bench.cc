// SPDX-License-Identifier: BSD-3-Clause
// The assembly alone, over growing sizes of the pieces and growing numbers of them: the time and
// the greatest memory per triangle (pieces and result together) are to stay about the same.
#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <string>

#include "support/cut_patches.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

/// A line of /proc/self/status in bytes; 0 where there is none.
double memory(const std::string& name) {
  constexpr double kKibibyte = 1024;
  std::ifstream status("/proc/self/status");
  std::string word;
  double value = 0;
  while (status >> word) {
    if (word == name && status >> value) return kKibibyte * value;
  }
  return 0;
}

/// Let the greatest memory be that of now.
void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

void assemble_alone(benchmark::State& state, const Model& model, double size) {
  double triangles = 0, bytes = 0;
  for (auto _ : state) {
    const double before = memory("VmRSS:");
    testing::CutPatches cut(model, size);
    PolyMesh mesh;
    forget_peak();
    const double start = processor_seconds();
    with_threads(1, [&] { cut.assemble_into(mesh); });
    state.SetIterationTime(processor_seconds() - start);
    triangles = static_cast<double>(mesh.n_faces());
    bytes = memory("VmHWM:") - before;
  }
  state.counters["triangles"] = triangles;
  state.counters["bytes_per_triangle"] = bytes / triangles;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(triangles));
}

/// Two pieces of so many thousand triangles together.
void pieces_that_grow(benchmark::State& state) {
  const double triangles = 1000 * static_cast<double>(state.range(0));
  assemble_alone(state, testing::unit_square(), std::sqrt(4 / (std::sqrt(3) * triangles)));
}
BENCHMARK(pieces_that_grow)
    ->RangeMultiplier(4)
    ->Range(16, 1024)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// Squares side by side, each of two pieces of about 1000 triangles.
void pieces_that_become_more(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  std::vector<testing::Shape> shapes;
  for (int i = 0; i < side * side; ++i) {
    const int x = i % side, y = i / side;
    shapes.push_back(testing::rectangle(x, y, x + 1, y + 1));
  }
  assemble_alone(state, testing::model_of(shapes), 0.034);
}
BENCHMARK(pieces_that_become_more)
    ->RangeMultiplier(2)
    ->Range(2, 16)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
