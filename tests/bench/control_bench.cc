// SPDX-License-Identifier: BSD-3-Clause
// Queries of the control space of the surface of eq. (7), its construction, the choice of its
// nodes. The marks, at 40,000 nodes: 100 ns for a query near the last one; compare with a
// prototype's 45 ns, and 129 ns at random.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "support/waves.hh"
#include "surfmesh/control/make_control.hh"

namespace surfmesh {
namespace {

constexpr int kQueries = 1 << 16;
constexpr double kPi = 3.141592653589793;

/// A point asked for, and the first form there, which the caller has anyway.
struct Query {
  Uv uv;
  FirstFormFactor form;
};

SizeField paper_field() {
  static const auto surface = testing::paper_wave();
  return SizeField(*surface, testing::paper_sizing(), {}, 1);
}

Query query_at(const SizeField& field, double s, double t) {
  const Uv uv = field.surface().domain().at(s, t);
  return {uv, field.at(uv).form};
}

/// Points each a small step from the one before, along a curve through the whole domain.
std::vector<Query> near_queries(const SizeField& field) {
  std::vector<Query> queries;
  for (int i = 0; i < kQueries; ++i) {
    const double t = 2 * kPi * i / kQueries;
    queries.push_back(
        query_at(field, 0.5 + 0.49 * std::sin(31 * t), 0.5 + 0.49 * std::sin(37 * t)));
  }
  return queries;
}

std::vector<Query> random_queries(const SizeField& field) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Query> queries;
  for (int i = 0; i < kQueries; ++i) {
    const double s = uniform(random);
    queries.push_back(query_at(field, s, uniform(random)));
  }
  return queries;
}

ControlSpace regular_control(const SizeField& field, std::int64_t nodes) {
  return ControlSpace(field.surface().domain(),
                      choose_control_nodes(field, {static_cast<int>(nodes), 0.1}), 0);
}

void ask(benchmark::State& state, const std::vector<Query>& queries, const ControlSpace& control) {
  ControlSpace::Hint hint;
  for (auto _ : state) {
    for (const Query& q : queries) {
      benchmark::DoNotOptimize(control.metric(q.uv, q.form, hint));
    }
  }
  state.SetItemsProcessed(state.iterations() * kQueries);
  state.counters["per_query"] = benchmark::Counter(
      kQueries, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void query_near_the_last(benchmark::State& state) {
  const SizeField field = paper_field();
  ask(state, near_queries(field), regular_control(field, state.range(0)));
}

void query_at_random(benchmark::State& state) {
  const SizeField field = paper_field();
  ask(state, random_queries(field), regular_control(field, state.range(0)));
}

void query_chosen_nodes_at_random(benchmark::State& state) {
  const SizeField field = paper_field();
  const ControlSpace control(field.surface().domain(), choose_control_nodes(field, {}), 0);
  ask(state, random_queries(field), control);
  state.counters["nodes"] = static_cast<double>(control.mesh().n_vertices());
}

void build_control_space(benchmark::State& state) {
  const SizeField field = paper_field();
  const auto nodes = choose_control_nodes(field, {static_cast<int>(state.range(0)), 0.1});
  for (auto _ : state) {
    const ControlSpace control(field.surface().domain(), nodes, 1.5);
    benchmark::DoNotOptimize(control.mesh().n_faces());
  }
}

void choose_nodes(benchmark::State& state) {
  const SizeField field = paper_field();
  std::size_t count = 0;
  for (auto _ : state) count = choose_control_nodes(field, {}).size();
  state.counters["nodes"] = static_cast<double>(count);
}

void make_whole_control(benchmark::State& state) {
  const auto surface = testing::paper_wave();
  std::size_t count = 0;
  for (auto _ : state) {
    count = make_control(*surface, testing::paper_sizing(), {}, 1, {}).mesh().n_vertices();
  }
  state.counters["nodes"] = static_cast<double>(count);
}

BENCHMARK(query_near_the_last)
    ->Arg(2'500)
    ->Arg(10'000)
    ->Arg(40'000)
    ->Arg(160'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(query_at_random)
    ->Arg(2'500)
    ->Arg(10'000)
    ->Arg(40'000)
    ->Arg(160'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(query_chosen_nodes_at_random)->Unit(benchmark::kMillisecond);
BENCHMARK(build_control_space)->Arg(10'000)->Arg(40'000)->Unit(benchmark::kMillisecond);
BENCHMARK(choose_nodes)->Unit(benchmark::kMillisecond);
BENCHMARK(make_whole_control)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
