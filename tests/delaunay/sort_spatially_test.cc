// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <utility>

#include "support/domain_meshes.hh"
#include "support/expect_valid.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"

namespace surfmesh {
namespace {

using testing::positions;
using testing::valid_area;

using Place = std::pair<double, double>;

/// A triangulation of points that came in a random order; the diagonal is constrained. Each vertex
/// has a metric that tells its place.
class SortedMesh : public ::testing::Test {
 protected:
  SortedMesh() : delaunay_({0, 0}, {1, 1}) {
    for (const Uv p : testing::random_points(kPoints, 5)) {
      delaunay_.insert(p, FaceHandle(0), ConstantMetricRule{delaunay_.uv_handle()});
    }
    delaunay_.insert_constraint(VertexHandle(0), VertexHandle(2));
    for (std::size_t v = 0; v < delaunay_.n_vertices(); ++v) {
      const VertexHandle vh(static_cast<int>(v));
      delaunay_.metric(vh) = {1 + delaunay_.uv(vh).u, 0, 1 + delaunay_.uv(vh).v};
    }
    delaunay_.shrink();
  }

  const PolyMesh& mesh() const { return delaunay_.mesh(); }

  Place place(VertexHandle vh) const { return {delaunay_.uv(vh).u, delaunay_.uv(vh).v}; }

  /// The triangles by the places of their corners, from the least one on.
  std::set<std::array<Place, 3>> triangles() const {
    std::set<std::array<Place, 3>> result;
    for (const FaceHandle fh : mesh().faces()) {
      const TriangleVertices v = vertices(mesh(), fh);
      std::array<Place, 3> t = {place(v[0]), place(v[1]), place(v[2])};
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      result.insert(t);
    }
    return result;
  }

  std::set<std::pair<Place, Place>> constrained() const {
    std::set<std::pair<Place, Place>> result;
    for (const EdgeHandle eh : mesh().edges()) {
      if (!delaunay_.is_constrained(eh)) continue;
      const HalfedgeHandle heh = mesh().halfedge_handle(eh, 0);
      result.insert(
          std::minmax(place(mesh().from_vertex_handle(heh)), place(mesh().to_vertex_handle(heh))));
    }
    return result;
  }

  static constexpr int kPoints = 4000;
  static constexpr std::size_t kCorners = 4;

  DelaunayMesh delaunay_;
};

TEST_F(SortedMesh, IsValid) {
  delaunay_.sort_spatially(kCorners);
  testing::expect_valid(mesh());
  EXPECT_NEAR(valid_area(delaunay_), 1, 1e-12);
}

TEST_F(SortedMesh, HasTheSameTriangles) {
  const auto before = triangles();
  delaunay_.sort_spatially(kCorners);
  EXPECT_EQ(triangles(), before);
}

TEST_F(SortedMesh, LeavesTheFirstVertices) {
  for (const std::size_t fixed : {std::size_t{0}, kCorners, std::size_t{100}}) {
    const auto before = positions(delaunay_);
    delaunay_.sort_spatially(fixed);
    const auto after = positions(delaunay_);
    EXPECT_TRUE(std::equal(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(fixed),
                           after.begin()));
  }
}

TEST_F(SortedMesh, KeepsTheMetricOfEveryVertex) {
  delaunay_.sort_spatially(kCorners);
  for (const VertexHandle vh : mesh().vertices()) {
    EXPECT_EQ(delaunay_.metric(vh).m11, 1 + delaunay_.uv(vh).u);
    EXPECT_EQ(delaunay_.metric(vh).m22, 1 + delaunay_.uv(vh).v);
  }
}

TEST_F(SortedMesh, KeepsItsConstrainedEdges) {
  const auto before = constrained();
  EXPECT_GE(before.size(), 5u);
  delaunay_.sort_spatially(kCorners);
  EXPECT_EQ(constrained(), before);
}

TEST_F(SortedMesh, TakesPointsAgain) {
  delaunay_.sort_spatially(kCorners);
  for (const Uv p : testing::random_points(500, 6)) {
    delaunay_.insert(p, FaceHandle(0), ConstantMetricRule{delaunay_.uv_handle()});
  }
  EXPECT_EQ(delaunay_.n_vertices(), kCorners + kPoints + 500);
  EXPECT_NEAR(valid_area(delaunay_), 1, 1e-12);
}

/// Mean difference, over all inner edges, of the numbers of two elements at each, as a share of the
/// number of all.
template <class Pair>
double mean_distance(const DelaunayMesh& delaunay, std::size_t count, Pair pair) {
  const PolyMesh& mesh = delaunay.mesh();
  double sum = 0;
  int edges = 0;
  for (const EdgeHandle eh : mesh.edges()) {
    if (mesh.is_boundary(eh)) continue;
    const auto [a, b] = pair(mesh.halfedge_handle(eh, 0), mesh.halfedge_handle(eh, 1));
    sum += std::abs(a.idx() - b.idx());
    ++edges;
  }
  return sum / edges / static_cast<double>(count);
}

double vertex_distance(const DelaunayMesh& delaunay) {
  return mean_distance(delaunay, delaunay.n_vertices(), [&](HalfedgeHandle a, HalfedgeHandle b) {
    return std::pair(delaunay.mesh().to_vertex_handle(a), delaunay.mesh().to_vertex_handle(b));
  });
}

double face_distance(const DelaunayMesh& delaunay) {
  return mean_distance(delaunay, delaunay.n_faces(), [&](HalfedgeHandle a, HalfedgeHandle b) {
    return std::pair(delaunay.mesh().face_handle(a), delaunay.mesh().face_handle(b));
  });
}

double edge_distance(const DelaunayMesh& delaunay) {
  return mean_distance(delaunay, delaunay.n_edges(), [&](HalfedgeHandle a, HalfedgeHandle) {
    const PolyMesh& mesh = delaunay.mesh();
    return std::pair(mesh.edge_handle(a), mesh.edge_handle(mesh.next_halfedge_handle(a)));
  });
}

/// Numbers without any order are a third of all apart in the mean.
TEST_F(SortedMesh, HasNeighboursNextToEachOther) {
  const auto distances = [this] {
    return std::array{vertex_distance(delaunay_), edge_distance(delaunay_),
                      face_distance(delaunay_)};
  };
  for (const double distance : distances()) EXPECT_GT(distance, 0.2);
  delaunay_.sort_spatially(kCorners);
  for (const double distance : distances()) EXPECT_LT(distance, 0.03);
}

}  // namespace
}  // namespace surfmesh
