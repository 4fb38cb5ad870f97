// SPDX-License-Identifier: BSD-3-Clause
//
// Processor time to write and to read a million triangles, by format. Mark: below 0.7 s to write
// OBJ or PLY.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

constexpr int kCells = 707;  // a side; two triangles each

/// A wave whose coordinates need all digits, with patches.
const PolyMesh& wave() {
  static const PolyMesh mesh = [] {
    const auto vertex = [](int i, int j) { return j * (kCells + 1) + i; };
    std::vector<std::array<int, 3>> triangles;
    for (int j = 0; j < kCells; ++j) {
      for (int i = 0; i < kCells; ++i) {
        triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
        triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
    }
    PolyMesh result;
    build_triangles(result, static_cast<std::size_t>((kCells + 1) * (kCells + 1)), triangles);
    for (int j = 0; j <= kCells; ++j) {
      for (int i = 0; i <= kCells; ++i) {
        const double x = i / 97.0, y = j / 89.0;
        result.set_point(VertexHandle(vertex(i, j)), {x, y, std::sin(x) * std::cos(y)});
      }
    }
    const auto patch = attach(result, keys::face_patch, 0);
    for (const FaceHandle fh : result.faces()) result.property(patch, fh) = fh.idx() / 1000;
    return result;
  }();
  return mesh;
}

const char* const kEndings[] = {".obj", ".ply", ".off", ".stl", ".om"};

std::string path_of(const benchmark::State& state) {
  const std::string ending = kEndings[state.range(0)];
  return (std::filesystem::temp_directory_path() / ("surfmesh_io_bench" + ending)).string();
}

void write(benchmark::State& state) {
  const PolyMesh& mesh = wave();
  const std::string path = path_of(state);
  for (auto _ : state) write_mesh(mesh, path);
  state.SetLabel(kEndings[state.range(0)]);
  std::filesystem::remove(path);
}
BENCHMARK(write)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);

void read(benchmark::State& state) {
  const std::string path = path_of(state);
  write_mesh(wave(), path);
  for (auto _ : state) benchmark::DoNotOptimize(read_mesh(path));
  state.SetLabel(kEndings[state.range(0)]);
  std::filesystem::remove(path);
}
BENCHMARK(read)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
