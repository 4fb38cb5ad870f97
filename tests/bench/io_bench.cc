// SPDX-License-Identifier: BSD-3-Clause
//
// Time to write and to read a million triangles, by format. Marks: below 0.7 s to write a binary
// format, OBJ or PLY, below 2 s to write another text format, also with metrics at the corners, of
// which files for viewers and solvers have values.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/core/option_range.hh"
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

/// The same with contours between the patches, and with (u,v) and a metric at the corners.
const PolyMesh& wave_with_metric() {
  static const PolyMesh mesh = [] {
    PolyMesh result = wave();
    const auto uv = attach(result, keys::corner_uv);
    const auto metric = attach(result, keys::corner_metric);
    for (const HalfedgeHandle heh : result.halfedges()) {
      const OpenMesh::Vec3d& point = result.point(result.to_vertex_handle(heh));
      result.property(uv, heh) = {point[0], point[1]};
      result.property(metric, heh) = {9e3 + 1e3 * point[2], 1e2 * point[2], 8e3};
    }
    const auto patch = find(result, keys::face_patch);
    const auto contour = attach(result, keys::edge_contour, -1);
    for (const EdgeHandle eh : result.edges()) {
      const HalfedgeHandle heh = result.halfedge_handle(eh, 0);
      const auto patch_at = [&](HalfedgeHandle side) {
        return result.is_boundary(side) ? -1 : result.property(patch, result.face_handle(side));
      };
      const int a = patch_at(heh), b = patch_at(result.opposite_halfedge_handle(heh));
      if (a != b) result.property(contour, eh) = std::max(a, b);
    }
    return result;
  }();
  return mesh;
}

struct Format {
  const char* name;
  MshVersion msh = MshVersion::Binary41;
};

const Format kFormats[] = {{".obj"},
                           {".ply"},
                           {".off"},
                           {".stl"},
                           {".om"},
                           {".vtu"},
                           {".vtk"},
                           {".msh"},
                           {".msh", MshVersion::Text41},
                           {".msh", MshVersion::Binary22},
                           {".msh", MshVersion::Text22},
                           {".mesh"},
                           {".meshb"},
                           {".glb"},
                           {".inp"},
                           {".bdf"}};
constexpr int kAllFormats = 15;      // the last one
constexpr int kReadableFormats = 4;  // likewise

std::filesystem::path folder() {
  return std::filesystem::temp_directory_path() / "surfmesh_io_bench";
}

std::string path_of(const Format& format) { return (folder() / "a").string() + format.name; }

void write(benchmark::State& state) {
  const Format& format = kFormats[state.range(0)];
  const bool has_metric = state.range(1) != 0;
  const PolyMesh& mesh = has_metric ? wave_with_metric() : wave();
  std::filesystem::create_directories(folder());
  for (auto _ : state) write_mesh(mesh, path_of(format), {}, {.msh = format.msh});
  std::string label = format.name;
  if (format.name == std::string(".msh")) {
    label += std::string(" ") +
             std::string(ranges::kMsh.word_for(static_cast<double>(format.msh)).value_or(""));
  }
  state.SetLabel(label + (has_metric ? ", with metric" : ""));
  std::filesystem::remove_all(folder());
}
BENCHMARK(write)
    ->ArgsProduct({benchmark::CreateDenseRange(0, kAllFormats, 1), {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void read(benchmark::State& state) {
  const std::string path = path_of(kFormats[state.range(0)]);
  std::filesystem::create_directories(folder());
  write_mesh(wave(), path);
  for (auto _ : state) benchmark::DoNotOptimize(read_mesh(path));
  state.SetLabel(kFormats[state.range(0)].name);
  std::filesystem::remove_all(folder());
}
BENCHMARK(read)->DenseRange(0, kReadableFormats)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surfmesh
