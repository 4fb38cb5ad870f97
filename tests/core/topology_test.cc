// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/topology.hh"

#include <gtest/gtest.h>

#include <set>
#include <type_traits>

#include "surfmesh/core/validate.hh"

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
    while (t[0] != *std::min_element(t.begin(), t.end()))
      std::rotate(t.begin(), t.begin() + 1, t.end());
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
  PolyMesh mesh;
  build_triangles(mesh, 5, kFan);
  EXPECT_EQ(mesh.n_edges(), 8u);
  EXPECT_EQ(triangles_of(mesh),
            (std::set<std::array<int, 3>>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}}));
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
  PolyMesh mesh;
  build_triangles(mesh, 5, {{0, 1, 2}, {0, 1, 3}});
  EXPECT_EQ(mesh.n_edges(), 6u);
}

FaceList faces_of(const std::vector<std::vector<int>>& faces) {
  FaceList list;
  for (const auto& face : faces) list.add(face);
  return list;
}

TEST(BuildFaces, GluesPolygonsAndKeepsTheirFirstVertices) {
  const std::vector<std::vector<int>> faces = {{0, 1, 2, 3}, {1, 4, 2}, {3, 2, 4, 5, 6}};
  PolyMesh mesh;
  build_faces(mesh, 7, faces_of(faces), FirstSide::ToFirstCorner);
  EXPECT_EQ(mesh.n_edges(), 9u);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<int> vertices;
    for (const VertexHandle vh : mesh.fv_range(FaceHandle(static_cast<int>(f)))) {
      vertices.push_back(vh.idx());
    }
    EXPECT_EQ(vertices, faces[f]);
  }
  expect_linked(mesh);
}

TEST(BuildFaces, GivesTheTrianglesOfBuildTriangles) {
  PolyMesh a, b;
  build_triangles(a, 5, kFan);
  build_faces(b, 5, faces_of({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}),
              FirstSide::ToFirstCorner);
  EXPECT_EQ(triangles_of(a), triangles_of(b));
  for (std::size_t i = 0; i < a.n_halfedges(); ++i) {
    const HalfedgeHandle heh(static_cast<int>(i));
    EXPECT_EQ(a.to_vertex_handle(heh), b.to_vertex_handle(heh));
    EXPECT_EQ(a.next_halfedge_handle(heh), b.next_halfedge_handle(heh));
  }
}

TEST(BuildFaces, BeginsAtTheFirstCornerIfAsked) {
  for (const auto& faces : {std::vector<std::vector<int>>{{0, 1, 2, 3}, {1, 4, 2}},
                            std::vector<std::vector<int>>{{0, 1, 2}, {1, 4, 2}}}) {
    PolyMesh mesh;
    build_faces(mesh, 5, faces_of(faces), FirstSide::FromFirstCorner);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const HalfedgeHandle heh = mesh.halfedge_handle(FaceHandle(static_cast<int>(f)));
      EXPECT_EQ(mesh.from_vertex_handle(heh).idx(), faces[f][0]);
      EXPECT_EQ(mesh.to_vertex_handle(heh).idx(), faces[f][1]);
    }
  }
}

TEST(BuildFaces, GluesTwinsOfPolygonsAsTheirVerticesWould) {
  // Corners 1 and 6: the side from 1 to 2 of the quad, that from 2 to 1 of the triangle.
  const FaceList faces = faces_of({{0, 1, 2, 3}, {1, 4, 2}});
  const std::vector<int> twins = {-1, 6, -1, -1, -1, -1, 1};
  PolyMesh by_vertices, by_twins;
  build_faces(by_vertices, 5, faces, FirstSide::FromFirstCorner);
  build_faces(by_twins, 5, faces, FirstSide::FromFirstCorner, twins);
  EXPECT_EQ(by_twins.n_edges(), by_vertices.n_edges());
  EXPECT_TRUE(by_twins.find_halfedge(VertexHandle(1), VertexHandle(2)).is_valid());
  EXPECT_FALSE(by_twins.is_boundary(
      by_twins.edge_handle(by_twins.find_halfedge(VertexHandle(1), VertexHandle(2)))));
  expect_linked(by_twins);
}

TEST(BuildFaces, DuplicatesAVertexInWhichFacesTouch) {
  PolyMesh mesh;
  const Separation separation =
      build_faces(mesh, 7, faces_of({{0, 1, 2, 3}, {2, 4, 5, 6}}), FirstSide::ToFirstCorner);
  EXPECT_EQ(separation.copied, std::vector<int>{2});
  EXPECT_EQ(separation.cut_edges, 0u);
  EXPECT_EQ(mesh.n_vertices(), 8u);
  EXPECT_EQ(mesh.fv_begin(FaceHandle(1))->idx(), 7);
  expect_linked(mesh);
}

TEST(BuildFaces, CutsSheetsThatMeetInOneEdge) {
  PolyMesh mesh;
  const Separation separation = build_faces(
      mesh, 8, faces_of({{0, 1, 2, 3}, {1, 0, 4, 5}, {0, 1, 6, 7}}), FirstSide::ToFirstCorner);
  EXPECT_EQ(separation.cut_edges, 3u);
  EXPECT_EQ(separation.copied, (std::vector<int>{1, 0, 0, 1}));
  expect_linked(mesh);
}

/// Faces 0 and 1 are the two sides of one triangle. A third has one of its edges, or two others one
/// each: those are cut, though at their ends faces 0 and 1 are neighbours by what is left.
TEST(BuildFaces, ClosesTheSlitsBetweenNeighboursThatItCut) {
  struct Case {
    std::vector<std::vector<int>> others;
    std::size_t cut;
  };
  for (const auto& [others, cut] :
       {Case{{{0, 1, 3}}, 1}, Case{{{0, 1, 3}, {1, 2, 3}}, 6}, Case{{{0, 1, 3}, {1, 0, 3}}, 0}}) {
    std::vector<std::vector<int>> faces = {{0, 1, 2}, {1, 0, 2}};
    faces.insert(faces.end(), others.begin(), others.end());
    for (const FirstSide first : {FirstSide::FromFirstCorner, FirstSide::ToFirstCorner}) {
      PolyMesh mesh;
      const Separation separation = build_faces(mesh, 4, faces_of(faces), first);
      EXPECT_EQ(find_faults(mesh), std::vector<std::string>{});
      EXPECT_EQ(separation.cut_edges, cut);
      expect_linked(mesh);
      for (std::size_t f = 0; f < faces.size(); ++f) {
        const HalfedgeHandle heh = mesh.halfedge_handle(FaceHandle(static_cast<int>(f)));
        const int begin = first == FirstSide::FromFirstCorner ? faces[f][0] : faces[f][2];
        const int vertex = mesh.from_vertex_handle(heh).idx();
        EXPECT_EQ(vertex < 4 ? vertex : separation.copied[static_cast<std::size_t>(vertex - 4)],
                  begin);
      }
    }
  }
}

TEST(BuildTriangles, GluesTwinsAsTheirVerticesWould) {
  PolyMesh by_vertices, by_twins;
  build_triangles(by_vertices, 5, kFan);
  const std::vector<int> twins = {-1, 5, 10, -1, 8, 1, -1, 11, 4, -1, 2, 7};
  build_triangles(by_twins, 5, kFan, twins);
  EXPECT_EQ(triangles_of(by_twins), triangles_of(by_vertices));
  EXPECT_EQ(by_twins.n_edges(), by_vertices.n_edges());
  expect_linked(by_twins);
}

TEST(Flip, SwapsTheDiagonalAndKeepsThePropertyOfTheEdge) {
  PolyMesh mesh;
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

class FillCavity : public ::testing::Test {
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

  PolyMesh mesh_;
  decltype(keys::edge_constrained)::Handle constrained_;
};

TEST_F(FillCavity, SplitsATriangle) {
  Cavity cavity;
  cavity.rim = {halfedge(0, 1), halfedge(1, 4), halfedge(4, 0)};
  cavity.faces = {mesh_.face_handle(cavity.rim[0])};
  ElementPool pool(mesh_);
  fill_cavity(mesh_, pool, cavity, constrained_);
  pool.shrink();
  EXPECT_EQ(triangles_of(mesh_),
            (std::set<std::array<int, 3>>{
                {0, 1, 5}, {1, 4, 5}, {0, 5, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}}));
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
  EXPECT_EQ(triangles_of(mesh_),
            (std::set<std::array<int, 3>>{{1, 4, 5}, {0, 5, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}}));
  EXPECT_EQ(mesh_.property(constrained_, mesh_.edge_handle(halfedge(0, 5))), 1);
  EXPECT_EQ(mesh_.property(constrained_, mesh_.edge_handle(halfedge(5, 1))), 1);
  EXPECT_EQ(mesh_.property(constrained_, mesh_.edge_handle(halfedge(5, 4))), 0);
  expect_linked(mesh_);
}

/// A hexagon with two vertices inside, 6 and 7, both joined to 0 and 3.
const Triangles kHexagon = {{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {0, 6, 7},
                            {6, 3, 7}, {3, 4, 7}, {4, 5, 7}, {5, 0, 7}};

class Collapse : public ::testing::Test {
 protected:
  Collapse() { build_triangles(mesh_, 8, kHexagon); }

  void collapse_edge(int from, int to) {
    ElementPool pool(mesh_);
    const auto id = attach(mesh_, keys::edge_contour, -1);
    for (const EdgeHandle eh : mesh_.edges()) mesh_.property(id, eh) = eh.idx();
    const HalfedgeHandle heh = mesh_.find_halfedge(VertexHandle(from), VertexHandle(to));
    pool.remove(collapse(mesh_, heh), [&]<class Handle>(Handle old, Handle place) {
      if constexpr (std::is_same_v<Handle, EdgeHandle>) {
        mesh_.property(id, place) = mesh_.property(id, old);
      }
    });
    pool.shrink();
  }

  PolyMesh mesh_;
};

TEST_F(Collapse, MergesAnInnerVertexIntoItsNeighbour) {
  collapse_edge(6, 1);
  // Vertex 7, the last, has taken the number 6.
  EXPECT_EQ(triangles_of(mesh_),
            (std::set<std::array<int, 3>>{
                {1, 2, 3}, {0, 1, 6}, {1, 3, 6}, {3, 4, 6}, {4, 5, 6}, {0, 6, 5}}));
  expect_linked(mesh_);
}

TEST_F(Collapse, MergesInnerVertices) {
  collapse_edge(7, 6);
  EXPECT_EQ(triangles_of(mesh_),
            (std::set<std::array<int, 3>>{
                {0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {3, 4, 6}, {4, 5, 6}, {0, 6, 5}}));
  expect_linked(mesh_);
}

TEST_F(Collapse, KeepsThePropertiesOfWhatStays) {
  const EdgeHandle kept = mesh_.edge_handle(mesh_.find_halfedge(VertexHandle(4), VertexHandle(5)));
  collapse_edge(6, 1);
  const EdgeHandle now = mesh_.edge_handle(mesh_.find_halfedge(VertexHandle(4), VertexHandle(5)));
  EXPECT_EQ(mesh_.property(require(mesh_, keys::edge_contour), now), kept.idx());
}

TEST_F(Collapse, OfAVertexOfThreeTrianglesLeavesOne) {
  PolyMesh mesh;
  build_triangles(mesh, 4, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  ElementPool pool(mesh);
  pool.remove(collapse(mesh, mesh.find_halfedge(VertexHandle(3), VertexHandle(1))),
              [](auto, auto) {});
  pool.shrink();
  EXPECT_EQ(triangles_of(mesh), (std::set<std::array<int, 3>>{{0, 1, 2}}));
  EXPECT_EQ(mesh.n_edges(), 3u);
  expect_linked(mesh);
}

}  // namespace
}  // namespace surfmesh
