// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "support/domain_meshes.hh"
#include "support/expect_valid.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"

namespace surfmesh {
namespace {

using testing::positions;
using testing::valid_area;

using Place = std::pair<double, double>;
using Segment = std::pair<Place, Place>;

/// A triangulation of points in the unit square, in which the segment between the middles of its
/// left and its right side is constrained. Each vertex has a metric that tells its place.
class CollapsedMesh : public ::testing::Test {
 protected:
  CollapsedMesh() : delaunay_({0, 0}, {1, 1}) {
    for (const Uv p : testing::random_points(kPoints, 3)) insert(p);
    const VertexHandle left = insert({0, 0.5}), right = insert({1, 0.5});
    delaunay_.insert_constraint(left, right);
    for (int i = 0; i < 4; ++i) set_metric(VertexHandle(i));
  }

  VertexHandle insert(Uv p) {
    const VertexHandle vh =
        delaunay_.insert(p, FaceHandle(0), ConstantMetricRule{delaunay_.uv_handle()});
    set_metric(vh);
    return vh;
  }

  void set_metric(VertexHandle vh) {
    const Uv p = delaunay_.uv(vh);
    delaunay_.metric(vh) = {1 + p.u, 0, 1 + p.v};
  }

  const PolyMesh& mesh() const { return delaunay_.mesh(); }

  bool is_inner(VertexHandle vh) const {
    for (const EdgeHandle eh : mesh().ve_range(vh)) {
      if (delaunay_.is_constrained(eh)) return false;
    }
    return true;
  }

  /// True if the tip sees the triangles around the origin that do not have it as a corner.
  bool can_collapse(HalfedgeHandle heh) const {
    const VertexHandle origin = mesh().from_vertex_handle(heh), tip = mesh().to_vertex_handle(heh);
    if (!is_inner(origin)) return false;
    for (const HalfedgeHandle spoke : mesh().voh_range(origin)) {
      const HalfedgeHandle rim = mesh().next_halfedge_handle(spoke);
      const VertexHandle a = mesh().from_vertex_handle(rim), b = mesh().to_vertex_handle(rim);
      if (a == tip || b == tip) continue;
      if (orient2d(delaunay_.uv(tip), delaunay_.uv(a), delaunay_.uv(b)) <= 0) return false;
    }
    return true;
  }

  /// A halfedge from a vertex that may be collapsed; invalid if there is none.
  HalfedgeHandle collapsible_from(VertexHandle origin) const {
    for (const HalfedgeHandle heh : mesh().voh_range(origin)) {
      if (can_collapse(heh)) return heh;
    }
    return HalfedgeHandle();
  }

  /// The first, in the order of its origin.
  HalfedgeHandle collapsible() const {
    for (std::size_t v = 0; v < delaunay_.n_vertices(); ++v) {
      const HalfedgeHandle heh = collapsible_from(VertexHandle(static_cast<int>(v)));
      if (heh.is_valid()) return heh;
    }
    return HalfedgeHandle();
  }

  Place place(VertexHandle vh) const { return {delaunay_.uv(vh).u, delaunay_.uv(vh).v}; }

  std::set<Place> places() const {
    std::set<Place> result;
    for (const Uv p : positions(delaunay_)) result.insert({p.u, p.v});
    return result;
  }

  std::set<Segment> constrained() const {
    std::set<Segment> result;
    for (std::size_t i = 0; i < delaunay_.n_edges(); ++i) {
      const EdgeHandle eh(static_cast<int>(i));
      if (!delaunay_.is_constrained(eh)) continue;
      const HalfedgeHandle heh = mesh().halfedge_handle(eh, 0);
      result.insert(
          std::minmax(place(mesh().from_vertex_handle(heh)), place(mesh().to_vertex_handle(heh))));
    }
    return result;
  }

  static constexpr int kPoints = 300;

  DelaunayMesh delaunay_;
};

TEST_F(CollapsedMesh, LosesAVertexThreeEdgesAndTwoFaces) {
  const std::size_t vertices = delaunay_.n_vertices(), edges = delaunay_.n_edges();
  const std::size_t faces = delaunay_.n_faces();
  delaunay_.collapse(collapsible());
  EXPECT_EQ(delaunay_.n_vertices(), vertices - 1);
  EXPECT_EQ(delaunay_.n_edges(), edges - 3);
  EXPECT_EQ(delaunay_.n_faces(), faces - 2);
}

TEST_F(CollapsedMesh, StaysAValidTriangulationUntilNothingIsLeftToCollapse) {
  int count = 0;
  for (HalfedgeHandle heh; (heh = collapsible()).is_valid(); ++count) {
    delaunay_.collapse(heh);
    ASSERT_NEAR(valid_area(delaunay_), 1, 1e-12) << count;
  }
  EXPECT_EQ(count, kPoints);  // all inner vertices
  delaunay_.shrink();
  testing::expect_valid(mesh());
}

TEST_F(CollapsedMesh, LosesTheOriginAndNoOtherVertex) {
  const HalfedgeHandle heh = collapsible();
  std::set<Place> expected = places();
  expected.erase(place(mesh().from_vertex_handle(heh)));
  delaunay_.collapse(heh);
  EXPECT_EQ(places(), expected);
}

TEST_F(CollapsedMesh, JoinsTheNeighboursOfTheOriginToTheTip) {
  const HalfedgeHandle heh = collapsible();
  const VertexHandle tip = mesh().to_vertex_handle(heh);
  std::set<Place> expected;
  for (const VertexHandle vh : {mesh().from_vertex_handle(heh), tip}) {
    for (const VertexHandle neighbour : mesh().vv_range(vh)) expected.insert(place(neighbour));
  }
  expected.erase(place(mesh().from_vertex_handle(heh)));
  expected.erase(place(tip));
  ASSERT_NE(static_cast<std::size_t>(tip.idx()), delaunay_.n_vertices() - 1);
  delaunay_.collapse(heh);
  std::set<Place> neighbours;
  for (const VertexHandle neighbour : mesh().vv_range(tip)) neighbours.insert(place(neighbour));
  EXPECT_EQ(neighbours, expected);
}

TEST_F(CollapsedMesh, KeepsTheMetricOfEveryVertex) {
  for (int i = 0; i < 100; ++i) delaunay_.collapse(collapsible());
  for (std::size_t v = 0; v < delaunay_.n_vertices(); ++v) {
    const VertexHandle vh(static_cast<int>(v));
    EXPECT_EQ(delaunay_.metric(vh).m11, 1 + delaunay_.uv(vh).u);
    EXPECT_EQ(delaunay_.metric(vh).m22, 1 + delaunay_.uv(vh).v);
  }
}

TEST_F(CollapsedMesh, KeepsItsConstrainedEdges) {
  const std::set<Segment> before = constrained();
  EXPECT_GT(before.size(), 4u);
  for (int i = 0; i < 100; ++i) delaunay_.collapse(collapsible());
  EXPECT_EQ(constrained(), before);
}

TEST_F(CollapsedMesh, GivesTheNumberOfTheOriginToTheLastVertex) {
  const HalfedgeHandle heh = collapsible();
  const VertexHandle origin = mesh().from_vertex_handle(heh);
  const VertexHandle last(static_cast<int>(delaunay_.n_vertices()) - 1);
  ASSERT_NE(origin, last);
  std::vector<Uv> expected = positions(delaunay_);
  expected[static_cast<std::size_t>(origin.idx())] = expected.back();
  expected.pop_back();
  delaunay_.collapse(heh);
  EXPECT_EQ(positions(delaunay_), expected);
}

TEST_F(CollapsedMesh, KeepsAllNumbersWhereTheLastVertexGoes) {
  const VertexHandle last = insert({0.3, 0.7});
  std::vector<Uv> expected = positions(delaunay_);
  expected.pop_back();
  delaunay_.collapse(collapsible_from(last));
  EXPECT_EQ(positions(delaunay_), expected);
}

TEST_F(CollapsedMesh, TakesPointsAgain) {
  for (int i = 0; i < 100; ++i) delaunay_.collapse(collapsible());
  const std::size_t count = delaunay_.n_vertices();
  for (const Uv p : testing::random_points(200, 4)) insert(p);
  EXPECT_EQ(delaunay_.n_vertices(), count + 200);
  EXPECT_NEAR(valid_area(delaunay_), 1, 1e-12);
}

}  // namespace
}  // namespace surfmesh
