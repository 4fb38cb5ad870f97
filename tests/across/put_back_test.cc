// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/put_back.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "support/expect_valid.hh"
#include "support/meshes.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/core/validate.hh"

namespace surfmesh {
namespace {

constexpr int kColumns = 8, kRows = 4;

/// A grid whose left half is one patch, and its right half another one.
PolyMesh two_patches() {
  PolyMesh mesh = testing::plane_grid(kColumns, kRows);
  PolyMesh ordered;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> patches;
  for (const int patch : {0, 1}) {
    for (const FaceHandle fh : mesh.faces()) {
      if ((mesh.calc_face_centroid(fh)[0] < kColumns / 2) != (patch == 0)) continue;
      std::array<int, 3> triangle{};
      std::size_t k = 0;
      for_each_vertex_of(mesh, fh, [&](int vertex) { triangle[k++] = vertex; });
      triangles.push_back(triangle);
      patches.push_back(patch);
    }
  }
  build_triangles(ordered, mesh.n_vertices(), triangles);
  for (const VertexHandle vh : mesh.vertices()) ordered.set_point(vh, mesh.point(vh));
  testing::attach_plane_properties(ordered, {1, 0, 1});
  const auto patch_of = require(ordered, keys::face_patch);
  for (const FaceHandle fh : ordered.faces()) ordered.property(patch_of, fh) = patches[index(fh)];
  attach(ordered, keys::edge_contour, -1);
  return ordered;
}

VertexHandle vertex_at(int column, int row) { return VertexHandle(row * (kColumns + 1) + column); }

/// The six faces around a vertex inside the grid.
FacePiece faces_around(const PolyMesh& mesh, VertexHandle vh) {
  FacePiece piece;
  for (const FaceHandle fh : mesh.vf_range(vh)) piece.push_back(fh);
  std::sort(piece.begin(), piece.end());
  return piece;
}

SurfacePlace place_at(const Vec3& point, int patch) { return {patch, {point.x(), point.y()}}; }

/// A piece that is taken out and not changed yet; charts hold what is put back.
RegionWork take_out(const PolyMesh& mesh, const FacePiece& piece) {
  RegionWork work;
  work.region = cut_region(mesh, piece, std::vector<char>(mesh.n_edges(), 0));
  work.editor = std::make_unique<FaceEditor>(*work.region.mesh);
  for (const VertexHandle vh : work.region.mesh->vertices()) {
    VertexChart& chart = work.charts.emplace_back();
    chart.point = to_eigen(work.region.mesh->point(vh));
    chart.place = place_at(chart.point, 0);
    work.places.push_back(chart.place);
  }
  return work;
}

/// Give all faces of a region to a patch, with the (u,v) of a plane.
void finish(RegionWork& work, int patch) {
  work.faces.resize(work.editor->face_bound());
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    if (!work.editor->is_used(fh)) continue;
    FaceInPatch& face = work.faces[f];
    face.patch = patch;
    std::size_t k = 0;
    for_each_corner(*work.region.mesh, fh, [&](HalfedgeHandle heh) {
      const VertexChart& chart = work.charts[index(work.region.mesh->from_vertex_handle(heh))];
      face.metrics[k] = {1, 0, 1};
      face.uvs[k++] = {chart.point.x(), chart.point.y()};
    });
  }
}

/// The vertex inside a region of six triangles, and the others around it.
std::pair<VertexHandle, std::vector<VertexHandle>> middle_and_rim(const PolyMesh& mesh) {
  const auto middle = std::find_if(mesh.vertices_begin(), mesh.vertices_end(),
                                   [&](VertexHandle vh) { return !mesh.is_boundary(vh); });
  std::vector<VertexHandle> rim;
  for (const HalfedgeHandle heh : mesh.voh_range(*middle))
    rim.push_back(mesh.to_vertex_handle(heh));
  std::reverse(rim.begin(), rim.end());  // OpenMesh goes around clockwise
  return {*middle, rim};
}

/// Six faces around a vertex become four without it.
RegionWork without_middle(const PolyMesh& mesh, VertexHandle vh, int patch) {
  RegionWork work = take_out(mesh, faces_around(mesh, vh));
  const auto [middle, rim] = middle_and_rim(*work.region.mesh);
  FaceCycles fresh;
  for (std::size_t k = 1; k + 1 < rim.size(); ++k) fresh.add({rim[0], rim[k], rim[k + 1]});
  std::vector<FaceHandle> old(work.region.mesh->faces_begin(), work.region.mesh->faces_end()), made;
  work.editor->replace(old, fresh, made);
  finish(work, patch);
  return work;
}

/// Each of the six faces around a vertex is divided in three.
RegionWork with_middles(const PolyMesh& mesh, VertexHandle vh, int patch) {
  RegionWork work = take_out(mesh, faces_around(mesh, vh));
  const std::vector<FaceHandle> old(work.region.mesh->faces_begin(), work.region.mesh->faces_end());
  for (const FaceHandle fh : old) {
    std::vector<VertexHandle> cycle;
    Vec3 sum = Vec3::Zero();
    for_each_corner(*work.region.mesh, fh, [&](HalfedgeHandle heh) {
      cycle.push_back(work.region.mesh->from_vertex_handle(heh));
      sum += work.charts[index(cycle.back())].point;
    });
    const VertexHandle added = work.editor->add_vertex();
    VertexChart& chart = work.charts.emplace_back();
    chart.point = sum / 3;
    chart.place = place_at(chart.point, patch);
    FaceCycles fresh;
    for (std::size_t k = 0; k < 3; ++k) fresh.add({cycle[k], cycle[(k + 1) % 3], added});
    std::vector<FaceHandle> made;
    work.editor->replace(std::vector<FaceHandle>{fh}, fresh, made);
  }
  finish(work, patch);
  return work;
}

struct Back {
  PolyMesh mesh;
  PutBackReport report;
};

/// Put regions back into a copy of a mesh.
Back put_back_all(const PolyMesh& mesh, const std::vector<RegionWork>& works) {
  Back back{mesh, {}};
  std::vector<ReturningRegion> regions;
  for (const RegionWork& work : works) regions.emplace_back(work, back.mesh);
  back.report = put_back(regions, back.mesh);
  return back;
}

template <class... Works>
std::vector<RegionWork> list_of(Works... works) {
  std::vector<RegionWork> list;
  (list.push_back(std::move(works)), ...);
  return list;
}

/// Expect a proper mesh of the same plane, with corners that lie where their (u,v) say, and faces
/// in the order of their patches.
void expect_whole(const PolyMesh& mesh) {
  testing::expect_valid(mesh);
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto contour_of = require(mesh, keys::edge_contour);
  const auto patch_of = require(mesh, keys::face_patch);
  double area = 0;
  int patch = 0;
  for (const FaceHandle fh : mesh.faces()) {
    area += mesh.calc_sector_area(mesh.halfedge_handle(fh));
    EXPECT_GT(mesh.calc_face_normal(fh)[2], 0);
    EXPECT_LE(patch, mesh.property(patch_of, fh));
    patch = mesh.property(patch_of, fh);
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      const auto& point = mesh.point(mesh.to_vertex_handle(heh));
      EXPECT_EQ(mesh.property(uv_of, heh), (Uv{point[0], point[1]}));
    }
  }
  EXPECT_NEAR(area, kColumns * kRows, 1e-12);
  for (const EdgeHandle eh : mesh.edges()) EXPECT_EQ(mesh.property(contour_of, eh), -1);
  EXPECT_EQ(measure_topology(mesh).euler, 1);
}

TEST(PutBack, LeavesAMeshAsItIsIfNothingHasChanged) {
  const PolyMesh mesh = two_patches();
  RegionWork work = take_out(mesh, faces_around(mesh, vertex_at(2, 2)));
  finish(work, 0);
  const Back back = put_back_all(mesh, list_of(std::move(work)));
  expect_whole(back.mesh);
  ASSERT_EQ(back.mesh.n_faces(), mesh.n_faces());
  EXPECT_TRUE(back.report.numbers.empty());
  for (const VertexHandle vh : mesh.vertices()) {
    EXPECT_EQ(back.mesh.point(vh), mesh.point(vh));
    EXPECT_EQ(back.report.places[index(vh)].patch, -1);
  }
}

TEST(PutBack, LetsTheLastElementsCloseGaps) {
  const PolyMesh mesh = two_patches();
  const Back back = put_back_all(mesh, list_of(without_middle(mesh, vertex_at(2, 2), 0),
                                               without_middle(mesh, vertex_at(6, 1), 1)));
  expect_whole(back.mesh);
  EXPECT_EQ(back.mesh.n_vertices(), mesh.n_vertices() - 2);
  EXPECT_EQ(back.mesh.n_edges(), mesh.n_edges() - 6);
  EXPECT_EQ(back.mesh.n_faces(), mesh.n_faces() - 4);
  // Where vertices are by the report is where they are.
  for (const VertexHandle vh : mesh.vertices()) {
    if (vh == vertex_at(2, 2) || vh == vertex_at(6, 1)) continue;
    const VertexHandle now = back.report.now(vh);
    ASSERT_LT(index(now), back.mesh.n_vertices());
    EXPECT_EQ(back.mesh.point(now), mesh.point(vh));
  }
}

TEST(PutBack, MakesRoomForMoreElements) {
  const PolyMesh mesh = two_patches();
  const Back back = put_back_all(mesh, list_of(with_middles(mesh, vertex_at(2, 2), 0),
                                               with_middles(mesh, vertex_at(6, 1), 1)));
  expect_whole(back.mesh);
  EXPECT_EQ(back.mesh.n_vertices(), mesh.n_vertices() + 12);
  EXPECT_EQ(back.mesh.n_edges(), mesh.n_edges() + 36);
  EXPECT_EQ(back.mesh.n_faces(), mesh.n_faces() + 24);
  EXPECT_TRUE(back.report.numbers.empty());
  for (std::size_t v = mesh.n_vertices(); v < back.mesh.n_vertices(); ++v) {
    const auto& point = back.mesh.point(VertexHandle(static_cast<int>(v)));
    EXPECT_EQ(back.report.places[v].uv, (Uv{point[0], point[1]}));
  }
}

TEST(PutBack, GivesElementsOfOneRegionToAnother) {
  const PolyMesh mesh = two_patches();
  const Back back = put_back_all(mesh, list_of(with_middles(mesh, vertex_at(2, 2), 0),
                                               without_middle(mesh, vertex_at(6, 1), 1)));
  expect_whole(back.mesh);
  EXPECT_EQ(back.mesh.n_vertices(), mesh.n_vertices() + 5);
  EXPECT_EQ(back.mesh.n_faces(), mesh.n_faces() + 10);
}

TEST(PutBack, MovesFacesToTheirPatches) {
  const PolyMesh mesh = two_patches();
  const VertexHandle between = vertex_at(kColumns / 2, 2);
  const Back back = put_back_all(mesh, list_of(without_middle(mesh, between, 1)));
  expect_whole(back.mesh);
  const auto& patches = back.mesh.property(require(back.mesh, keys::face_patch)).data_vector();
  const auto before = static_cast<std::ptrdiff_t>(mesh.n_faces() / 2);
  EXPECT_EQ(std::count(patches.begin(), patches.end(), 0), before - 3);
  EXPECT_EQ(std::count(patches.begin(), patches.end(), 1), before + 1);
}

TEST(PutBack, JoinsRegionsThatTouch) {
  // The two share vertices and an edge of their borders.
  const PolyMesh mesh = two_patches();
  PolyMesh first;
  for (const int threads : {1, 4}) {
    Back back;
    with_threads(threads, [&] {
      back = put_back_all(mesh, list_of(without_middle(mesh, vertex_at(2, 2), 0),
                                        with_middles(mesh, vertex_at(4, 2), 1)));
    });
    expect_whole(back.mesh);
    if (threads == 1) {
      first = back.mesh;
      continue;
    }
    EXPECT_EQ(mesh_arrays(back.mesh).faces, mesh_arrays(first).faces);
  }
}

}  // namespace
}  // namespace surfmesh
