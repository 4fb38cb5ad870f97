// SPDX-License-Identifier: BSD-3-Clause
// Whole runs, the making of the model included, over growing numbers of holes, of corners and of
// patches: the time per one of them is to stay about the same. The counter `items` is per second.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/models.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// h7. Not by +, of which g++ 12 warns falsely.
std::string numbered(const char* word, int i) {
  return std::string(word).append(std::to_string(i));
}

using testing::rectangle;

/// A plate of side × side squares of width 1, with a hole of radius 0.3 in each.
Model plate_with_holes(int side) {
  PatchInput plate{"p", rectangle(0, 0, side, side), {{"p:v0", "p:u1", "-p:v1", "-p:u0"}}};
  std::vector<ContourInput> contours;
  for (int i = 0; i < side * side; ++i) {
    const Uv centre{i % side + 0.5, i / side + 0.5};
    const auto circle = std::make_shared<CallableCurve>([centre](double t) {
      const double angle = 2 * std::numbers::pi * t;
      return centre + Uv{0.3 * std::cos(angle), 0.3 * std::sin(angle)};
    });
    contours.push_back({numbered("h", i), nullptr, {{"p", circle}}});
    plate.loops.push_back({std::string("-").append(contours.back().name)});
  }
  return model_from_patches({plate}, contours);
}

/// A star of seven points, as a polygon.
Model star(int corners) {
  const auto at = [corners](int i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double radius = 1 + 0.2 * std::sin(7 * angle);
    return Uv{radius * std::cos(angle), radius * std::sin(angle)};
  };
  PatchInput patch{"p", rectangle(-2, -2, 2, 2), {{}}};
  std::vector<ContourInput> contours;
  for (int i = 0; i < corners; ++i) {
    const auto side = std::make_shared<SegmentCurve>(at(i), at((i + 1) % corners));
    contours.push_back({numbered("c", i), nullptr, {{"p", side}}});
    patch.loops[0].push_back(contours.back().name);
  }
  return model_from_patches({patch}, contours);
}

Model squares(int side) {
  std::vector<PatchInput> patches;
  for (int i = 0; i < side * side; ++i) {
    const int u = i % side, v = i / side;
    patches.push_back({numbered("p", i), rectangle(u, v, u + 1, v + 1), {}});
  }
  return model_from_patches(patches, {});
}

void mesh_all(benchmark::State& state, Model (*make)(int), int argument, std::int64_t items) {
  PipelineOptions options;
  options.threads = 1;
  for (auto _ : state) benchmark::DoNotOptimize(mesh_model(make(argument), {}, options).mesh);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * items);
}

void holes(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  mesh_all(state, plate_with_holes, side, side * side);
}
BENCHMARK(holes)->RangeMultiplier(2)->Range(5, 40)->Unit(benchmark::kMillisecond);

void corners(benchmark::State& state) {
  mesh_all(state, star, static_cast<int>(state.range(0)), state.range(0));
}
BENCHMARK(corners)->RangeMultiplier(4)->Range(100, 6400)->Unit(benchmark::kMillisecond);

void patches(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  mesh_all(state, squares, side, side * side);
}
BENCHMARK(patches)->RangeMultiplier(2)->Range(10, 80)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
