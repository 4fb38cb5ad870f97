// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/corner_normals.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/errors.hh"
#include "support/meshes.hh"
#include "support/models.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using testing::model_of;

/// A millionth of the angle by which a normal turns across a face, which is below a radian.
constexpr double kNear = 1e-6;

PolyMesh meshed(const Model& model, double size = 0.3, PipelineOptions options = {}) {
  options.sizing.size = Length::units(size);
  options.output.normals = true;
  return mesh_model(model, {}, options).mesh;
}

/// With a vertex of the mesh wherever patches meet.
PolyMesh meshed_by_patches(const Model& model, double size) {
  PipelineOptions options;
  options.across.is_on = false;
  return meshed(model, size, options);
}

PolyMesh meshed(const std::string& name, const CageOptions& cage = {}) {
  const std::filesystem::path path = std::filesystem::path(SURFMESH_SOURCE_DIR) / "models" / name;
  ModelInput input = load_model(path, {.cages = cage});
  input.options.output.normals = true;
  return mesh_model(input.model, input.sources, input.options).mesh;
}

Vec3 normal_at(const PolyMesh& mesh, HalfedgeHandle corner) {
  const Normal n = mesh.property(require(mesh, keys::corner_normal), corner);
  return {n.x, n.y, n.z};
}

Vec3 face_normal(const PolyMesh& mesh, FaceHandle fh) {
  return to_eigen(mesh.calc_face_normal(fh));
}

/// Call `visit` with the face, the position and the normal of each corner, which must be of unit
/// length.
template <class Visit>
void for_each_normal(const PolyMesh& mesh, Visit visit) {
  for (const HalfedgeHandle corner : mesh.halfedges()) {
    if (mesh.is_boundary(corner)) continue;
    const Vec3 normal = normal_at(mesh, corner);
    ASSERT_NEAR(normal.norm(), 1, 1e-15);
    visit(mesh.face_handle(corner), to_eigen(mesh.point(mesh.to_vertex_handle(corner))), normal);
  }
}

void expect_outside(const PolyMesh& mesh, double least_cosine) {
  for_each_normal(mesh, [&](FaceHandle fh, const Vec3&, const Vec3& normal) {
    EXPECT_GT(normal.dot(face_normal(mesh, fh)), least_cosine);
  });
}

/// The most different normals that a vertex has.
std::size_t most_normals(const PolyMesh& mesh) {
  std::size_t most = 0;
  for (const VertexHandle vh : mesh.vertices()) {
    std::vector<Vec3> different;
    for (const HalfedgeHandle corner : mesh.vih_range(vh)) {
      if (mesh.is_boundary(corner)) continue;
      const Vec3 normal = normal_at(mesh, corner);
      if (std::find(different.begin(), different.end(), normal) == different.end()) {
        different.push_back(normal);
      }
    }
    most = std::max(most, different.size());
  }
  return most;
}

TEST(CornerNormals, AreThoseOfASphereAtItsPolesToo) {
  const PolyMesh mesh = meshed(model_of({testing::sphere()}));
  for_each_normal(mesh, [&](FaceHandle, const Vec3& point, const Vec3& normal) {
    EXPECT_LT((normal - point).norm(), kNear) << point.transpose();
  });
  EXPECT_EQ(most_normals(mesh), 1u);
}

TEST(CornerNormals, AreThoseOfATorus) {
  const PolyMesh mesh = meshed(model_of({testing::whole_torus()}));
  double greatest = 0;
  for_each_normal(mesh, [&](FaceHandle, const Vec3& point, const Vec3& normal) {
    const Vec3 ring = 2 * Vec3(point.x(), point.y(), 0).normalized();
    greatest = std::max(greatest, (normal - (point - ring) / 0.5).norm());
  });
  EXPECT_LT(greatest, 1e-12);
  EXPECT_EQ(most_normals(mesh), 1u);
}

TEST(CornerNormals, AreTheSameWherePatchesMeetSmoothly) {
  const PolyMesh mesh = meshed(testing::cylinder_of(3));
  for_each_normal(mesh, [&](FaceHandle, const Vec3& point, const Vec3& normal) {
    EXPECT_LT((normal - Vec3(point.x(), point.y(), 0)).norm(), 1e-12);
  });
  EXPECT_EQ(most_normals(mesh), 1u);
}

TEST(CornerNormals, AreOnTheOutsideOfFacesOfAPatchThatIsTurned) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
  const PolyMesh mesh =
      meshed(model_of({testing::plane(Vec3::Zero(), x, y), testing::plane(x, y, x)}), 0.4);
  expect_outside(mesh, 1 - 1e-12);
  for_each_normal(mesh, [&](FaceHandle, const Vec3&, const Vec3& normal) {
    EXPECT_EQ(normal, normal_at(mesh, mesh.halfedge_handle(FaceHandle(0))));
  });
}

TEST(CornerNormals, OfACreaseAreThoseOfItsPatches) {
  const PolyMesh mesh = meshed("cube.obj", {.crease_angle = 30.0});
  expect_outside(mesh, 1 - 1e-9);
  EXPECT_EQ(most_normals(mesh), 3u);
}

TEST(CornerNormals, OfASmoothCageAreOneAtEachVertex) {
  const PolyMesh mesh = meshed("torus.obj");
  expect_outside(mesh, 0.5);
  EXPECT_EQ(most_normals(mesh), 1u);
}

/// An uneven fan of quads around vertex 0: the odd vertices are at its edges, the even ones at the
/// far corners of the faces.
Cage fan_of(int valence) {
  Cage cage;
  cage.points.push_back({0, 0, 0});
  for (int i = 0; i < 2 * valence; ++i) {
    const double angle = std::numbers::pi * i / valence;
    const double radius = i % 2 == 0 ? 1 : 1.4;
    cage.points.push_back({radius * std::cos(angle), radius * std::sin(angle),
                           -0.3 + 0.5 * std::sin(1.7 * i) * std::cos(angle)});
  }
  for (int i = 0; i < valence; ++i) {
    cage.faces.push_back({0, 2 * i + 1, 2 * i + 2, (2 * i + 2) % (2 * valence) + 1});
  }
  return cage;
}

/// The normal of the limit surface at vertex 0 of a fan.
/// Source   Halstead, Kass, DeRose, Efficient, fair interpolation using Catmull-Clark surfaces
///          (1993), appendix A
Vec3 limit_normal(const Cage& fan) {
  const int n = static_cast<int>(fan.faces.size());
  const double angle = 2 * std::numbers::pi / n;
  const double weight =
      1 + std::cos(angle) + std::cos(angle / 2) * std::sqrt(2 * (9 + std::cos(angle)));
  std::array<Vec3, 2> tangents = {Vec3::Zero(), Vec3::Zero()};
  for (int i = 0; i < n; ++i) {
    const Vec3& edge = fan.points[static_cast<std::size_t>(2 * i + 1)];
    const Vec3& corner = fan.points[static_cast<std::size_t>(2 * i + 2)];
    for (int k = 0; k < 2; ++k) {
      const double from = std::cos(angle * (i - k)), to = std::cos(angle * (i - k + 1));
      tangents[static_cast<std::size_t>(k)] += weight * from * edge + (from + to) * corner;
    }
  }
  return tangents[0].cross(tangents[1]).normalized();
}

TEST(CornerNormals, AtExtraordinaryVerticesAreThoseOfTheLimitSurface) {
  for (const int valence : {3, 5, 6, 8}) {
    const Cage cage = fan_of(valence);
    const PolyMesh mesh =
        meshed_by_patches(model_from_cage(cage, {.patches = PatchKind::Faces}), 0.2);
    const Vec3 exact = limit_normal(cage);
    std::size_t count = 0;
    for_each_normal(mesh, [&](FaceHandle, const Vec3& point, const Vec3& normal) {
      if (std::hypot(point.x(), point.y()) > 0.02) return;
      ++count;
      EXPECT_LT((normal - exact).norm(), 1e-4) << valence;
    });
    EXPECT_GE(count, 3u);
  }
}

TEST(CornerNormals, OfASharpCornerAreThoseInItsFaces) {
  Cage cage = fan_of(5);
  cage.points[0].z() = 3;
  cage.corners = {{0, 10}};
  const PolyMesh mesh =
      meshed_by_patches(model_from_cage(cage, {.patches = PatchKind::Faces}), 0.1);
  // The mean of all would be far from each of them.
  expect_outside(mesh, 0.7);
  EXPECT_GE(most_normals(mesh), 5u);
}

TEST(CornerNormals, AtExtraordinaryVerticesAreOne) {
  for (const char* name : {"cube.obj", "icosahedron.off"}) {
    EXPECT_EQ(most_normals(meshed(name)), 1u) << name;
  }
}

TEST(CornerNormals, AreOnTheOutsideOfFacesOfOneSidedSurfaces) {
  for (const char* name : {"moebius.json", "klein.json"}) expect_outside(meshed(name), 0.8);
}

TEST(CornerNormals, AtATipAreThoseInItsFaces) {
  const auto cone = std::make_shared<test::Cone>(1, Domain{0, 2 * std::numbers::pi, 0, 1});
  const PolyMesh mesh = meshed(model_of({cone}));
  for_each_normal(mesh, [&](FaceHandle fh, const Vec3& point, const Vec3& normal) {
    EXPECT_NEAR(std::abs(normal.z()), std::sqrt(0.5), 1e-9);
    if (point.norm() < kNear) {
      EXPECT_GT(normal.dot(face_normal(mesh, fh)), 0.97);
    }
  });
  EXPECT_GT(most_normals(mesh), 2u);
}

/// A surface that is a line, so that it has no normal anywhere.
Model line() {
  Model model;
  model.patches.push_back(
      {"line", testing::plane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitX()), {}, {}});
  return model;
}

PolyMesh one_face(const std::vector<Vec3>& points) {
  PolyMesh mesh = testing::mesh_of(points, {{0, 1, 2}});
  testing::attach_plane_properties(mesh);
  return mesh;
}

TEST(CornerNormals, AreThoseOfTheFaceWhereTheSurfaceHasNone) {
  PolyMesh mesh = one_face({{0, 0, 0}, {0, 1e-200, 0}, {1e-200, 0, 0}});
  attach_corner_normals(mesh, line());
  for_each_normal(mesh, [](FaceHandle, const Vec3&, const Vec3& normal) {
    EXPECT_EQ(std::abs(normal.z()), 1);
  });
}

TEST(CornerNormals, AreFiniteWhereNeitherSurfaceNorFaceHasOne) {
  PolyMesh mesh = one_face({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  attach_corner_normals(mesh, line());
  for_each_normal(mesh, [](FaceHandle, const Vec3&, const Vec3&) {});
}

TEST(CornerNormals, AreOnTheOtherSideOfAFaceThatGoesAroundClockwise) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1)});
  PolyMesh mesh = one_face({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}});
  attach_corner_normals(mesh, model);
  for_each_normal(
      mesh, [](FaceHandle, const Vec3&, const Vec3& normal) { EXPECT_EQ(normal, Vec3(0, 0, -1)); });
}

TEST(CornerNormals, AskForPatchesOfTheModelAndForParameters) {
  PolyMesh mesh = one_face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.property(require(mesh, keys::face_patch), FaceHandle(0)) = 1;
  EXPECT_EQ(error_of([&] { attach_corner_normals(mesh, line()); }),
            "invalid input: face 0 is of patch 1, which the model does not have");
  mesh.property(require(mesh, keys::face_patch), FaceHandle(0)) = 0;
  detach(mesh, keys::corner_uv);
  EXPECT_NE(error_of([&] { attach_corner_normals(mesh, line()); }), "no error");
  EXPECT_FALSE(find(mesh, keys::corner_normal).is_valid());
}

}  // namespace
}  // namespace surfmesh
