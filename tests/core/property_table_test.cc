// SPDX-License-Identifier: BSD-3-Clause
// The last three columns of the table of properties in libsurfmesh/README.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"

namespace surfmesh {
namespace {

using Ends = std::pair<int, int>;

double first_of(const Uv& value) { return value.u; }
double first_of(const Metric& value) { return value.m11; }
double first_of(const SizeTensor& value) { return value.h11; }

/// A hexagon with two vertices inside, 6 and 7, both joined to 0 and 3.
class PropertyTable : public ::testing::Test {
 protected:
  PropertyTable() {
    build_triangles(
        mesh_, 8,
        {{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {0, 6, 7}, {6, 3, 7}, {3, 4, 7}, {4, 5, 7}, {5, 0, 7}});
    constrained_ = attach(mesh_, keys::edge_constrained);
  }

  HalfedgeHandle halfedge(int from, int to) const {
    return mesh_.find_halfedge(VertexHandle(from), VertexHandle(to));
  }

  EdgeHandle edge(Ends ends) const { return mesh_.edge_handle(halfedge(ends.first, ends.second)); }

  void constrain(const std::set<Ends>& edges) {
    for (const Ends& ends : edges) mesh_.property(constrained_, edge(ends)) = 1;
  }

  std::set<Ends> constrained() const {
    std::set<Ends> result;
    for (const EdgeHandle eh : mesh_.edges()) {
      if (mesh_.property(constrained_, eh) == 0) continue;
      const HalfedgeHandle heh = mesh_.halfedge_handle(eh, 0);
      result.insert(
          std::minmax({mesh_.from_vertex_handle(heh).idx(), mesh_.to_vertex_handle(heh).idx()}));
    }
    return result;
  }

  /// Give the vertices their numbers as values.
  template <class Key>
  void number_vertices(const Key& key) {
    const auto handle = attach(mesh_, key);
    for (const VertexHandle vh : mesh_.vertices()) {
      const double number = vh.idx();
      if constexpr (std::is_same_v<typename Key::Value, Uv>) {
        mesh_.property(handle, vh) = {number, 0};
      } else {
        mesh_.property(handle, vh) = {number, 0, 1};
      }
    }
  }

  template <class Key>
  std::vector<double> values(const Key& key) const {
    std::vector<double> result;
    const auto handle = require(mesh_, key);
    for (const VertexHandle vh : mesh_.vertices()) {
      result.push_back(first_of(mesh_.property(handle, vh)));
    }
    return result;
  }

  /// Put a vertex into the two triangles at the edge from 1 to 6.
  void split() {
    Cavity cavity;
    cavity.rim = {halfedge(0, 1), halfedge(1, 2), halfedge(2, 6), halfedge(6, 0)};
    cavity.inner_edges = {edge({1, 6})};
    cavity.faces = {mesh_.face_handle(halfedge(0, 1)), mesh_.face_handle(halfedge(1, 2))};
    ElementPool pool(mesh_);
    fill_cavity(mesh_, pool, cavity, constrained_);
    pool.shrink();
  }

  void split_boundary() {
    Cavity cavity;
    cavity.split = halfedge(0, 1);
    cavity.rim = {halfedge(1, 6), halfedge(6, 0)};
    cavity.faces = {mesh_.face_handle(cavity.split)};
    ElementPool pool(mesh_);
    fill_cavity(mesh_, pool, cavity, constrained_);
    pool.shrink();
  }

  /// Merge vertex 6 into 1; 7 gets its number. `key` is moved along with surf:constrained.
  template <class Key>
  void collapse_with(const Key& key) {
    const auto handle = require(mesh_, key);
    ElementPool pool(mesh_);
    pool.remove(collapse(mesh_, halfedge(6, 1)), [&]<class Handle>(Handle from, Handle to) {
      if constexpr (std::is_same_v<Handle, VertexHandle>) {
        mesh_.property(handle, to) = mesh_.property(handle, from);
      } else if constexpr (std::is_same_v<Handle, EdgeHandle>) {
        mesh_.property(constrained_, to) = mesh_.property(constrained_, from);
      }
    });
    pool.shrink();
  }

  template <class Key>
  void expect_unset_after_a_split(const Key& key) {
    number_vertices(key);
    split();
    const std::vector<double> after = values(key);
    ASSERT_EQ(after.size(), 9u);
    for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(after[v], static_cast<double>(v));
    EXPECT_TRUE(std::isnan(after.back()));
  }

  template <class Key>
  void expect_kept_by_a_flip(const Key& key) {
    number_vertices(key);
    flip(mesh_, edge({1, 6}));
    EXPECT_EQ(values(key), (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7}));
  }

  template <class Key>
  void expect_kept_by_a_collapse(const Key& key) {
    number_vertices(key);
    collapse_with(key);
    EXPECT_EQ(values(key), (std::vector<double>{0, 1, 2, 3, 4, 5, 7}));
  }

  PolyMesh mesh_;
  decltype(keys::edge_constrained)::Handle constrained_;
};

TEST_F(PropertyTable, UvIsUnsetAfterASplit) { expect_unset_after_a_split(keys::vertex_uv); }
TEST_F(PropertyTable, UvIsKeptByAFlip) { expect_kept_by_a_flip(keys::vertex_uv); }
TEST_F(PropertyTable, UvIsKeptByACollapse) { expect_kept_by_a_collapse(keys::vertex_uv); }

TEST_F(PropertyTable, MetricIsUnsetAfterASplit) { expect_unset_after_a_split(keys::vertex_metric); }
TEST_F(PropertyTable, MetricIsKeptByAFlip) { expect_kept_by_a_flip(keys::vertex_metric); }
TEST_F(PropertyTable, MetricIsKeptByACollapse) { expect_kept_by_a_collapse(keys::vertex_metric); }

TEST_F(PropertyTable, SizeIsUnsetAfterASplit) { expect_unset_after_a_split(keys::vertex_size); }
TEST_F(PropertyTable, SizeIsKeptByAFlip) { expect_kept_by_a_flip(keys::vertex_size); }

TEST_F(PropertyTable, NoSpokeOfASplitIsConstrained) {
  constrain({{0, 1}, {1, 6}, {2, 6}, {4, 7}});
  split();
  EXPECT_EQ(constrained(), (std::set<Ends>{{0, 1}, {2, 6}, {4, 7}}));
}

TEST_F(PropertyTable, BothPartsOfASplitBoundaryEdgeAreConstrained) {
  constrain({{0, 1}, {2, 6}});
  split_boundary();
  EXPECT_EQ(constrained(), (std::set<Ends>{{0, 8}, {1, 8}, {2, 6}}));
}

TEST_F(PropertyTable, ConstraintsAreKeptByAFlip) {
  constrain({{0, 1}, {2, 6}, {1, 6}});
  flip(mesh_, edge({1, 6}));
  EXPECT_EQ(constrained(), (std::set<Ends>{{0, 1}, {0, 2}, {2, 6}}));
}

TEST_F(PropertyTable, ACollapseLosesConstraintsOfTheEdgeAndTheSidesAtItsOriginOnly) {
  number_vertices(keys::vertex_uv);
  constrain({{0, 1}, {1, 6}, {2, 6}, {0, 6}, {3, 6}, {6, 7}, {5, 7}});
  collapse_with(keys::vertex_uv);
  EXPECT_EQ(constrained(), (std::set<Ends>{{0, 1}, {1, 3}, {1, 6}, {5, 6}}));
}

}  // namespace
}  // namespace surfmesh
