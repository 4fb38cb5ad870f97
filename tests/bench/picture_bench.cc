// SPDX-License-Identifier: BSD-3-Clause
//
// Time to draw a wave of more and more triangles in 900 × 600 pixels. Mark: about 2 s for a million
// triangles to PNG, with the time to read them.
#include <benchmark/benchmark.h>

#include <cmath>

#include "pictures/mesh_picture.hh"
#include "support/meshes.hh"

namespace surfmesh {
namespace {

PolyMesh wave(int cells) {
  PolyMesh mesh = testing::plane_grid(cells, cells);
  for (const VertexHandle vh : mesh.vertices()) {
    const auto& p = mesh.point(vh);
    const double x = 7 * p[0] / cells, y = 7 * p[1] / cells;
    mesh.set_point(vh, {x, y, std::sin(x) * std::cos(y)});
  }
  return mesh;
}

void draw(benchmark::State& state, PictureFormat format) {
  const PolyMesh mesh = wave(static_cast<int>(state.range(0)));
  PictureOptions options;
  options.colour = MeshField::Shape;
  std::size_t bytes = 0;
  for (auto _ : state) bytes = draw_mesh(mesh, {}, options, format).size();
  state.counters["triangles"] = static_cast<double>(mesh.n_faces());
  state.counters["bytes"] = static_cast<double>(bytes);
}

void BM_DrawPng(benchmark::State& state) { draw(state, PictureFormat::Png); }
void BM_DrawSvg(benchmark::State& state) { draw(state, PictureFormat::Svg); }

// 20,000 to 2 million triangles.
BENCHMARK(BM_DrawPng)
    ->Arg(100)
    ->Arg(224)
    ->Arg(500)
    ->Arg(707)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DrawSvg)->Arg(100)->Arg(224)->Arg(500)->Arg(707)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
