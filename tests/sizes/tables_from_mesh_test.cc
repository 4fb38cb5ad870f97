// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/tables_from_mesh.hh"

#include <gtest/gtest.h>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

/// Two triangles of two patches with one common side.
PolyMesh two_patches() {
  PolyMesh mesh;
  std::vector<VertexHandle> v;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
    v.push_back(mesh.add_vertex(to_openmesh(Vec3(x, y, 0))));
  }
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[0], v[2], v[3]);
  const auto patch = attach(mesh, keys::face_patch);
  const auto uv = attach(mesh, keys::corner_uv);
  const auto metric = attach(mesh, keys::corner_metric);
  for (const FaceHandle fh : mesh.faces()) {
    mesh.property(patch, fh) = fh.idx();
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      const Vec3 p = to_eigen(mesh.point(mesh.to_vertex_handle(heh)));
      mesh.property(uv, heh) = {p.x() + fh.idx(), p.y()};
      mesh.property(metric, heh) = {4, 0, 9};
    }
  }
  return mesh;
}

TEST(TablesFromMesh, HaveARowForEachVertexOfAPatch) {
  const auto tables = tables_from_mesh(two_patches());
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[1].patch, 1);
  ASSERT_EQ(tables[1].nodes.size(), 3u);
  for (const TableNode& node : tables[1].nodes) {
    EXPECT_GE(node.uv.u, 1);
    EXPECT_EQ(node.metric, (Metric{4, 0, 9}));
  }
}

TEST(TablesFromMesh, NeedTheMetric) {
  PolyMesh mesh = two_patches();
  detach(mesh, keys::corner_metric);
  EXPECT_THROW(tables_from_mesh(mesh), Error);
}

}  // namespace
}  // namespace surfmesh
