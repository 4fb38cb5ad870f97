// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/topology.hh"

#include <gtest/gtest.h>

#include <set>

namespace surfmesh {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// The triangles as sets of vertices, each rotated so that its smallest comes first.
template <class Mesh>
std::set<std::array<int, 3>> triangles_of(const Mesh& mesh) {
  std::set<std::array<int, 3>> result;
  for (std::size_t i = 0; i < mesh.n_faces(); ++i) {
    HalfedgeHandle heh = mesh.halfedge_handle(FaceHandle(static_cast<int>(i)));
    std::array<int, 3> t{};
    for (int& v : t) {
      v = mesh.from_vertex_handle(heh).idx();
      heh = mesh.next_halfedge_handle(heh);
    }
    while (t[0] != *std::min_element(t.begin(), t.end())) std::rotate(t.begin(), t.begin() + 1, t.end());
    result.insert(t);
  }
  return result;
}

template <class Mesh>
void expect_linked(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.n_halfedges(); ++i) {
    const HalfedgeHandle heh(static_cast<int>(i));
    const HalfedgeHandle next = mesh.next_halfedge_handle(heh);
    EXPECT_EQ(mesh.prev_halfedge_handle(next), heh);
    EXPECT_EQ(mesh.from_vertex_handle(next), mesh.to_vertex_handle(heh));
    EXPECT_EQ(mesh.face_handle(next), mesh.face_handle(heh));
  }
  for (std::size_t i = 0; i < mesh.n_vertices(); ++i) {
    const VertexHandle vh(static_cast<int>(i));
    const HalfedgeHandle start = mesh.halfedge_handle(vh);
    EXPECT_EQ(mesh.from_vertex_handle(start), vh);
    bool has_open = false;
    HalfedgeHandle heh = start;
    do {
      has_open = has_open || mesh.is_boundary(heh);
      heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
    } while (heh != start);
    EXPECT_EQ(has_open, mesh.is_boundary(start)) << "vertex " << i;
  }
}

const Triangles kFan = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

TEST(BuildTriangles, GluesOppositeSides) {
  TriMesh mesh;
  build_triangles(mesh, 5, kFan);
  EXPECT_EQ(mesh.n_edges(), 8u);
  EXPECT_EQ(triangles_of(mesh), (std::set<std::array<int, 3>>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}}));
  expect_linked(mesh);
}

TEST(BuildTriangles, ClosesATetrahedron) {
  PolyMesh mesh;
  build_triangles(mesh, 4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  EXPECT_EQ(mesh.n_edges(), 6u);
  expect_linked(mesh);
  for (std::size_t i = 0; i < mesh.n_halfedges(); ++i) {
    EXPECT_FALSE(mesh.is_boundary(HalfedgeHandle(static_cast<int>(i))));
  }
}

TEST(BuildTriangles, LeavesSidesOfEqualDirectionOpen) {
  TriMesh mesh;
  build_triangles(mesh, 5, {{0, 1, 2}, {0, 1, 3}});
  EXPECT_EQ(mesh.n_edges(), 6u);
}

TEST(Flip, SwapsTheDiagonalAndKeepsThePropertyOfTheEdge) {
  TriMesh mesh;
  build_triangles(mesh, 4, {{0, 1, 2}, {0, 2, 3}});
  const auto contour = attach(mesh, keys::edge_contour, -1);
  EdgeHandle diagonal;
  for (int i = 0; i < 5; ++i) {
    const HalfedgeHandle heh = mesh.halfedge_handle(EdgeHandle(i), 0);
    if (!mesh.is_boundary(heh) && !mesh.is_boundary(mesh.opposite_halfedge_handle(heh))) {
      diagonal = EdgeHandle(i);
    }
  }
  mesh.property(contour, diagonal) = 7;
  flip(mesh, diagonal);
  EXPECT_EQ(triangles_of(mesh), (std::set<std::array<int, 3>>{{0, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(mesh.property(contour, diagonal), 7);
  expect_linked(mesh);
}

class FillCavity : public testing::Test {
 protected:
  FillCavity() {
    build_triangles(mesh_, 5, kFan);
    constrained_ = attach(mesh_, keys::edge_constrained);
  }

  HalfedgeHandle halfedge(int from, int to) const {
    for (std::size_t i = 0; i < mesh_.n_halfedges(); ++i) {
      const HalfedgeHandle heh(static_cast<int>(i));
      if (mesh_.from_vertex_handle(heh).idx() == from && mesh_.to_vertex_handle(heh).idx() == to) {
        return heh;
      }
    }
    return HalfedgeHandle();
  }

  TriMesh mesh_;
  decltype(keys::edge_constrained)::Handle constrained_;
};

TEST_F(FillCavity, SplitsATriangle) {
  Cavity cavity;
  cavity.rim = {halfedge(0, 1), halfedge(1, 4), halfedge(4, 0)};
  cavity.faces = {mesh_.face_handle(cavity.rim[0])};
  ElementPool pool(mesh_);
  fill_cavity(mesh_, pool, cavity, constrained_);
  pool.shrink();
  EXPECT_EQ(triangles_of(mesh_), (std::set<std::array<int, 3>>{{0, 1, 5}, {1, 4, 5}, {0, 5, 4},
                                                               {1, 2, 4}, {2, 3, 4}, {0, 4, 3}}));
  expect_linked(mesh_);
}

TEST_F(FillCavity, UsesOldElementsAgainAndClearsTheirConstraint) {
  Cavity cavity;
  cavity.rim = {halfedge(0, 1), halfedge(1, 2), halfedge(2, 4), halfedge(4, 0)};
  const EdgeHandle inner = mesh_.edge_handle(halfedge(1, 4));
  mesh_.property(constrained_, inner) = 1;
  cavity.inner_edges = {inner};
  cavity.faces = {mesh_.face_handle(halfedge(0, 1)), mesh_.face_handle(halfedge(1, 2))};
  ElementPool pool(mesh_);
  fill_cavity(mesh_, pool, cavity, constrained_);
  pool.shrink();
  EXPECT_EQ(mesh_.n_edges(), 11u);
  EXPECT_EQ(mesh_.n_faces(), 6u);
  EXPECT_EQ(mesh_.property(constrained_, inner), 0);
  expect_linked(mesh_);
}

TEST_F(FillCavity, SplitsABoundaryEdgeAndKeepsItsConstraintOnBothParts) {
  Cavity cavity;
  cavity.split = halfedge(0, 1);
  cavity.rim = {halfedge(1, 4), halfedge(4, 0)};
  cavity.faces = {mesh_.face_handle(cavity.split)};
  mesh_.property(constrained_, mesh_.edge_handle(cavity.split)) = 1;
  ElementPool pool(mesh_);
  fill_cavity(mesh_, pool, cavity, constrained_);
  pool.shrink();
  EXPECT_EQ(triangles_of(mesh_), (std::set<std::array<int, 3>>{{1, 4, 5}, {0, 5, 4}, {1, 2, 4},
                                                               {2, 3, 4}, {0, 4, 3}}));
  EXPECT_EQ(mesh_.property(constrained_, mesh_.edge_handle(halfedge(0, 5))), 1);
  EXPECT_EQ(mesh_.property(constrained_, mesh_.edge_handle(halfedge(5, 1))), 1);
  EXPECT_EQ(mesh_.property(constrained_, mesh_.edge_handle(halfedge(5, 4))), 0);
  expect_linked(mesh_);
}

}  // namespace
}  // namespace surfmesh
