// SPDX-License-Identifier: BSD-3-Clause
// Sizes of background meshes at random points of a wavy surface and of a cube.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "surfmesh/sizes/background_sizes.hh"

namespace surfmesh {
namespace {

Vec3 on_surface(double u, double v) { return {u, v, 0.1 * std::sin(6 * u) * std::cos(5 * v)}; }

/// n × n squares of two triangles.
BackgroundMesh surface_mesh(int n) {
  BackgroundMesh mesh;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) mesh.points.push_back(on_surface(double(i) / n, double(j) / n));
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + n + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

/// n × n × n cubes of six tetrahedra.
BackgroundMesh solid_mesh(int n) {
  BackgroundMesh mesh;
  const int row = n + 1, layer = row * row;
  for (int k = 0; k <= n; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) mesh.points.push_back(Vec3(i, j, k) / n);
    }
  }
  for (int at = 0; at < layer * row; ++at) {
    if (at % row == n || at / row % row == n || at / layer == n) continue;
    const int ends[6][2] = {{1, 1 + row},         {row, 1 + row},     {row, row + layer},
                            {layer, row + layer}, {layer, 1 + layer}, {1, 1 + layer}};
    for (const auto& [a, b] : ends) {
      mesh.tetrahedra.push_back({at, at + a, at + b, at + 1 + row + layer});
    }
  }
  return mesh;
}

std::vector<Vec3> places(bool is_solid) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < 100'000; ++i) {
    const double u = share(random), v = share(random);
    points.push_back(is_solid ? Vec3(u, v, share(random)) : on_surface(u, v));
  }
  return points;
}

BackgroundMesh mesh_of(const benchmark::State& state, bool is_solid) {
  const auto count = static_cast<double>(state.range(0));
  return is_solid ? solid_mesh(static_cast<int>(std::lround(std::cbrt(count / 6))))
                  : surface_mesh(static_cast<int>(std::lround(std::sqrt(count / 2))));
}

void size(benchmark::State& state, bool is_solid) {
  BackgroundMesh mesh = mesh_of(state, is_solid);
  for (const Vec3& p : mesh.points) mesh.sizes.push_back(0.1 + p.x());
  const BackgroundSizes sizes(std::move(mesh), BackgroundIn::Space);
  const std::vector<Vec3> points = places(is_solid);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(sizes.size(points[i++ % points.size()]));
}

void metric(benchmark::State& state, bool is_solid) {
  BackgroundMesh mesh = mesh_of(state, is_solid);
  for (const Vec3& p : mesh.points) mesh.metrics.push_back({1 + p.x(), 2, 3, 0.1, 0.2, 0.3});
  const BackgroundSizes sizes(std::move(mesh), BackgroundIn::Space);
  const std::vector<Vec3> points = places(is_solid);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(sizes.metric(points[i++ % points.size()]));
}

void build(benchmark::State& state, bool is_solid) {
  BackgroundMesh mesh = mesh_of(state, is_solid);
  for (const Vec3& p : mesh.points) mesh.sizes.push_back(0.1 + p.x());
  for (auto _ : state) {
    benchmark::DoNotOptimize(BackgroundSizes(mesh, BackgroundIn::Space));
  }
}

void of_all_numbers(benchmark::internal::Benchmark* b) {
  for (const int count : {1'000, 10'000, 100'000, 1'000'000}) b->Arg(count);
}

BENCHMARK_CAPTURE(size, triangles, false)->Apply(of_all_numbers);
BENCHMARK_CAPTURE(size, tetrahedra, true)->Apply(of_all_numbers);
BENCHMARK_CAPTURE(metric, triangles, false)->Apply(of_all_numbers);
BENCHMARK_CAPTURE(metric, tetrahedra, true)->Apply(of_all_numbers);
BENCHMARK_CAPTURE(build, triangles, false)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, tetrahedra, true)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
