// SPDX-License-Identifier: BSD-3-Clause
// Faces at a pole that no ring cuts off: a side of the domain whose nodes are one vertex.
#include <gtest/gtest.h>

#include "support/expect_valid.hh"
#include "support/models.hh"
#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"

namespace surfmesh {
namespace {

/// The boundary of a cone's one patch with the ring around its apex taken out again.
PatchBoundary boundary_with_pole(PatchBoundary boundary) {
  const PoleFan fan = boundary.fans.at(0);
  BoundaryLoop loop;
  for (const BoundaryNode& node : boundary.loops.at(0)) {
    if (node.vertex >= 0) {
      loop.push_back(node);
      if (node.contour >= 0) continue;
      loop.back().contour = fan.contour_to;
      loop.push_back({fan.sides.front(), fan.pole, -1});
      loop.push_back({fan.sides.back(), fan.pole, fan.contour_from});
    }
  }
  return {boundary.patch, {loop}, {}};
}

/// Two rows of faces along a loop, each half as far from the middle as the one before, and
/// triangles around the middle.
constexpr int kRows = 2;

std::unique_ptr<PolyMesh> mesh_within(const BoundaryLoop& loop, Uv middle, bool has_quads) {
  const int count = static_cast<int>(loop.size());
  FaceList faces;
  for (int k = 0; k < count; ++k) {
    const int next = (k + 1) % count;
    for (int from = 0; from < kRows * count; from += count) {
      const std::array outer = {from + k, from + next},
                       inner = {outer[0] + count, outer[1] + count};
      if (has_quads) {
        faces.add(std::array{outer[0], outer[1], inner[1], inner[0]});
      } else {
        faces.add(std::array{outer[0], outer[1], inner[1]});
        faces.add(std::array{outer[0], inner[1], inner[0]});
      }
    }
    faces.add(std::array{kRows * count + k, kRows * count + next, (kRows + 1) * count});
  }
  auto mesh = std::make_unique<PolyMesh>();
  const auto vertex_count = static_cast<std::size_t>((kRows + 1) * count + 1);
  build_faces(*mesh, vertex_count, faces, FirstSide::FromFirstCorner);
  const auto uv = attach(*mesh, keys::vertex_uv, middle);
  attach(*mesh, keys::vertex_metric, Metric{1, 0, 1});
  for (int row = 0; row <= kRows; ++row) {
    for (int k = 0; k < count; ++k) {
      mesh->property(uv, VertexHandle(row * count + k)) =
          lerp(loop[static_cast<std::size_t>(k)].uv, middle, 1 - std::pow(0.5, row));
    }
  }
  return mesh;
}

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
    model_.patches[0].is_reversed = GetParam().is_turned;
    const testing::UniformSizes fields(model_, 0.4);
    const auto nodes = place_contour_nodes(model_, fields).contours;
    const NodeNumbers numbers(model_, nodes);
    PatchBoundary boundary =
        boundary_with_pole(collect_boundary(model_, 0, nodes, numbers, fields[0]));
    const Domain domain = model_.surface(0).domain();
    auto mesh = mesh_within(boundary.loops[0], domain.at(0.5, 0.5), GetParam().has_quads);
    given_faces_ = mesh->n_faces();
    given_corners_ = mesh->n_halfedges() - boundary.loops[0].size();
    std::vector<PatchMesh> patches;
    patches.push_back(finish_patch(std::move(boundary), std::move(mesh), model_.surface(0)));
    report_ = assemble(mesh_, model_, nodes, numbers, std::move(patches));
  }

  Model model_ = testing::cone_of(1);
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
