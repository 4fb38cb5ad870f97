// SPDX-License-Identifier: BSD-3-Clause
// Whole runs with patches that are cut into tiles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/notices.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// Triangles of a tile, and the size of triangles: the models have at least two tiles then.
constexpr int kTile = 300;
constexpr double kSize = 0.02;

constexpr const char* kModelsOfTiles[] = {"cube.obj",    "sphere.json",  "torus.json",
                                          "klein.json",  "moebius.json", "perforated.json",
                                          "bracket.json"};

struct TilesCase {
  std::string file;  ///< in the folder of models
  bool has_quads = false;
};

void PrintTo(const TilesCase& a, std::ostream* out) {
  *out << a.file << (a.has_quads ? ", quads" : "");
}

std::vector<TilesCase> tiles_cases() {
  std::vector<TilesCase> all;
  for (const bool has_quads : {false, true}) {
    for (const char* file : kModelsOfTiles) all.push_back({file, has_quads});
  }
  return all;
}

std::string name_of(const TilesCase& a) {
  return a.file.substr(0, a.file.find('.')) + (a.has_quads ? "Quads" : "");
}

/// A model in elements of a size.
ModelInput input_of(const TilesCase& a) {
  ModelInput input = load_model(std::string(SURFMESH_SOURCE_DIR "/models/") + a.file);
  input.options.sizing.hmax = Length::share(kSize);
  input.options.quads.is_on = a.has_quads;
  return input;
}

MeshResult mesh_in_tiles(ModelInput& input, int tile = kTile) {
  input.options.tile = tile;
  return mesh_model(input.model, input.sources, input.options);
}

class RunsInTiles : public ::testing::TestWithParam<TilesCase> {
 protected:
  ModelInput input_ = input_of(GetParam());
};

TEST_P(RunsInTiles, MakeAProperMesh) {
  const MeshResult result = mesh_in_tiles(input_);
  testing::expect_valid(result.mesh);
  EXPECT_GT(result.report.tiles.count, input_.model.patches.size());
}

TEST_P(RunsInTiles, MakeTheTopologyOfWholePatches) {
  const MeshTopology whole = measure_topology(mesh_in_tiles(input_, 0).mesh);
  const MeshTopology tiles = measure_topology(mesh_in_tiles(input_).mesh);
  EXPECT_EQ(tiles.euler, whole.euler);
  EXPECT_EQ(tiles.is_closed, whole.is_closed);
  EXPECT_EQ(tiles.components, whole.components);
  EXPECT_EQ(tiles.boundary_edges, whole.boundary_edges);
  EXPECT_EQ(tiles.split_vertices, whole.split_vertices);
}

TEST_P(RunsInTiles, MakeAboutAsManyElementsAsWholePatches) {
  const auto whole = static_cast<double>(mesh_in_tiles(input_, 0).mesh.n_faces());
  const auto tiles = static_cast<double>(mesh_in_tiles(input_).mesh.n_faces());
  // Quads follow the boundaries of tiles.
  EXPECT_NEAR(tiles, whole, (GetParam().has_quads ? 0.1 : 0.02) * whole);
}

/// The mesh as a file.
std::string file_of(ModelInput& input, int threads) {
  const TestFolder folder;
  const std::string path = folder / "mesh.obj";
  input.options.threads = threads;
  write_mesh(mesh_in_tiles(input).mesh, path);
  return read_text(path);
}

TEST_P(RunsInTiles, MakeTheSameFileOnAnyNumberOfThreads) {
  const std::string alone = file_of(input_, 1);
  EXPECT_FALSE(alone.empty());
  EXPECT_TRUE(file_of(input_, 4) == alone);
}

TEST_P(RunsInTiles, MakeElementsOfGoodShape) {
  const MeshResult result = mesh_in_tiles(input_);
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
  if (GetParam().has_quads) {
    EXPECT_EQ(result.report.quads.inverted, 0u);
    EXPECT_GT(result.report.quads.min_jacobian, 0);
  } else {
    EXPECT_GE(result.report.quality.min, 0.5);
  }
}

TEST_P(RunsInTiles, KeepTheNodesOfContours) {
  const auto on_contours = [this](int tile) {
    const MeshResult result = mesh_in_tiles(input_, tile);
    const auto contour_of = require(result.mesh, keys::edge_contour);
    std::vector<std::array<double, 3>> points;
    for (const EdgeHandle eh : result.mesh.edges()) {
      if (result.mesh.property(contour_of, eh) < 0) continue;
      for (const int side : {0, 1}) {
        const auto& p =
            result.mesh.point(result.mesh.to_vertex_handle(result.mesh.halfedge_handle(eh, side)));
        points.push_back({p[0], p[1], p[2]});
      }
    }
    std::sort(points.begin(), points.end());
    return points;
  };
  input_.options.across.is_on = false;  // it dissolves contours between elements
  EXPECT_TRUE(on_contours(kTile) == on_contours(0));
}

INSTANTIATE_TEST_SUITE_P(Models, RunsInTiles, ::testing::ValuesIn(tiles_cases()),
                         [](const auto& test) { return name_of(test.param); });

// No patch has the vertex between the three holes.
TEST(HolesInTiles, LeaveVerticesOnTheirSurfaces) {
  const TestFolder folder;
  const std::string cube = read_text(SURFMESH_SOURCE_DIR "/models/cube.obj");
  write_text(folder / "cube.obj", cube + "t hole 1/0/0 0\nt hole 1/0/0 2\nt hole 1/0/0 4\n");
  ModelInput input = load_model(folder / "cube.obj");
  input.options.sizing.hmax = Length::share(kSize);
  input.options.across.is_on = false;
  const MeshResult result = mesh_in_tiles(input);
  EXPECT_GT(result.report.tiles.count, input.model.patches.size());
  testing::expect_valid(result.mesh);
  const auto patch_of = require(result.mesh, keys::face_patch);
  const auto uv_of = require(result.mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : result.mesh.halfedges()) {
    if (result.mesh.is_boundary(heh)) continue;
    const Surface& surface =
        input.model.surface(result.mesh.property(patch_of, result.mesh.face_handle(heh)));
    const Vec3 point = surface.evaluate(result.mesh.property(uv_of, heh), Order::Position).point;
    const Vec3 corner = to_eigen(result.mesh.point(result.mesh.to_vertex_handle(heh)));
    ASSERT_NEAR((corner - point).norm(), 0, 1e-9);
  }
}

class SagInTiles : public ::testing::TestWithParam<TilesCase> {};

TEST_P(SagInTiles, IsReached) {
  ModelInput input = input_of(GetParam());
  input.options.sizing.hmax = Sizing().hmax;
  input.options.sizing.sag = Length::share(0.005);
  const MeshResult result = mesh_in_tiles(input, 100);
  testing::expect_valid(result.mesh);
  EXPECT_GT(result.report.tiles.count, input.model.patches.size());
  ASSERT_TRUE(result.report.sag.reached);
  EXPECT_LE(*result.report.sag.reached, *result.report.sag.asked);
}

INSTANTIATE_TEST_SUITE_P(Models, SagInTiles, ::testing::ValuesIn(tiles_cases()),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace surfmesh
