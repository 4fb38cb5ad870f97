// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/locate.hh"

#include <gtest/gtest.h>

#include "support/domain_meshes.hh"
#include "support/meshes.hh"

namespace surfmesh {
namespace {

using testing::random_points;

/// The unit square with random points, inserted in an anisotropic metric, so that triangles are
/// long.
std::unique_ptr<DelaunayMesh> long_triangles(double aspect) {
  auto delaunay = std::make_unique<DelaunayMesh>(Uv{0, 0}, Uv{1, 1});
  const ConstantMetricRule rule{delaunay->uv_handle(), {1, 0, aspect * aspect}};
  for (const Uv p : random_points(2000, 7)) delaunay->insert(p, FaceHandle(0), rule);
  delaunay->shrink();
  return delaunay;
}

bool contains(const DelaunayMesh& delaunay, FaceHandle fh, Uv p) {
  const auto t = corners(delaunay.mesh(), fh, delaunay.uv_handle());
  return orient2d(t[0], t[1], p) >= 0 && orient2d(t[1], t[2], p) >= 0 &&
         orient2d(t[2], t[0], p) >= 0;
}

class Locate : public ::testing::TestWithParam<double> {};

TEST_P(Locate, FindsTheTriangleFromAnywhere) {
  const auto delaunay = long_triangles(GetParam());
  FaceHandle start(0);
  for (const Uv p : random_points(1000, 11)) {
    const Location location = delaunay->locate(p, start);
    EXPECT_EQ(location.kind, Location::Kind::Inside);
    EXPECT_TRUE(contains(*delaunay, location.face, p));
    start = location.face;
  }
}

TEST_P(Locate, FindsVerticesAndTheirNumbers) {
  const auto delaunay = long_triangles(GetParam());
  for (int i = 0; i < static_cast<int>(delaunay->n_vertices()); i += 7) {
    const Location location = delaunay->locate(delaunay->uv(VertexHandle(i)), FaceHandle(0));
    EXPECT_EQ(location.kind, Location::Kind::OnVertex);
    EXPECT_EQ(location.vertex, VertexHandle(i));
  }
}

INSTANTIATE_TEST_SUITE_P(Aspects, Locate, ::testing::Values(1.0, 100.0, 10'000.0),
                         [](const auto& test) {
                           return std::to_string(static_cast<int>(test.param));
                         });

TEST(Location, IsOnTheEdgeExactly) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const Location location = delaunay.locate({0.3, 0.3}, FaceHandle(0));
  EXPECT_EQ(location.kind, Location::Kind::OnEdge);
  EXPECT_FALSE(delaunay.is_constrained(delaunay.mesh().edge_handle(location.edge)));
  EXPECT_EQ(delaunay.locate({0.3, std::nextafter(0.3, 1)}, FaceHandle(0)).kind,
            Location::Kind::Inside);
}

TEST_P(Locate, TellsTheOpenEdgeFromAnywhere) {
  const auto delaunay = long_triangles(GetParam());
  const PolyMesh& mesh = delaunay->mesh();
  for (std::size_t i = 0; i < delaunay->n_faces(); i += 17) {
    for (const Uv p : {Uv{-1e-9, 0.7}, {1e9, 0.5}, {0.2, 1.5}, {0.6, -1e-3}}) {
      const Location location = delaunay->locate(p, FaceHandle(static_cast<int>(i)));
      ASSERT_EQ(location.kind, Location::Kind::Outside);
      ASSERT_TRUE(location.edge.is_valid());
      EXPECT_TRUE(mesh.is_boundary(mesh.opposite_halfedge_handle(location.edge)));
      EXPECT_LT(orient2d(delaunay->uv(mesh.from_vertex_handle(location.edge)),
                         delaunay->uv(mesh.to_vertex_handle(location.edge)), p),
                0);
    }
  }
}

TEST(Location, OutsideTellsTheOpenEdge) {
  DelaunayMesh delaunay({0, 0}, {1, 1});
  const Location location = delaunay.locate({0.5, -0.25}, FaceHandle(1));
  EXPECT_EQ(location.kind, Location::Kind::Outside);
  EXPECT_EQ(delaunay.uv(delaunay.mesh().to_vertex_handle(location.edge)).v, 0);
  EXPECT_EQ(delaunay.uv(delaunay.mesh().from_vertex_handle(location.edge)).v, 0);
}

/// A row of so many squares that a walk along it ends in a search of all triangles.
class LongRow : public ::testing::Test {
 protected:
  static constexpr int kSquares = 2000;

  LongRow() : mesh_(testing::plane_grid(kSquares, 1)), uv_(attach(mesh_, keys::vertex_uv)) {
    for (const VertexHandle vh : mesh_.vertices()) {
      const Vec3 point = to_eigen(mesh_.point(vh));
      mesh_.property(uv_, vh) = {point.x(), point.y()};
    }
  }

  Location locate_from_the_first(Uv p) {
    return locate(mesh_, uv_, p, FaceHandle(0), random_, mesh_.n_faces());
  }

  PolyMesh mesh_;
  decltype(keys::vertex_uv)::Handle uv_;
  RandomBits random_;
};

TEST_F(LongRow, HasItsLastTriangles) {
  const Location location = locate_from_the_first({kSquares - 0.25, 0.25});
  EXPECT_EQ(location.kind, Location::Kind::Inside);
  EXPECT_EQ(location.face, FaceHandle(2 * kSquares - 2));
}

TEST_F(LongRow, HasItsLastVertex) {
  const Location location = locate_from_the_first({kSquares, 0});
  EXPECT_EQ(location.kind, Location::Kind::OnVertex);
  EXPECT_EQ(location.vertex, VertexHandle(kSquares));
}

TEST_F(LongRow, EndsAtAnOpenEdge) {
  const Uv p{kSquares + 1.0, 0.5};
  const Location location = locate_from_the_first(p);
  ASSERT_EQ(location.kind, Location::Kind::Outside);
  ASSERT_TRUE(location.edge.is_valid());
  EXPECT_TRUE(mesh_.is_boundary(mesh_.opposite_halfedge_handle(location.edge)));
  EXPECT_EQ(mesh_.face_handle(location.edge), location.face);
  EXPECT_LT(orient2d(mesh_.property(uv_, mesh_.from_vertex_handle(location.edge)),
                     mesh_.property(uv_, mesh_.to_vertex_handle(location.edge)), p),
            0);
}

}  // namespace
}  // namespace surfmesh
