// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vertex_metric.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/errors.hh"
#include "support/meshes.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

/// One triangle with the given parameters at its corners and one metric.
PolyMesh triangle(const std::vector<Vec3>& points, const std::vector<Uv>& uvs, Metric m) {
  PolyMesh mesh = testing::mesh_of(points, {{0, 1, 2}});
  attach(mesh, keys::face_patch, 0);
  const auto uv = attach(mesh, keys::corner_uv);
  const auto metric = attach(mesh, keys::corner_metric);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.is_boundary(heh)) continue;
    mesh.property(uv, heh) = uvs[index(mesh.to_vertex_handle(heh))];
    mesh.property(metric, heh) = m;
  }
  return mesh;
}

void expect_near(const SpaceMetric& metric, const SpaceMetric& expected) {
  for (std::size_t i = 0; i < metric.size(); ++i) {
    EXPECT_NEAR(metric[i], expected[i], 1e-12 * std::abs(expected[0])) << i;
  }
}

/// The plane y = 0 with x = 2u and z = 5v, and sizes 1/2 along x, 1/8 along z: across the plane the
/// metric asks for their mean, 1/4.
TEST(VertexMetrics, AreTheMetricInSpace) {
  const PolyMesh mesh =
      triangle({{0, 0, 0}, {2, 0, 0}, {2, 0, 5}}, {{0, 0}, {1, 0}, {1, 1}}, {4 * 4, 0, 25 * 64});
  const auto metrics = vertex_metrics(mesh);
  ASSERT_EQ(metrics.size(), 3U);
  for (const SpaceMetric& metric : metrics) {
    expect_near(metric, {4, 16, 64, 0, 0, 0});
    EXPECT_NEAR(size_of(metric), 0.25, 1e-12);
  }
}

/// Steps have the same metric length in space as in the parameters, however these are turned.
TEST(VertexMetrics, KeepTheLengthsOfSides) {
  const std::vector<Vec3> points = {{0, 1, 0}, {1, 3, 1}, {-1, 2, 4}};
  const std::vector<Uv> uvs = {{0.5, 0.25}, {0.75, 1}, {-1, 0.5}};
  const Metric m = {3, -1, 2};
  const auto metrics = vertex_metrics(triangle(points, uvs, m));
  const auto& [m11, m22, m33, m21, m32, m31] = metrics[1];
  const Vec3 e = points[2] - points[1];
  const Uv step = uvs[2] - uvs[1];
  EXPECT_NEAR(m11 * e.x() * e.x() + m22 * e.y() * e.y() + m33 * e.z() * e.z() +
                  2 * (m21 * e.x() * e.y() + m31 * e.x() * e.z() + m32 * e.y() * e.z()),
              m.m11 * step.u * step.u + 2 * m.m12 * step.u * step.v + m.m22 * step.v * step.v,
              1e-12);
}

TEST(VertexMetrics, AreThoseOfAllSizesWhereNoFaceHasAny) {
  PolyMesh mesh = triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0}, {1, 0}, {0, 1}}, {4, 0, 4});
  mesh.add_vertex({5, 5, 5});
  expect_near(vertex_metrics(mesh)[3], {4, 4, 4, 0, 0, 0});
}

TEST(VertexMetrics, CannotBeMadeOnFlatFacesOnly) {
  const PolyMesh mesh =
      triangle({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 0}, {1, 0}, {2, 0}}, {4, 0, 4});
  EXPECT_EQ(error_of([&] { vertex_metrics(mesh); }),
            "geometry: no corner of the mesh has a metric that is positive definite on its face");
}

TEST(VertexMetrics, NeedParametersAndMetric) {
  EXPECT_FALSE(has_vertex_metrics(testing::octahedron()));
  EXPECT_EQ(error_of([] { vertex_metrics(testing::octahedron()); }).substr(0, 17),
            "missing property:");
}

}  // namespace
}  // namespace surfmesh
