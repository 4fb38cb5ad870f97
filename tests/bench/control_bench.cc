// SPDX-License-Identifier: BSD-3-Clause
// Queries of the control space of the surface of eq. (7), its construction, the choice of its
// nodes. The marks, at 40,000 nodes: near the last one V_t 60 ns, V_o 220 ns, a grid 20 ns, at
// random V_t 200 ns; to build 80 ms, with classification 250 ms.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "support/waves.hh"
#include "surfmesh/control/control_cells.hh"
#include "surfmesh/control/control_grid.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/sampling/make_control.hh"
#include "surfmesh/sampling/sample_cells.hh"

namespace surfmesh {
namespace {

constexpr int kQueries = 1 << 16;
constexpr double kPi = 3.141592653589793;

SizeField paper_field() {
  static const auto surface = testing::paper_wave();
  return SizeField(*surface, resolve(testing::paper_sizing(), 1), {});
}

SurfacePoint query_at(const SizeField& field, double s, double t) {
  const Uv uv = field.surface().domain().at(s, t);
  const SizeField::Sample sample = field.at(uv);
  return {uv, sample.point, sample.form};
}

/// Points each a small step from the one before, along a curve through the whole domain.
std::vector<SurfacePoint> near_queries(const SizeField& field) {
  std::vector<SurfacePoint> queries;
  for (int i = 0; i < kQueries; ++i) {
    const double t = 2 * kPi * i / kQueries;
    queries.push_back(
        query_at(field, 0.5 + 0.49 * std::sin(31 * t), 0.5 + 0.49 * std::sin(37 * t)));
  }
  return queries;
}

std::vector<SurfacePoint> random_queries(const SizeField& field) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<SurfacePoint> queries;
  for (int i = 0; i < kQueries; ++i) {
    const double s = uniform(random);
    queries.push_back(query_at(field, s, uniform(random)));
  }
  return queries;
}

/// A field with a largest size of half a cell more than a tenth, so that regular nodes stay apart.
SizeField fine_field() {
  static const auto surface = testing::paper_wave();
  Sizing sizing = testing::paper_sizing();
  sizing.hmax = Length::units(0.2);
  return SizeField(*surface, resolve(sizing, 1), {});
}

std::vector<ControlNode> regular_nodes(const SizeField& field, std::int64_t nodes) {
  return choose_control_nodes(field, {static_cast<int>(nodes), 0.1}).nodes;
}

ControlMesh regular_control(const SizeField& field, std::int64_t nodes,
                            const ControlSpaceOptions& options) {
  return ControlMesh(field.surface().domain(), regular_nodes(field, nodes), options);
}

void ask(benchmark::State& state, const std::vector<SurfacePoint>& queries,
         const ControlSpace& control) {
  QueryHint hint;
  for (auto _ : state) {
    for (const SurfacePoint& q : queries) {
      benchmark::DoNotOptimize(control.metric(q, hint));
    }
  }
  state.SetItemsProcessed(state.iterations() * kQueries);
  state.counters["per_query"] = benchmark::Counter(
      kQueries, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <Interpolation interpolation>
void query_near_the_last(benchmark::State& state) {
  const SizeField field = fine_field();
  ask(state, near_queries(field),
      regular_control(field, state.range(0), {.interpolation = interpolation}));
}

template <Interpolation interpolation>
void query_at_random(benchmark::State& state) {
  const SizeField field = fine_field();
  ask(state, random_queries(field),
      regular_control(field, state.range(0), {.interpolation = interpolation}));
}

void query_grid_near_the_last(benchmark::State& state) {
  const SizeField field = fine_field();
  ask(state, near_queries(field),
      ControlGrid(field.surface().domain(), regular_nodes(field, state.range(0)), {}));
}

void query_grid_at_random(benchmark::State& state) {
  const SizeField field = fine_field();
  ask(state, random_queries(field),
      ControlGrid(field.surface().domain(), regular_nodes(field, state.range(0)), {}));
}

/// Cells that a fine field is represented by to a precision of 1 over the argument.
std::unique_ptr<ControlCells> fine_cells(const SizeField& field, std::int64_t fineness) {
  const auto sample = [&field](Uv uv) {
    const SizeField::Sample at = field.at(uv);
    return ControlNode{uv, at.point, at.form, at.size};
  };
  auto cells =
      std::make_unique<ControlCells>(field.surface().domain(), first_cells(field.surface()), sample,
                                     ControlSpaceOptions(), std::vector<ControlNode>());
  sample_cells(field, *cells, 1 / static_cast<double>(fineness), RunContext());
  return cells;
}

void query_cells_near_the_last(benchmark::State& state) {
  const SizeField field = fine_field();
  const auto cells = fine_cells(field, state.range(0));
  ask(state, near_queries(field), *cells);
  state.counters["nodes"] = static_cast<double>(cells->node_count());
}

void query_cells_at_random(benchmark::State& state) {
  const SizeField field = fine_field();
  const auto cells = fine_cells(field, state.range(0));
  ask(state, random_queries(field), *cells);
  state.counters["nodes"] = static_cast<double>(cells->node_count());
}

void halve_cells(benchmark::State& state) {
  const SizeField field = fine_field();
  double nodes = 0;
  for (auto _ : state) nodes = fine_cells(field, state.range(0))->node_count();
  state.counters["nodes"] = nodes;
}

void query_chosen_nodes_at_random(benchmark::State& state) {
  const SizeField field = paper_field();
  const ControlMesh control(field.surface().domain(), choose_control_nodes(field, {}).nodes, {});
  ask(state, random_queries(field), control);
  state.counters["nodes"] = static_cast<double>(control.mesh().n_vertices());
}

void build(benchmark::State& state, const ControlSpaceOptions& options) {
  const SizeField field = fine_field();
  const auto nodes = regular_nodes(field, state.range(0));
  std::size_t triangles = 0;
  for (auto _ : state) {
    triangles = ControlMesh(field.surface().domain(), nodes, options).mesh().n_faces();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

void build_ungraded(benchmark::State& state) { build(state, {}); }
void build_graded(benchmark::State& state) { build(state, {.grade = 1.5}); }
void build_classified(benchmark::State& state) {
  build(state, {.interpolation = Interpolation::Automatic});
}

void choose_nodes(benchmark::State& state) {
  const SizeField field = paper_field();
  std::size_t count = 0;
  for (auto _ : state) count = choose_control_nodes(field, {}).nodes.size();
  state.counters["nodes"] = static_cast<double>(count);
}

template <ControlKind kind>
void make_whole_control(benchmark::State& state) {
  const auto surface = testing::paper_wave();
  std::size_t count = 0;
  for (auto _ : state) {
    ControlInput input =
        collect_control_input(*surface, resolve(testing::paper_sizing(), 1), {}, {.kind = kind});
    const auto control = make_control(input);
    finish(*control);
    count = control->mesh().n_vertices();
  }
  state.counters["nodes"] = static_cast<double>(count);
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Arg(2'500)->Arg(10'000)->Arg(40'000)->Arg(160'000)->Unit(benchmark::kMillisecond);
}

BENCHMARK_TEMPLATE(query_near_the_last, Interpolation::Linear)->Apply(sizes);
BENCHMARK_TEMPLATE(query_near_the_last, Interpolation::Triangle)->Apply(sizes);
BENCHMARK_TEMPLATE(query_near_the_last, Interpolation::Circles)->Apply(sizes);
BENCHMARK_TEMPLATE(query_at_random, Interpolation::Linear)->Apply(sizes);
BENCHMARK_TEMPLATE(query_at_random, Interpolation::Triangle)->Apply(sizes);
BENCHMARK_TEMPLATE(query_at_random, Interpolation::Circles)->Apply(sizes);
BENCHMARK(query_grid_near_the_last)->Apply(sizes);
BENCHMARK(query_grid_at_random)->Apply(sizes);
BENCHMARK(query_chosen_nodes_at_random)->Unit(benchmark::kMillisecond);
BENCHMARK(build_ungraded)->Apply(sizes);
BENCHMARK(build_graded)->Apply(sizes);
BENCHMARK(build_classified)->Apply(sizes);
BENCHMARK(choose_nodes)->Unit(benchmark::kMillisecond);
BENCHMARK(query_cells_near_the_last)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(query_cells_at_random)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(halve_cells)->Arg(10)->Arg(30)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(make_whole_control, ControlKind::Cells)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(make_whole_control, ControlKind::Mesh)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(make_whole_control, ControlKind::Grid)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
