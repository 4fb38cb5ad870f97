// SPDX-License-Identifier: BSD-3-Clause
// Quads of one patch, without control space. Graded: a unit square with sizes from four points, as
// the case c1 of the paper's authors, finer and finer. Sheared: corners of 30° and 150° in a
// constant metric, where most time goes to cleaning.
#include <benchmark/benchmark.h>

#include "support/domain_meshes.hh"
#include "support/metric_fields.hh"
#include "surfmesh/quad/make_quads.hh"

namespace surfmesh {
namespace {

void fill_square(benchmark::State& state, const testing::FunctionField& field) {
  double quads = 0;
  for (auto _ : state) {
    std::vector<Uv> loop = testing::with_nodes(testing::kUnitSquare, field);
    const std::vector<std::size_t> sizes = {loop.size()};
    PatchQuads made =
        make_quads(triangulate_boundary({loop}, field).delaunay, field, sizes, RunContext());
    quads = static_cast<double>(made.mesh->n_faces());
    benchmark::DoNotOptimize(made);
  }
  state.counters["quads"] = quads;
  state.counters["quads_per_second"] =
      benchmark::Counter(quads, benchmark::Counter::kIsIterationInvariantRate);
}

void graded(benchmark::State& state) {
  fill_square(state, testing::four_point_field(static_cast<double>(state.range(0))));
}

void sheared(benchmark::State& state) {
  const double size = 1.0 / static_cast<double>(state.range(0));
  // Unit steps along u and along a direction 30° from it.
  const double s = 1 / (size * size), cosine = std::cos(std::numbers::pi / 6);
  fill_square(state, testing::constant_field({s, s * cosine, s}));
}

BENCHMARK(graded)->RangeMultiplier(2)->Range(1, 16)->Unit(benchmark::kMillisecond);
BENCHMARK(sheared)->RangeMultiplier(2)->Range(32, 256)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
