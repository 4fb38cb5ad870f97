// SPDX-License-Identifier: BSD-3-Clause
// How often sizes hidden in small features are found: the share that `found` counts, by the kind of
// feature and its width in thousandths of the domain. Time is that of one scan.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "support/analytic.hh"
#include "support/waves.hh"
#include "surfmesh/sizes/hidden_sizes.hh"

namespace surfmesh {
namespace {

enum Kind { Band, Ring, Spot, Bell };

using Size = std::function<double(Uv)>;

/// A feature at a random place. Sizes are 0.1 outside and fall to 0.002 over half the width, or
/// like a bell.
Size random_feature(Kind kind, double width, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const double angle = std::numbers::pi * share(random), radius = 0.05 + 0.35 * share(random);
  const Uv at = {share(random), share(random)};
  return [=](Uv uv) {
    const double u = uv.u - at.u, v = uv.v - at.v;
    const double distance = kind == Band   ? std::cos(angle) * u + std::sin(angle) * v
                            : kind == Ring ? std::hypot(u, v) - radius
                                           : std::hypot(u, v);
    const double x = 2 * std::abs(distance) / width;
    return 0.1 - 0.098 * (kind == Bell ? std::exp(-x * x) : std::max(0.0, 1 - x));
  };
}

void hidden_sizes(benchmark::State& state) {
  const test::PlanePatch surface(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY());
  const ResolvedSizing sizing = resolve(testing::sizing_of(0, 0.0001, 1, 2), 1);
  std::mt19937 random(1);
  double found = 0;
  for (auto _ : state) {
    const auto kind = static_cast<Kind>(state.range(0));
    const Size size = random_feature(kind, 0.001 * static_cast<double>(state.range(1)), random);
    PatchSources sources;
    sources.fields.push_back({0, [&](Uv uv, const Vec3&) { return size(uv); }});
    found += find_hidden(SizeField(surface, sizing, sources)).empty() ? 0 : 1;
  }
  state.counters["found"] = benchmark::Counter(found, benchmark::Counter::kAvgIterations);
}

BENCHMARK(hidden_sizes)
    ->ArgNames({"kind", "width"})
    ->ArgsProduct({{Band, Ring, Spot, Bell}, {1, 3, 10}})
    ->Iterations(1000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
