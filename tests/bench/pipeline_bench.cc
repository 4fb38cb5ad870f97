// SPDX-License-Identifier: BSD-3-Clause
// The whole path of a formula surface and of cages, also within a sag and by several threads, and
// refinement alone on the metric of case c1, over growing numbers of triangles. The counter
// `triangles` is per second.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "cage/cages.hh"

// After cages, for Scheme::Loop of a later header would shadow the Loop of a model.
#include "support/domain_meshes.hh"
#include "support/metric_formulas.hh"
#include "support/models.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

void count_triangles(benchmark::State& state, std::size_t triangles) {
  const auto count = static_cast<double>(triangles);
  state.counters["per_run"] = count;
  state.counters["triangles"] =
      benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate);
}

void mesh_whole(benchmark::State& state, const Model& model) {
  PipelineOptions options;
  options.sizing.curvature = 1 / static_cast<double>(state.range(0));
  options.sizing.hmin = Length::share(1e-5);
  std::size_t triangles = 0;
  for (auto _ : state) triangles = mesh_model(model, {}, options).mesh.n_faces();
  count_triangles(state, triangles);
}

void whole_wave(benchmark::State& state) {
  mesh_whole(
      state, testing::model_of({make_callable_surface({-6, 6, -6, 6}, [](auto u, auto v) {
        return std::array{u, v, 1.5 * sin(2 * u) * cos(v / 5) * exp(-(u * u + v * v) / 1000)};
      })}));
}
BENCHMARK(whole_wave)->RangeMultiplier(2)->Range(4, 32)->Unit(benchmark::kMillisecond);

void whole_torus_cage(benchmark::State& state) {
  mesh_whole(state, model_from_cage(testing::torus(12, 8)));
}
BENCHMARK(whole_torus_cage)->RangeMultiplier(2)->Range(4, 32)->Unit(benchmark::kMillisecond);

/// Argument: faces around the torus, all irregular and in narrow blocks: every other ring is a
/// semi-sharp crease, whose curvature control nodes have to follow. `control` is its share of the
/// time.
void creased_torus_cage(benchmark::State& state) {
  const int rings = static_cast<int>(state.range(0)), sides = rings / 2;
  Cage cage = testing::torus(rings, sides);
  for (int i = 0; i < rings; i += 2) {
    for (int j = 0; j < sides; ++j) {
      cage.creases.push_back({{j * rings + i, (j + 1) % sides * rings + i}, 3});
    }
  }
  const Model model = model_from_cage(cage);
  PipelineOptions options;
  options.sizing.hmin = Length::share(1e-4);
  std::size_t triangles = 0;
  double control = 0, total = 0;
  for (auto _ : state) {
    const Report report = mesh_model(model, {}, options).report;
    triangles = report.mesh.triangles;
    control += report.seconds[Stage::Control];
    total += report.seconds.sum();
  }
  count_triangles(state, triangles);
  state.counters["control"] = control / total;
}
BENCHMARK(creased_torus_cage)->RangeMultiplier(2)->Range(8, 64)->Unit(benchmark::kMillisecond);

/// Argument: the diagonal over the sag.
void torus_cage_within_sag(benchmark::State& state) {
  const Model model = model_from_cage(testing::torus(12, 8));
  PipelineOptions options;
  options.sizing.sag = Length::share(1 / static_cast<double>(state.range(0)));
  options.sizing.hmin = Length::share(1e-5);
  std::size_t triangles = 0;
  for (auto _ : state) triangles = mesh_model(model, {}, options).mesh.n_faces();
  count_triangles(state, triangles);
}
BENCHMARK(torus_cage_within_sag)
    ->RangeMultiplier(4)
    ->Range(256, 4096)
    ->Unit(benchmark::kMillisecond);

/// Argument: the share of the sizes of a strong metric.
void strong_metric(benchmark::State& state, testing::MetricFormulas (*formulas)(double scale)) {
  const double scale = 1 / static_cast<double>(state.range(0));
  const auto path = std::filesystem::temp_directory_path() / "surfmesh_pipeline_bench.json";
  std::ofstream(path) << testing::model_text(formulas(scale));
  const ModelInput input = load_model(path);
  std::filesystem::remove(path);
  std::size_t triangles = 0;
  for (auto _ : state) {
    triangles = mesh_model(input.model, input.sources, input.options).mesh.n_faces();
  }
  count_triangles(state, triangles);
}
BENCHMARK_CAPTURE(strong_metric, shock, testing::shock_formulas)
    ->RangeMultiplier(2)
    ->Range(1, 8)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(strong_metric, ring, testing::ring_formulas)
    ->RangeMultiplier(2)
    ->Range(1, 4)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(strong_metric, jump, testing::jump_formulas)
    ->RangeMultiplier(2)
    ->Range(1, 4)
    ->Unit(benchmark::kMillisecond);

/// Argument: the number of threads. `UseRealTime`, for what counts is the clock.
void torus_cage_by_threads(benchmark::State& state) {
  const Model model = model_from_cage(testing::torus(24, 16), {.patches = PatchKind::Faces});
  PipelineOptions options;
  options.sizing.hmax = Length::share(0.005);
  options.threads = static_cast<int>(state.range(0));
  std::size_t triangles = 0;
  for (auto _ : state) triangles = mesh_model(model, {}, options).mesh.n_faces();
  count_triangles(state, triangles);
}
BENCHMARK(torus_cage_by_threads)
    ->RangeMultiplier(2)
    ->Range(1, 8)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Argument: by how much sizes are smaller than those of c1.
template <class Way>
void refine_four_points(benchmark::State& state, Way way) {
  const auto field = testing::four_point_field(static_cast<double>(state.range(0)));
  std::size_t triangles = 0;
  for (auto _ : state) {
    state.PauseTiming();
    auto delaunay = testing::empty_square(field);
    state.ResumeTiming();
    refine(*delaunay, field, way);
    triangles = delaunay->n_faces();
  }
  count_triangles(state, triangles);
}
BENCHMARK_CAPTURE(refine_four_points, frontal, RefineOptions{})
    ->RangeMultiplier(2)
    ->Range(1, 8)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(refine_four_points, circumcentre,
                  RefineOptions{.placement = Placement::Circumcentre})
    ->RangeMultiplier(2)
    ->Range(1, 8)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
