// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/delaunay_mesh.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/domain_meshes.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

using testing::random_points;

double area(const DelaunayMesh& delaunay) {
  double sum = 0;
  for (std::size_t i = 0; i < delaunay.n_faces(); ++i) {
    const auto t = corners(delaunay.mesh(), FaceHandle(static_cast<int>(i)), delaunay.uv_handle());
    EXPECT_EQ(orient2d(t[0], t[1], t[2]), 1);
    sum += 0.5 * cross(t[1] - t[0], t[2] - t[0]);
  }
  return sum;
}

/// Number of inner edges whose far vertex lies inside the circle of the triangle before it.
int count_violations(const DelaunayMesh& delaunay, const Metric& metric) {
  const PolyMesh& mesh = delaunay.mesh();
  int count = 0;
  for (std::size_t i = 0; i < 2 * delaunay.n_edges(); ++i) {
    const HalfedgeHandle heh(static_cast<int>(i));
    const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(heh);
    if (mesh.is_boundary(heh) || mesh.is_boundary(opposite)) continue;
    const Uv far = delaunay.uv(mesh.to_vertex_handle(mesh.next_halfedge_handle(opposite)));
    const auto t = corners(mesh, mesh.face_handle(heh), delaunay.uv_handle());
    if (in_metric_circle(t, far, metric)) ++count;
  }
  return count;
}

struct InsertionCase {
  const char* name;
  bool by_swaps;
  Metric metric;
};

void PrintTo(const InsertionCase& insertion, std::ostream* out) { *out << insertion.name; }

class Insertion : public ::testing::TestWithParam<InsertionCase> {
 protected:
  static VertexHandle insert(DelaunayMesh& delaunay, Uv p) {
    const ConstantMetricRule rule{delaunay.uv_handle(), GetParam().metric};
    return GetParam().by_swaps ? delaunay.insert_by_swaps(p, FaceHandle(0), rule)
                               : delaunay.insert(p, FaceHandle(0), rule);
  }
};

TEST_P(Insertion, MakesADelaunayTriangulationOfTheMetric) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  for (const Uv p : random_points(2000, 7)) ASSERT_TRUE(insert(delaunay, p).is_valid());
  EXPECT_EQ(delaunay.n_vertices(), 2004u);
  EXPECT_EQ(delaunay.n_faces(), 4002u);
  EXPECT_NEAR(area(delaunay), 1, 1e-12);
  EXPECT_EQ(count_violations(delaunay, GetParam().metric), 0);
}

TEST_P(Insertion, AcceptsPointsOnEdgesAndOnTheBoundary) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  for (int j = 0; j <= 16; ++j) {
    for (int i = 0; i <= 16; ++i) {
      ASSERT_TRUE(insert(delaunay, {i / 16.0, j / 16.0}).is_valid());
    }
  }
  EXPECT_EQ(delaunay.n_vertices(), 17u * 17u);
  EXPECT_EQ(delaunay.n_faces(), 2u * 16u * 16u);
  EXPECT_NEAR(area(delaunay), 1, 1e-14);
}

TEST_P(Insertion, ReturnsTheOldVertexForAPositionTwice) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const VertexHandle first = insert(delaunay, {0.25, 0.5});
  EXPECT_EQ(insert(delaunay, {0.25, 0.5}), first);
  EXPECT_EQ(delaunay.n_vertices(), 5u);
}

TEST_P(Insertion, RefusesPointsOutside) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  EXPECT_FALSE(insert(delaunay, {1.5, 0.5}).is_valid());
  EXPECT_EQ(delaunay.n_vertices(), 4u);
}

INSTANTIATE_TEST_SUITE_P(Kernels, Insertion,
                         ::testing::Values(InsertionCase{"Cavity", false, {1, 0, 1}},
                                           InsertionCase{"CavityAspect100", false, {1, 0, 1e4}},
                                           InsertionCase{"CavityTurned", false, {2, 1.3, 1}},
                                           InsertionCase{"Swaps", true, {1, 0, 1}},
                                           InsertionCase{"SwapsAspect100", true, {1, 0, 1e4}}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(DelaunayMesh, KeepsEveryTriangleValidWhateverTheRuleSays) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const auto greedy = [](const PolyMesh&, const TriangleVertices&, Uv) { return true; };
  for (const Uv p : random_points(300, 3)) delaunay.insert(p, FaceHandle(0), greedy);
  EXPECT_NEAR(area(delaunay), 1, 1e-12);
}

TEST(DelaunayMesh, RecoversConstraintsThatCrossManyEdges) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const ConstantMetricRule rule{delaunay.uv_handle()};
  const VertexHandle a = delaunay.insert({0.01, 0.02}, FaceHandle(0), rule);
  const VertexHandle b = delaunay.insert({0.98, 0.97}, FaceHandle(0), rule);
  for (const Uv p : random_points(500, 11)) delaunay.insert(p, FaceHandle(0), rule);
  delaunay.insert_constraint(a, b);
  const HalfedgeHandle heh = delaunay.find_halfedge(a, b);
  ASSERT_TRUE(heh.is_valid());
  EXPECT_TRUE(delaunay.is_constrained(delaunay.mesh().edge_handle(heh)));
  EXPECT_NEAR(area(delaunay), 1, 1e-12);
}

TEST(DelaunayMesh, SplitsAConstraintAtVerticesOnIt) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const ConstantMetricRule rule{delaunay.uv_handle()};
  const VertexHandle a = delaunay.insert({0.25, 0.25}, FaceHandle(0), rule);
  const VertexHandle middle = delaunay.insert({0.5, 0.5}, FaceHandle(0), rule);
  const VertexHandle b = delaunay.insert({0.75, 0.75}, FaceHandle(0), rule);
  delaunay.insert_constraint(a, b);
  for (const auto& [from, to] : {std::pair(a, middle), std::pair(middle, b)}) {
    const HalfedgeHandle heh = delaunay.find_halfedge(from, to);
    ASSERT_TRUE(heh.is_valid());
    EXPECT_TRUE(delaunay.is_constrained(delaunay.mesh().edge_handle(heh)));
  }
}

TEST(DelaunayMesh, TellsWhereConstraintsCross) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const ConstantMetricRule rule{delaunay.uv_handle()};
  const VertexHandle a = delaunay.insert({0.2, 0.2}, FaceHandle(0), rule);
  const VertexHandle b = delaunay.insert({0.8, 0.8}, FaceHandle(0), rule);
  const VertexHandle c = delaunay.insert({0.2, 0.8}, FaceHandle(0), rule);
  const VertexHandle d = delaunay.insert({0.8, 0.25}, FaceHandle(0), rule);
  delaunay.insert_constraint(a, b);
  try {
    delaunay.insert_constraint(c, d);
    FAIL() << "crossing constraints were accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Geometry);
    EXPECT_NE(std::string(error.what()).find("(u,v)"), std::string::npos);
  }
}

TEST(DelaunayMesh, NeverCrossesAConstraintWithACavity) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const ConstantMetricRule rule{delaunay.uv_handle()};
  const VertexHandle a = delaunay.insert({0, 0.5}, FaceHandle(0), rule);
  const VertexHandle b = delaunay.insert({1, 0.5}, FaceHandle(0), rule);
  delaunay.insert_constraint(a, b);
  for (const Uv p : random_points(200, 5)) delaunay.insert(p, FaceHandle(0), rule);
  EXPECT_TRUE(delaunay.find_halfedge(a, b).is_valid());
  EXPECT_FALSE(delaunay.insert({0.5, 0.5}, FaceHandle(0), rule).is_valid());
}

TEST(SplitEdge, CutsBothTrianglesInTwo) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const HalfedgeHandle diagonal = delaunay.find_halfedge(VertexHandle(0), VertexHandle(2));
  const VertexHandle vh = delaunay.split_edge(delaunay.mesh().edge_handle(diagonal), {0.25, 0.25});
  EXPECT_EQ(delaunay.n_vertices(), 5u);
  EXPECT_EQ(delaunay.n_edges(), 8u);
  EXPECT_EQ(delaunay.n_faces(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(delaunay.find_halfedge(vh, VertexHandle(i)).is_valid());
  EXPECT_FALSE(delaunay.find_halfedge(VertexHandle(0), VertexHandle(2)).is_valid());
  EXPECT_EQ(area(delaunay), 1);
}

TEST(SplitEdge, LeavesTheMetricOfTheVertexUnset) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const HalfedgeHandle diagonal = delaunay.find_halfedge(VertexHandle(0), VertexHandle(2));
  const VertexHandle vh = delaunay.split_edge(delaunay.mesh().edge_handle(diagonal), {0.5, 0.5});
  EXPECT_EQ(delaunay.uv(vh), (Uv{0.5, 0.5}));
  EXPECT_TRUE(std::isnan(delaunay.metric(vh).m11));
}

TEST(SplitEdge, ConstrainsNoneOfTheNewEdges) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const HalfedgeHandle diagonal = delaunay.find_halfedge(VertexHandle(0), VertexHandle(2));
  const VertexHandle vh = delaunay.split_edge(delaunay.mesh().edge_handle(diagonal), {0.5, 0.5});
  for (const EdgeHandle eh : delaunay.mesh().ve_range(vh)) {
    EXPECT_FALSE(delaunay.is_constrained(eh));
  }
}

}  // namespace
}  // namespace surfmesh
