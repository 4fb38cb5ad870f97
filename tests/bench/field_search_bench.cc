// SPDX-License-Identifier: BSD-3-Clause
// Bounds of formulas, and the search for small sizes in the 256 cells of a patch.
#include <benchmark/benchmark.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "support/analytic.hh"
#include "support/waves.hh"
#include "surfmesh/formula/formula.hh"
#include "surfmesh/formula/formula_bounds.hh"
#include "surfmesh/sizes/field_search.hh"
#include "surfmesh/sizes/formula_field.hh"

namespace surfmesh {
namespace {

constexpr int kCells = 16;

const std::array<std::string, 5> kFormulas = {
    "0.002+0.098*min(1,abs(u-0.317)/0.02)", "0.002+0.098*min(1,abs(hypot(u-0.5,v-0.5)-0.3)/0.005)",
    "0.002+0.098*min(1,hypot(u-0.618,v-0.236)/0.0005)", "0.1+0.02*sin(6*u)*cos(5*v)",
    "0.1+0.02*(u*v+u-v*0.3+u*u-v/(2+u*u)+abs(u-v)*min(u,v))"};

const std::string& formula_of(const benchmark::State& state) {
  return kFormulas[static_cast<std::size_t>(state.range(0))];
}

void bound_formula(benchmark::State& state) {
  const FormulaProgram program = parse_formulas(std::span(&formula_of(state), 1), {"u", "v"});
  double u = 0.3;
  for (auto _ : state) {
    u = u > 0.4 ? 0.3 : u + 0.001;
    Interval result;
    bound(program, std::array{Interval{u, u + 0.01}, Interval{0.2, 0.3}}, std::span(&result, 1));
    benchmark::DoNotOptimize(result);
  }
  state.counters["operations"] = static_cast<double>(program.instructions().size());
}

void find_smaller(benchmark::State& state) {
  const test::PlanePatch surface(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY());
  PatchSources sources;
  sources.fields.push_back(formula_field(formula_of(state)));
  const SizeField field(surface, resolve(testing::sizing_of(0, 0.0001, 1, 2), 1), sources);
  std::size_t evaluations = 0;
  for (auto _ : state) {
    FieldSearch search(field);
    for (int k = 0; k < kCells * kCells; ++k) {
      const double u = double(k % kCells) / kCells, v = double(k / kCells) / kCells;
      benchmark::DoNotOptimize(
          search.find_smaller({{u, u + 1.0 / kCells}, {v, v + 1.0 / kCells}}, 0.05));
    }
    evaluations = search.evaluations();
  }
  state.counters["evaluations"] = static_cast<double>(evaluations);
}

BENCHMARK(bound_formula)->ArgName("formula")->DenseRange(0, 4);
BENCHMARK(find_smaller)->ArgName("formula")->DenseRange(0, 4)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace surfmesh
