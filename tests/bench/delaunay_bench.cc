// SPDX-License-Identifier: BSD-3-Clause
// Insertion of random points into the kernel. Compare with a prototype's 269 ns a point in BRIO
// order at a million points; the mark is 500 ns.
#include <benchmark/benchmark.h>

#include <random>

#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/delaunay/spatial_order.hh"

namespace surfmesh {
namespace {

std::vector<Uv> random_points(std::int64_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Uv> points;
  for (std::int64_t i = 0; i < count; ++i) points.push_back({uniform(random), uniform(random)});
  return points;
}

std::vector<Uv> in_spatial_order(const std::vector<Uv>& points) {
  std::vector<Uv> ordered;
  for (const int i : spatial_order(points)) ordered.push_back(points[static_cast<std::size_t>(i)]);
  return ordered;
}

template <class Insert>
void insert_all(benchmark::State& state, Insert insert) {
  const std::vector<Uv> points = in_spatial_order(random_points(state.range(0)));
  for (auto _ : state) {
    DelaunayMesh delaunay({0, 0}, {1, 1});
    delaunay.reserve(points.size());
    FaceHandle hint(0);
    for (const Uv p : points) {
      const VertexHandle vh = insert(delaunay, p, hint);
      hint = delaunay.mesh().face_handle(delaunay.mesh().halfedge_handle(vh));
    }
    benchmark::DoNotOptimize(delaunay.n_faces());
  }
  state.counters["per_point"] = benchmark::Counter(
      static_cast<double>(state.range(0)),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void insert_by_cavity(benchmark::State& state) {
  insert_all(state, [](DelaunayMesh& delaunay, Uv p, FaceHandle hint) {
    return delaunay.insert(p, hint, ConstantMetricRule{delaunay.uv_handle()});
  });
}

void insert_by_swaps(benchmark::State& state) {
  insert_all(state, [](DelaunayMesh& delaunay, Uv p, FaceHandle hint) {
    return delaunay.insert_by_swaps(p, hint, ConstantMetricRule{delaunay.uv_handle()});
  });
}

void order(benchmark::State& state) {
  const std::vector<Uv> points = random_points(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(spatial_order(points));
}

BENCHMARK(insert_by_cavity)
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(insert_by_swaps)
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(order)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
