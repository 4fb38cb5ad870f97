// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of one surface evaluation, by kind of surface and order (the argument: 0, 1, 2).
#include <benchmark/benchmark.h>

#include <array>
#include <memory>
#include <vector>

#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/geometry/curvature.hh"
#include "surfmesh/geometry/plane_surface.hh"

namespace surfmesh {
namespace {

constexpr Domain kDomain{-6, 6, -6, 6};

/// Points that follow no pattern, few enough to stay in the cache.
std::vector<Uv> points() {
  std::vector<Uv> result;
  for (int i = 1; i <= 1024; ++i) {
    const double s = 0.6180339887498949 * i, t = 0.7548776662466927 * i;
    result.push_back(kDomain.at(s - static_cast<int>(s), t - static_cast<int>(t)));
  }
  return result;
}

void evaluate(benchmark::State& state, const Surface& surface) {
  const std::vector<Uv> at = points();
  const auto order = static_cast<Order>(state.range(0));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(surface.evaluate(at[i++ % at.size()], order));
  }
}

void plane(benchmark::State& state) {
  evaluate(state, PlaneSurface(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), kDomain));
}
BENCHMARK(plane)->DenseRange(0, 2);

const SurfaceFormulas kWave{"u", "v", "1.5*sin(2*u)*cos(v/5)*exp(-(u^2+v^2)/1000)"};

void formula_wave(benchmark::State& state) { evaluate(state, FormulaSurface(kWave, kDomain)); }
BENCHMARK(formula_wave)->DenseRange(0, 2);

void formula_sphere(benchmark::State& state) {
  evaluate(state, FormulaSurface({"cos(u)*cos(v)", "sin(u)*cos(v)", "sin(v)"}, kDomain));
}
BENCHMARK(formula_sphere)->DenseRange(0, 2);

void callable_wave(benchmark::State& state) {
  const auto surface = make_callable_surface(kDomain, [](auto u, auto v) {
    return std::array{u, v, 1.5 * sin(2 * u) * cos(v / 5) * exp(-(u * u + v * v) / 1000)};
  });
  evaluate(state, *surface);
}
BENCHMARK(callable_wave)->DenseRange(0, 2);

void curvature(benchmark::State& state) {
  const Jet jet = FormulaSurface(kWave, kDomain).evaluate({1, 2}, Order::Second);
  for (auto _ : state) {
    Jet input = jet;
    benchmark::DoNotOptimize(input);
    benchmark::DoNotOptimize(principal_curvatures(input));
  }
}
BENCHMARK(curvature);

}  // namespace
}  // namespace surfmesh
