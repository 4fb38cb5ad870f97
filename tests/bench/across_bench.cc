// SPDX-License-Identifier: BSD-3-Clause
// Elements across contours of a cylinder of 16 strips, finer and finer; the mesh of the patches is
// made beforehand.
#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

#include "support/assembled.hh"
#include "support/models.hh"
#include "surfmesh/across/across.hh"

namespace surfmesh {
namespace {

Model strips(int count) {
  std::vector<testing::Shape> shapes;
  for (int i = 0; i < count; ++i) {
    shapes.push_back(testing::cylinder(2 * std::numbers::pi * i / count,
                                       2 * std::numbers::pi * (i + 1) / count));
  }
  return testing::model_of(shapes);
}

void triangles(benchmark::State& state) {
  const double size = 0.1 / static_cast<double>(state.range(0));
  const Model model = strips(16);
  const testing::UniformSizes sizes(model, size);
  const PolyMesh before = testing::assemble_with_size(model, size).mesh;
  double faces = 0;
  for (auto _ : state) {
    state.PauseTiming();
    PolyMesh mesh = before;
    state.ResumeTiming();
    faces = static_cast<double>(improve_across(mesh, model, sizes).faces);
    benchmark::DoNotOptimize(mesh);
  }
  state.counters["triangles"] = faces;
  state.counters["triangles_per_second"] =
      benchmark::Counter(faces, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(triangles)->RangeMultiplier(2)->Range(1, 16)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
