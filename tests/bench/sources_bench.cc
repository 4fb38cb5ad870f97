// SPDX-License-Identifier: BSD-3-Clause
// SizeField::at on the surface of eq. (7) with segments of sizes along a spiral; curvature alone is
// the first row.
#include <benchmark/benchmark.h>

#include <cmath>

#include "support/waves.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {
namespace {

/// Segments that follow each other on a spiral around the origin, some stretched along it.
std::shared_ptr<const SourceTree> spiral(int count, double ratio) {
  std::vector<PlacedSize> sizes;
  const auto at = [count](int i) -> Vec3 {
    const double t = std::sqrt(static_cast<double>(i) / count), angle = 60 * t;
    return {6 * t * std::cos(angle), 6 * t * std::sin(angle), 0};
  };
  for (int i = 0; i < count; ++i) {
    PlacedSize placed;
    placed.from = at(i);
    placed.to = at(i + 1);
    const double size = 0.05 + 0.03 * std::sin(0.01 * i);
    placed.at_from = placed.at_to = {size, ratio * size};
    placed.follows_segment = true;
    sizes.push_back(placed);
  }
  return std::make_shared<SourceTree>(std::move(sizes), 1.5);
}

void field_at(benchmark::State& state) {
  const auto surface = testing::paper_wave();
  PatchSources sources;
  if (state.range(0) > 0) {
    sources.trees.push_back(
        spiral(static_cast<int>(state.range(0)), static_cast<double>(state.range(1))));
  }
  const SizeField field(*surface, resolve(testing::paper_sizing(), 1), sources);
  double s = 0.1, t = 0.2, whole = 0;
  for (auto _ : state) {
    s = std::modf(s + 0.7548776662466927, &whole);
    t = std::modf(t + 0.5698402909980532, &whole);
    benchmark::DoNotOptimize(field.at(surface->domain().at(s, t)));
  }
}

BENCHMARK(field_at)->ArgNames({"sources", "ratio"})->ArgsProduct({{0}, {1}});
BENCHMARK(field_at)->ArgNames({"sources", "ratio"})->ArgsProduct({{10, 1000, 100'000}, {1, 2}});

}  // namespace
}  // namespace surfmesh
