// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/renumber.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/expect_valid.hh"
#include "surfmesh/core/topology.hh"

namespace surfmesh {
namespace {

/// A square of n × n squares, two triangles each.
void build_square(PolyMesh& mesh, int n) {
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
  build_triangles(mesh, static_cast<std::size_t>((n + 1) * (n + 1)), triangles);
}

/// All vertices, each 7 places behind the one before.
std::vector<int> scattered_order(const PolyMesh& mesh) {
  std::vector<int> order;
  const auto count = static_cast<int>(mesh.n_vertices());
  for (int i = 0; i < count; ++i) order.push_back(7 * i % count);
  return order;
}

class Renumber : public ::testing::Test {
 protected:
  Renumber() {
    build_square(mesh_, 5);
    build_square(old_, 5);
    order_ = scattered_order(mesh_);
    numbering_ = number_along(mesh_, order_);
    renumber(mesh_, numbering_);
  }

  VertexHandle new_vertex(VertexHandle vh) const {
    return VertexHandle(numbering_.vertex[static_cast<std::size_t>(vh.idx())]);
  }

  PolyMesh mesh_, old_;
  std::vector<int> order_;
  Numbering numbering_;
};

TEST_F(Renumber, GivesVerticesTheirPlacesInTheOrder) {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    EXPECT_EQ(numbering_.vertex[static_cast<std::size_t>(order_[i])], static_cast<int>(i));
  }
}

TEST_F(Renumber, KeepsTheMesh) {
  testing::expect_valid(mesh_);
  for (const HalfedgeHandle heh : old_.halfedges()) {
    const int edge = numbering_.edge[static_cast<std::size_t>(heh.idx() / 2)];
    const HalfedgeHandle moved(2 * edge + heh.idx() % 2);
    EXPECT_EQ(mesh_.to_vertex_handle(moved), new_vertex(old_.to_vertex_handle(heh)));
    EXPECT_EQ(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(moved)),
              new_vertex(old_.to_vertex_handle(old_.next_halfedge_handle(heh))));
    EXPECT_EQ(mesh_.is_boundary(moved), old_.is_boundary(heh));
  }
}

TEST_F(Renumber, SortsFacesByTheirFirstVertex) {
  int last = 0;
  for (std::size_t f = 0; f < mesh_.n_faces(); ++f) {
    int least = static_cast<int>(mesh_.n_vertices());
    for (const VertexHandle vh : mesh_.fv_range(FaceHandle(static_cast<int>(f)))) {
      least = std::min(least, vh.idx());
    }
    EXPECT_GE(least, last);
    last = least;
  }
}

TEST(RenumberValues, MovesEachToItsNewNumber) {
  std::vector<double> values = {10, 20, 30};
  renumber_values(values, {2, 0, 1});
  EXPECT_EQ(values, (std::vector<double>{20, 30, 10}));
}

}  // namespace
}  // namespace surfmesh
