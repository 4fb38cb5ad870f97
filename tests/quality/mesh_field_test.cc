// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/mesh_field.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/errors.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

/// A square of two triangles and a quad beside it, in the plane (x, y) = (2 u, v), with sizes of
/// `along` in the direction of x and 1 across.
PolyMesh plane_mesh(double along) {
  PolyMesh mesh;
  std::vector<VertexHandle> vertices;
  for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}, {2., 0.}, {2., 1.}}) {
    vertices.push_back(mesh.add_vertex({x, y, 0}));
  }
  const auto& v = vertices;
  mesh.add_face(std::vector{v[0], v[1], v[2]});
  mesh.add_face(std::vector{v[0], v[2], v[3]});
  mesh.add_face(std::vector{v[1], v[4], v[5], v[2]});
  const auto patch_of = attach(mesh, keys::face_patch, 0);
  mesh.property(patch_of, FaceHandle(2)) = 1;
  const auto uv_of = attach(mesh, keys::corner_uv);
  const auto metric_of = attach(mesh, keys::corner_metric);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    const auto& point = mesh.point(mesh.to_vertex_handle(heh));
    mesh.property(uv_of, heh) = {0.5 * point[0], point[1]};
    mesh.property(metric_of, heh) = {4 / (along * along), 0, 1};
  }
  return mesh;
}

TEST(MeshField, TakesSizesFromTheMetricAndTheFaces) {
  const PolyMesh mesh = plane_mesh(0.25);
  for (const double size : measure_field(mesh, {}, MeshField::Size)) EXPECT_NEAR(size, 0.5, 1e-12);
  for (const double stretch : measure_field(mesh, {}, MeshField::Stretch)) {
    EXPECT_NEAR(stretch, 4, 1e-12);
  }
}

TEST(MeshField, TakesTheSideThatIsFarthestFromOne) {
  EXPECT_EQ(measure_field(plane_mesh(0.25), {}, MeshField::Length)[2], 4);
  EXPECT_EQ(measure_field(plane_mesh(8), {}, MeshField::Length)[2], 0.125);
}

TEST(MeshField, TellsShapesInSpaceAndInTheMetric) {
  const PolyMesh mesh = plane_mesh(0.25);
  const std::vector<double> shapes = measure_field(mesh, {}, MeshField::Shape);
  const std::vector<double> qualities = measure_field(mesh, {}, MeshField::Quality);
  // Of a right triangle with legs a and b: 2√3 ab / 2(a² + b²).
  EXPECT_NEAR(shapes[0], std::sqrt(3.0) / 2, 1e-12);
  EXPECT_NEAR(qualities[0], std::sqrt(3.0) * 4 / 17, 1e-12);
  EXPECT_NEAR(shapes[2], 1, 1e-12);
  EXPECT_NEAR(qualities[2], 1, 1e-12);
}

TEST(MeshField, CountsEdgesAtVertices) {
  EXPECT_EQ(measure_field(plane_mesh(1), {}, MeshField::Valence),
            (std::vector<double>{3, 3, 4, 2, 2, 2}));
}

TEST(MeshField, GivesPatchesTheirFirstGroup) {
  const MeshNames names = {{"a", "b"}, {{"one", {1}}, {"two", {1}}}};
  const PolyMesh mesh = plane_mesh(1);
  EXPECT_EQ(measure_field(mesh, names, MeshField::Patch), (std::vector<double>{0, 0, 1}));
  const std::vector<double> groups = measure_field(mesh, names, MeshField::Group);
  EXPECT_TRUE(std::isnan(groups[0]));
  EXPECT_EQ(groups[2], 0);
}

TEST(MeshField, GivesGroupsToPatchesOfAnyNumber) {
  PolyMesh mesh = plane_mesh(1);
  const int large = std::numeric_limits<int>::max();
  const auto patch_of = require(mesh, keys::face_patch);
  mesh.property(patch_of, FaceHandle(0)) = large;
  mesh.property(patch_of, FaceHandle(1)) = -1;
  const MeshNames names = {{}, {{"one", {1, -7}}, {"two", {large}}}};
  const std::vector<double> groups = measure_field(mesh, names, MeshField::Group);
  EXPECT_EQ(groups[0], 1);
  EXPECT_TRUE(std::isnan(groups[1]));
  EXPECT_EQ(groups[2], 0);
}

TEST(MeshField, IsThereWhereTheMeshHasWhatItNeeds) {
  PolyMesh mesh = plane_mesh(1);
  EXPECT_TRUE(has_field(mesh, {}, MeshField::Quality));
  EXPECT_FALSE(has_field(mesh, {}, MeshField::Group));
  EXPECT_FALSE(has_field(mesh, {}, MeshField::Sag));
  EXPECT_EQ(error_of([&] { measure_field(mesh, {}, MeshField::Sag); }),
            "missing property: the mesh has no property surf:sag, which the stage pipeline makes");
  attach(mesh, keys::face_sag, 0.25);
  EXPECT_EQ(measure_field(mesh, {}, MeshField::Sag), (std::vector<double>{0.25, 0.25, 0.25}));
  detach(mesh, keys::corner_metric);
  EXPECT_FALSE(has_field(mesh, {}, MeshField::Stretch));
  EXPECT_TRUE(has_field(mesh, {}, MeshField::Shape));
}

TEST(MeshField, IsFoundByItsName) {
  for (const FieldDescription& field : mesh_fields()) {
    EXPECT_EQ(find_mesh_field(field.name).field, field.field);
    EXPECT_EQ(describe(field.field).name, field.name);
  }
  EXPECT_EQ(
      error_of([] { find_mesh_field("colour"); }),
      "invalid input: a mesh has no field \"colour\": there are patch, group, quality, shape, "
      "size, stretch, length, valence, sag");
}

}  // namespace
}  // namespace surfmesh
