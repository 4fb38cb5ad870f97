// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/surface_distance.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/cancelling.hh"
#include "support/errors.hh"
#include "support/meshes.hh"
#include "support/models.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/quality/project_mesh.hh"

namespace surfmesh {
namespace {

constexpr double kPi = std::numbers::pi;

/// A closed mesh of quads on the torus, n by n, from its parameters but without any.
PolyMesh torus_mesh(const Surface& torus, int n) {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      points.push_back(torus.evaluate({2 * kPi * i / n, 2 * kPi * j / n}, Order::Position).point);
      const int right = (i + 1) % n, up = (j + 1) % n;
      faces.push_back({j * n + i, j * n + right, up * n + right, up * n + i});
    }
  }
  return testing::mesh_of(points, faces);
}

/// Greatest difference of u or v within a face.
double greatest_step(const PolyMesh& mesh) {
  const auto uv_of = require(mesh, keys::corner_uv);
  double greatest = 0;
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    const Uv a = mesh.property(uv_of, heh);
    const Uv b = mesh.property(uv_of, mesh.next_halfedge_handle(heh));
    greatest = std::max({greatest, std::abs(a.u - b.u), std::abs(a.v - b.v)});
  }
  return greatest;
}

TEST(ProjectMesh, KeepsFacesOnOneSideOfASeam) {
  const Model model = testing::model_of({testing::whole_torus()});
  PolyMesh mesh = torus_mesh(*model.patches[0].surface, 24);
  project_mesh(mesh, {}, model, SurfaceSearch(model));
  EXPECT_NEAR(greatest_step(mesh), 2 * kPi / 24, 1e-6);
}

TEST(ProjectMesh, GoesByTheNamesOfPatchesAndGroups) {
  Model model = testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(0, 0, 1, 1)});
  model.groups.push_back({"the wing", {1}});
  for (const auto& [name, patch] :
       std::vector<std::pair<std::string, int>>{{"p0", 0}, {"p1", 1}, {"the_wing", 1}}) {
    PolyMesh mesh = testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    attach(mesh, keys::face_patch, 0);
    project_mesh(mesh, {name}, model, SurfaceSearch(model));
    EXPECT_EQ(mesh.property(find(mesh, keys::face_patch), FaceHandle(0)), patch) << name;
  }
}

/// A sheet folded at u = 0 like a hairpin: a cell of a mesh by `columns` × `rows` of its domain.
PolyMesh mesh_over(const Surface& surface, int columns, int rows) {
  const Domain domain = surface.domain();
  PolyMesh mesh = testing::plane_grid(columns, rows);
  for (const VertexHandle vh : mesh.vertices()) {
    const Vec3 at = to_eigen(mesh.point(vh));
    const Uv uv = domain.at(at.x() / columns, at.y() / rows);
    mesh.set_point(vh, to_openmesh(surface.evaluate(uv, Order::Position).point));
  }
  return mesh;
}

TEST(ProjectMesh, StaysOnTheSheetOfAHairpin) {
  const Model model =
      testing::model_of({make_callable_surface(Domain{-1, 1, 0, 1}, [](auto u, auto v) {
        return std::array{u * u, v, 0.004 * u};
      })});
  PolyMesh mesh = mesh_over(*model.patches[0].surface, 40, 5);
  const SurfaceSearch search(model);
  project_mesh(mesh, {}, model, search);
  const auto uv_of = require(mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.is_boundary(heh)) continue;
    const double z = mesh.point(mesh.to_vertex_handle(heh))[2];
    EXPECT_NEAR(mesh.property(uv_of, heh).u, z / 0.004, 1e-6);
  }
  EXPECT_TRUE(measure_distance(mesh, model, search, true).faults.empty());
}

TEST(MeasureDistance, TellsHowManyFacesCannotBeJudged) {
  const Model model = testing::model_of({testing::whole_torus()});
  PolyMesh mesh = torus_mesh(*model.patches[0].surface, 24);
  const SurfaceSearch search(model);
  project_mesh(mesh, {}, model, search);
  // As if the corners of a face had been found on the other side of the tube.
  const auto uv_of = require(mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh.fh_range(FaceHandle(100))) {
    mesh.property(uv_of, heh).v = std::fmod(mesh.property(uv_of, heh).v + kPi, 2 * kPi);
  }
  const SurfaceDistance distance = measure_distance(mesh, model, search, true);
  EXPECT_TRUE(distance.faults.empty());
  EXPECT_EQ(distance.unjudged, 1u);
}

// Klein's bottle: at its seam points have normals of either side, and the surface turns far across
// few faces.
TEST(MeasureDistance, CallsNoFaceTurnedAtTheSeamOfASurfaceWithOneSide) {
  const Model model =
      testing::model_of({make_callable_surface(Domain{0, 2 * kPi, 0, 2 * kPi}, [](auto u, auto v) {
        const auto way = 4.0 + cos(u / 2.0) * sin(v) - sin(u / 2.0) * sin(2.0 * v);
        return std::array{way * cos(u), way * sin(u),
                          sin(u / 2.0) * sin(v) + cos(u / 2.0) * sin(2.0 * v)};
      })});
  const SurfaceSearch search(model);
  for (const int count : {5, 6, 7, 8, 10, 12, 16, 24}) {
    PolyMesh mesh = mesh_over(*model.patches[0].surface, count, count);
    project_mesh(mesh, {}, model, search);
    const SurfaceDistance distance = measure_distance(mesh, model, search, true);
    EXPECT_TRUE(distance.faults.empty()) << count;
    EXPECT_LT(distance.unjudged, 2u * static_cast<std::size_t>(count)) << count;
  }
}

TEST(MeasureDistance, FindsTurnedFacesOfAProjectedMesh) {
  const Model model = testing::model_of({testing::rectangle(0, 0, 4, 4)});
  const SurfaceSearch search(model);
  PolyMesh mesh = testing::plane_grid(4, 4);
  mesh.set_point(VertexHandle(6), {2.5, 2.5, 0});
  project_mesh(mesh, {}, model, search);
  const SurfaceDistance distance = measure_distance(mesh, model, search, true);
  ASSERT_EQ(distance.faults.size(), 1u);
  EXPECT_EQ(distance.faults[0].kind, "turned_face");
}

TEST(MeasureDistance, CallsNoFaceTurnedThatFacesOneOfTwoSheetsInOnePlace) {
  // Beyond u = π / 6.4 the sheet lies on itself, turned over.
  const Model model =
      testing::model_of({make_callable_surface(Domain{0, 1, 0, 1}, [](auto u, auto v) {
        return std::array{sin(3.2 * u), v, 0 * u};
      })});
  PolyMesh mesh = mesh_over(*model.patches[0].surface, 32, 8);
  const SurfaceSearch search(model);
  project_mesh(mesh, {}, model, search);
  EXPECT_TRUE(measure_distance(mesh, model, search, true).faults.empty());
}

/// Set the u of the corners of a face as if nearest points had been found there.
template <class Find>
void move_corners(PolyMesh& mesh, FaceHandle fh, Find u_of) {
  const auto uv_of = require(mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
    double& u = mesh.property(uv_of, heh).u;
    u = u_of(u);
  }
}

TEST(MeasureDistance, CallsNoFaceTurnedWhereThePatchHasNoClearSide) {
  // As above; x < 0 is on one sheet only.
  const Model model =
      testing::model_of({make_callable_surface(Domain{0, 1, 0, 1}, [](auto u, auto v) {
        return std::array{sin(3.2 * u), v, 0 * u};
      })});
  constexpr int kColumns = 64, kRows = 8;
  PolyMesh mesh = mesh_over(*model.patches[0].surface, kColumns, kRows);
  const SurfaceSearch search(model);
  project_mesh(mesh, {}, model, search);
  for (const FaceHandle fh : mesh.faces()) {
    // The wrong sheet in five rows of eight.
    const bool is_wrong = fh.idx() / 2 / kColumns < 5;
    const bool is_left = fh.idx() / 2 % kColumns < kColumns / 2;
    move_corners(mesh, fh, [&](double u) {
      const double other = kPi / 3.2 - u;
      const bool has_two = other >= 0 && other <= 1, stays = (u < 0.5) == (is_left != is_wrong);
      return has_two && !stays ? other : u;
    });
  }
  const SurfaceDistance distance = measure_distance(mesh, model, search, true);
  EXPECT_TRUE(distance.faults.empty());
  EXPECT_GT(distance.unjudged, 0u);
}

TEST(MeasureDistance, CallsNoFaceTurnedWhoseNearestPointsAreAcrossABlade) {
  // Both sides of the blade meet at the corners of faces; between them, the other one is nearer.
  const Model model =
      testing::model_of({make_callable_surface(Domain{-1, 1, 0, 1}, [](auto u, auto v) {
        const auto wave = sin(4 * kPi * v);
        return std::array{u * u, v + 0 * u, 0.007 * u * wave * wave + 0.2 * v * (1.0 - v)};
      })});
  PolyMesh mesh = mesh_over(*model.patches[0].surface, 40, 4);
  const SurfaceSearch search(model);
  project_mesh(mesh, {}, model, search);
  for (int face = 50; face < 70; ++face) {
    const auto across = [](double u) { return -u; };
    move_corners(mesh, FaceHandle(face), across);
    const SurfaceDistance distance = measure_distance(mesh, model, search, true);
    EXPECT_TRUE(distance.faults.empty()) << face;
    move_corners(mesh, FaceHandle(face), across);
  }
}

TEST(MeasureDistance, FallsWithTheSquareOfTheElements) {
  const Model model = testing::model_of({testing::whole_torus()});
  const SurfaceSearch search(model);
  double before = 0;
  for (const int n : {16, 32, 64}) {
    PolyMesh mesh = torus_mesh(*model.patches[0].surface, n);
    project_mesh(mesh, {}, model, search);
    const SurfaceDistance distance = measure_distance(mesh, model, search, true);
    EXPECT_TRUE(distance.faults.empty());
    EXPECT_LT(distance.max_corner, 1e-9);
    EXPECT_LT(distance.mean, distance.max);
    if (before > 0) {
      EXPECT_NEAR(before / distance.max, 4, 0.4);
    }
    before = distance.max;
  }
}

TEST(MeasureDistance, AndProjectionEndOnceTheyAreCancelled) {
  const Model model = testing::model_of({testing::rectangle(0, 0, 4, 4)});
  const SurfaceSearch search(model);
  PolyMesh mesh = testing::plane_grid(4, 4);
  testing::Cancelling observer;
  const RunContext context(&observer);
  EXPECT_EQ(error_of([&] { measure_distance(mesh, model, search, false, context); }),
            testing::kCancelled);
  EXPECT_EQ(error_of([&] { project_mesh(mesh, {}, model, search, context); }), testing::kCancelled);
}

TEST(MeasureDistance, FindsTurnedFacesAndCornersOffTheSurface) {
  const Model model = testing::model_of({testing::rectangle(0, 0, 4, 4)});
  const SurfaceSearch search(model);
  PolyMesh mesh = testing::plane_grid(4, 4);
  EXPECT_TRUE(measure_distance(mesh, model, search, false).faults.empty());
  mesh.set_point(VertexHandle(6), {2.5, 2.5, 0});
  const SurfaceDistance bad = measure_distance(mesh, model, search, false);
  ASSERT_EQ(bad.faults.size(), 2u);
  EXPECT_EQ(bad.faults[0].kind, "turned_face");
  EXPECT_EQ(bad.faults[1].kind, "corner_off_surface");
  EXPECT_EQ(bad.faults[1].count, 6u);
  EXPECT_NEAR(bad.max_corner, 1.5 * std::numbers::sqrt2, 1e-12);
}

TEST(MeasureDistance, TakesPatchesThatAreTurnedAsAWhole) {
  const Model model = testing::model_of({testing::rectangle(0, 0, 1, 1)});
  PolyMesh mesh = testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 2, 1}});
  testing::attach_plane_properties(mesh);
  EXPECT_TRUE(measure_distance(mesh, model, SurfaceSearch(model), false).faults.empty());
}

TEST(MeasureDistance, RefusesPatchesThatTheModelDoesNotHave) {
  const Model model = testing::model_of({testing::rectangle(0, 0, 1, 1)});
  PolyMesh mesh = testing::plane_grid(1, 1);
  mesh.property(find(mesh, keys::face_patch), FaceHandle(1)) = 3;
  EXPECT_EQ(
      error_of([&] { measure_distance(mesh, model, SurfaceSearch(model), false); }),
      "invalid input: face 1 lies on patch 3, but the model has 1 patch, counted from 0; was the "
      "mesh made of another model, or with other options of its cages (patches, weld, "
      "scheme)?");
}

}  // namespace
}  // namespace surfmesh
