// SPDX-License-Identifier: BSD-3-Clause
// Faces at a pole that no ring cuts off: a side of the domain whose nodes are one vertex.
#include <gtest/gtest.h>

#include "support/expect_valid.hh"
#include "support/pole_in_mesh.hh"
#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"

namespace surfmesh {
namespace {

struct Case {
  bool has_quads = false;
  bool is_turned = false;
};

void PrintTo(const Case& a, std::ostream* out) {
  *out << (a.has_quads ? "quads" : "triangles") << (a.is_turned ? ", turned" : "");
}

class ConeWithoutRing : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    testing::PoleInMesh cone(GetParam().has_quads, GetParam().is_turned);
    given_faces_ = cone.patches[0].mesh->n_faces();
    given_corners_ = cone.patches[0].mesh->n_halfedges() - cone.patches[0].boundary.loops[0].size();
    report_ = assemble(mesh_, cone.model, cone.nodes, cone.numbers, std::move(cone.patches));
    model_ = std::move(cone.model);
  }

  Model model_;
  std::size_t given_faces_ = 0, given_corners_ = 0;
  AssembleReport report_;
  PolyMesh mesh_;
};

TEST_P(ConeWithoutRing, IsAProperMesh) {
  testing::expect_valid(mesh_);
  EXPECT_TRUE(report_.notices.empty());
  const MeshTopology topology = measure_topology(mesh_);
  EXPECT_EQ(topology.euler, 1);
  EXPECT_EQ(topology.components, 1u);
  for (const VertexHandle vh : mesh_.vertices()) EXPECT_FALSE(mesh_.is_isolated(vh));
}

TEST_P(ConeWithoutRing, LosesATriangleAtThePoleOrACornerOfAQuad) {
  const bool has_quads = GetParam().has_quads;
  EXPECT_EQ(mesh_.n_faces(), has_quads ? given_faces_ : given_faces_ - 1);
  std::size_t corners = 0;
  for (const FaceHandle fh : mesh_.faces()) corners += mesh_.valence(fh);
  EXPECT_EQ(corners, has_quads ? given_corners_ - 1 : given_corners_ - 3);
}

TEST_P(ConeWithoutRing, HasCornersWithTheParametersOfTheirPlace) {
  const auto uv = require(mesh_, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh_.halfedges()) {
    if (mesh_.is_boundary(heh)) continue;
    const Vec3 place = model_.surface(0).evaluate(mesh_.property(uv, heh), Order::Position).point;
    EXPECT_LT((place - to_eigen(mesh_.point(mesh_.to_vertex_handle(heh)))).norm(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, ConeWithoutRing,
                         ::testing::Values(Case{false, false}, Case{false, true}, Case{true, false},
                                           Case{true, true}));

}  // namespace
}  // namespace surfmesh
