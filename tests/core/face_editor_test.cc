// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/face_editor.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <type_traits>

#include "support/expect_valid.hh"
#include "support/quad_meshes.hh"

namespace surfmesh {
namespace {

using testing::cycle_of;
using testing::GridNumbers;
using testing::halfedge_between;
using testing::quad_grid;

/// All links of the elements in use: halfedges of faces and those beside them, faces, vertices.
std::vector<std::array<int, 5>> links_of(const PolyMesh& mesh, const FaceEditor& editor) {
  std::vector<std::array<int, 5>> links;
  std::set<int> halfedges;
  for (std::size_t f = 0; f < editor.face_bound(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    links.push_back({0, fh.idx(), mesh.halfedge_handle(fh).idx()});
    if (!editor.is_used(fh)) continue;
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      halfedges.insert({heh.idx(), mesh.opposite_halfedge_handle(heh).idx()});
    }
  }
  for (const int h : halfedges) {
    const HalfedgeHandle heh(h);
    links.push_back({1 + h, mesh.next_halfedge_handle(heh).idx(),
                     mesh.prev_halfedge_handle(heh).idx(), mesh.to_vertex_handle(heh).idx(),
                     mesh.face_handle(heh).idx()});
  }
  for (std::size_t v = 0; v < editor.vertex_bound(); ++v) {
    const VertexHandle vh(static_cast<int>(v));
    links.push_back({-1, vh.idx(), mesh.halfedge_handle(vh).idx()});
  }
  return links;
}

void compact(FaceEditor& editor) {
  editor.compact([](auto, auto) {});
}

/// Six unit squares, three in each row.
class SixSquares : public ::testing::Test {
 protected:
  /// The edge between the squares (0,0) and (1,0).
  HalfedgeHandle middle() const { return halfedge_between(mesh_, number_(1, 0), number_(1, 1)); }

  /// The two squares there as one face of six corners.
  FaceCycles merged() const {
    FaceCycles cycles;
    cycles.add(
        {number_(0, 0), number_(1, 0), number_(2, 0), number_(2, 1), number_(1, 1), number_(0, 1)});
    return cycles;
  }

  GridNumbers number_{3, 2};
  PolyMesh mesh_ = quad_grid(number_);
  FaceEditor editor_{mesh_};
  std::vector<FaceHandle> made_;
  const std::vector<FaceHandle> first_two_ = {FaceHandle(0), FaceHandle(1)};
};

TEST_F(SixSquares, ReplacedByFacesOfTheGivenCycles) {
  editor_.replace(first_two_, merged(), made_);
  ASSERT_EQ(made_.size(), 1u);
  EXPECT_EQ(cycle_of(mesh_, made_[0]).size(), 6u);
  compact(editor_);
  testing::expect_valid(mesh_);
  EXPECT_EQ(mesh_.n_faces(), 5u);
  EXPECT_EQ(mesh_.n_edges(), 16u);
}

TEST_F(SixSquares, KeepTheSidesOfTheRimWithTheirProperties) {
  const auto contour = attach(mesh_, keys::edge_contour, -1);
  std::vector<EdgeHandle> rim;
  for (const FaceHandle fh : first_two_) {
    for (const EdgeHandle eh : mesh_.fe_range(fh)) {
      if (eh != mesh_.edge_handle(middle())) rim.push_back(eh);
    }
  }
  for (const EdgeHandle eh : rim) mesh_.property(contour, eh) = 100 + eh.idx();
  editor_.replace(first_two_, merged(), made_);
  std::set<EdgeHandle> sides;
  for (const EdgeHandle eh : mesh_.fe_range(made_[0])) sides.insert(eh);
  EXPECT_EQ(sides, std::set<EdgeHandle>(rim.begin(), rim.end()));
  for (const EdgeHandle eh : rim) EXPECT_EQ(mesh_.property(contour, eh), 100 + eh.idx());
}

TEST_F(SixSquares, GiveTheNumbersOfOldFacesAndEdgesToNewOnes) {
  const EdgeHandle gone = mesh_.edge_handle(middle());
  editor_.replace(first_two_, merged(), made_);
  const std::vector<FaceHandle> one = made_;
  FaceCycles two;
  two.add({number_(0, 0), number_(1, 0), number_(2, 0), number_(2, 1)});
  two.add({number_(2, 1), number_(1, 1), number_(0, 1), number_(0, 0)});
  editor_.replace(one, two, made_);
  EXPECT_EQ(editor_.face_bound(), 6u);
  EXPECT_EQ(std::set<FaceHandle>(made_.begin(), made_.end()),
            std::set<FaceHandle>(first_two_.begin(), first_two_.end()));
  EXPECT_EQ(mesh_.edge_handle(halfedge_between(mesh_, number_(0, 0), number_(2, 1))), gone);
}

TEST_F(SixSquares, LeaveVerticesIsolatedThatOnlyOldFacesHad) {
  const std::vector<FaceHandle> around = {FaceHandle(0), FaceHandle(1), FaceHandle(3),
                                          FaceHandle(4)};
  FaceCycles ring;
  ring.add({number_(0, 0), number_(1, 0), number_(2, 0), number_(2, 1), number_(2, 2),
            number_(1, 2), number_(0, 2), number_(0, 1)});
  editor_.replace(around, ring, made_);
  EXPECT_FALSE(editor_.is_used(number_(1, 1)));
  EXPECT_TRUE(editor_.is_used(number_(2, 1)));
  EXPECT_NE(editor_.add_vertex(), number_(1, 1));  // not free before it is freed
  editor_.free_vertex(number_(1, 1));
  EXPECT_EQ(editor_.add_vertex(), number_(1, 1));
}

TEST_F(SixSquares, KeepTheOpenHalfedgesOfTheirBoundary) {
  std::vector<HalfedgeHandle> before;
  for (std::size_t v = 0; v < number_.fixed(); ++v) {
    before.push_back(mesh_.halfedge_handle(VertexHandle(static_cast<int>(v))));
  }
  editor_.replace(first_two_, merged(), made_);
  for (std::size_t v = 0; v < number_.fixed(); ++v) {
    const VertexHandle vh(static_cast<int>(v));
    EXPECT_TRUE(mesh_.is_boundary(vh));
    EXPECT_EQ(mesh_.halfedge_handle(vh), before[v]);
  }
}

TEST_F(SixSquares, TakeFacesAroundAVertexThatIsAdded) {
  const VertexHandle vh = editor_.add_vertex();
  EXPECT_FALSE(editor_.is_used(vh));
  FaceCycles fan;
  const std::vector<VertexHandle> square = cycle_of(mesh_, FaceHandle(0));
  for (std::size_t k = 0; k < 4; ++k) fan.add({square[k], square[(k + 1) % 4], vh});
  editor_.replace(std::vector{FaceHandle(0)}, fan, made_);
  EXPECT_TRUE(editor_.is_used(vh));
  compact(editor_);
  testing::expect_valid(mesh_);
  EXPECT_EQ(mesh_.valence(vh), 4u);
  EXPECT_EQ(mesh_.n_faces(), 9u);
}

TEST_F(SixSquares, AreAsBeforeWhenAReplacementIsUndone) {
  const auto before = links_of(mesh_, editor_);
  editor_.replace(first_two_, merged(), made_);
  EXPECT_NE(links_of(mesh_, editor_), before);
  editor_.undo_replacement();
  EXPECT_EQ(links_of(mesh_, editor_), before);
  compact(editor_);
  testing::expect_valid(mesh_);
}

TEST_F(SixSquares, HaveNoHolesInTheirNumbersAfterCompact) {
  const auto uv = attach(mesh_, keys::vertex_uv);
  const auto patch = attach(mesh_, keys::face_patch, 0);
  const auto contour = attach(mesh_, keys::edge_contour, 0);
  for (const VertexHandle vh : mesh_.vertices()) mesh_.property(uv, vh) = {1.0 * vh.idx(), 0};
  for (const FaceHandle fh : mesh_.faces()) mesh_.property(patch, fh) = fh.idx();
  for (const EdgeHandle eh : mesh_.edges()) mesh_.property(contour, eh) = eh.idx();
  editor_.replace(first_two_, merged(), made_);
  mesh_.property(patch, made_[0]) = 7;
  editor_.compact([&](auto from, auto to) {
    using Handle = decltype(from);
    if constexpr (std::is_same_v<Handle, VertexHandle>) {
      mesh_.property(uv, to) = mesh_.property(uv, from);
    } else if constexpr (std::is_same_v<Handle, EdgeHandle>) {
      mesh_.property(contour, to) = mesh_.property(contour, from);
    } else {
      mesh_.property(patch, to) = mesh_.property(patch, from);
    }
  });
  std::multiset<int> patches;
  for (const FaceHandle fh : mesh_.faces()) patches.insert(mesh_.property(patch, fh));
  EXPECT_EQ(patches, (std::multiset<int>{2, 3, 4, 5, 7}));
  std::set<int> contours;
  for (const EdgeHandle eh : mesh_.edges()) contours.insert(mesh_.property(contour, eh));
  EXPECT_EQ(contours.size(), mesh_.n_edges());
  for (const VertexHandle vh : mesh_.vertices()) EXPECT_EQ(mesh_.property(uv, vh).u, vh.idx());
}

// --- random replacements ---

bool are_joined(const PolyMesh& mesh, VertexHandle a, VertexHandle b) {
  return halfedge_between(mesh, a, b).is_valid();
}

/// The corners of the two faces at an edge without it, counter-clockwise; empty if a vertex is
/// there twice.
std::vector<VertexHandle> cycle_around(const PolyMesh& mesh, EdgeHandle eh) {
  std::vector<VertexHandle> cycle;
  for (const unsigned side : {0u, 1u}) {
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, side);
    for (HalfedgeHandle h = mesh.next_halfedge_handle(heh); h != heh;
         h = mesh.next_halfedge_handle(h)) {
      cycle.push_back(mesh.from_vertex_handle(h));
    }
  }
  const std::set<VertexHandle> distinct(cycle.begin(), cycle.end());
  return distinct.size() == cycle.size() ? cycle : std::vector<VertexHandle>{};
}

/// Replaces the two faces at random edges: by one face, by two that a diagonal divides, or by
/// triangles around a new vertex.
class RandomReplacements {
 public:
  RandomReplacements(PolyMesh& mesh, FaceEditor& editor, unsigned seed)
      : mesh_(mesh), editor_(editor), random_(seed) {}

  bool prepare() {
    const std::vector<EdgeHandle> edges = inner_edges();
    const EdgeHandle eh = edges[random_() % edges.size()];
    const std::vector<VertexHandle> cycle = cycle_around(mesh_, eh);
    if (cycle.empty()) return false;
    old_ = {mesh_.face_handle(mesh_.halfedge_handle(eh, 0)),
            mesh_.face_handle(mesh_.halfedge_handle(eh, 1))};
    fresh_.clear();
    added_ = VertexHandle();
    switch (random_() % 3) {
      case 0:
        if (cycle.size() > 8) return false;
        fresh_.add(cycle);
        return true;
      case 1:
        return divide(cycle);
      default:
        fan(cycle);
        return true;
    }
  }

  void replace() { editor_.replace(old_, fresh_, made_); }

  /// Give the new vertex back after an undo.
  void discard() {
    if (added_.is_valid()) editor_.free_vertex(added_);
  }

  const std::vector<FaceHandle>& made() const { return made_; }

 private:
  std::vector<EdgeHandle> inner_edges() const {
    std::vector<EdgeHandle> edges;
    for (std::size_t f = 0; f < editor_.face_bound(); ++f) {
      const FaceHandle fh(static_cast<int>(f));
      if (!editor_.is_used(fh)) continue;
      for (const EdgeHandle eh : mesh_.fe_range(fh)) {
        if (!mesh_.is_boundary(eh)) edges.push_back(eh);
      }
    }
    return edges;
  }

  bool divide(const std::vector<VertexHandle>& cycle) {
    const std::size_t n = cycle.size(), from = random_() % n, steps = 2 + random_() % (n - 3);
    const auto corner = [&](std::size_t k) { return cycle[(from + k) % n]; };
    const bool is_old_edge = cycle_of(mesh_, old_[0]).size() == steps + 1;
    if (is_old_edge || are_joined(mesh_, corner(0), corner(steps))) return false;
    std::vector<VertexHandle> first, second = {corner(0)};
    for (std::size_t k = 0; k <= steps; ++k) first.push_back(corner(k));
    for (std::size_t k = steps; k < n; ++k) second.push_back(corner(k));
    fresh_.add(first);
    fresh_.add(second);
    return true;
  }

  void fan(const std::vector<VertexHandle>& cycle) {
    added_ = editor_.add_vertex();
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      fresh_.add({cycle[k], cycle[(k + 1) % cycle.size()], added_});
    }
  }

  PolyMesh& mesh_;
  FaceEditor& editor_;
  std::mt19937 random_;
  std::vector<FaceHandle> old_, made_;
  FaceCycles fresh_;
  VertexHandle added_;
};

/// Undo every replacement of 300, make it again, and keep every other one.
void expect_undone_exactly(PolyMesh& mesh, unsigned seed) {
  FaceEditor editor(mesh);
  RandomReplacements random(mesh, editor, seed);
  int kept = 0;
  for (int i = 0; i < 300; ++i) {
    if (!random.prepare()) continue;
    const auto before = links_of(mesh, editor);
    random.replace();
    const auto after = links_of(mesh, editor);
    const std::vector<FaceHandle> made = random.made();
    editor.undo_replacement();
    ASSERT_EQ(links_of(mesh, editor), before) << "replacement " << i;
    random.replace();
    ASSERT_EQ(links_of(mesh, editor), after) << "replacement " << i;
    ASSERT_EQ(random.made(), made) << "replacement " << i;
    if (i % 2 == 0) {
      ++kept;
      continue;
    }
    editor.undo_replacement();
    random.discard();
  }
  EXPECT_GT(kept, 50);
  compact(editor);
  testing::expect_valid(mesh);
  EXPECT_EQ(measure_topology(mesh).euler, 1);
}

TEST(UndoReplacement, RestoresAllLinksAndNumbersOfQuads) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    PolyMesh mesh = quad_grid(GridNumbers(5, 4));
    expect_undone_exactly(mesh, seed);
  }
}

TEST(UndoReplacement, RestoresAllLinksAndNumbersOfTriangles) {
  for (const unsigned seed : {4u, 5u, 6u}) {
    PolyMesh mesh = testing::plane_grid(4, 4);
    expect_undone_exactly(mesh, seed);
  }
}

TEST(FaceCycles, ListTheirFacesInOrder) {
  FaceCycles cycles;
  cycles.add({VertexHandle(3), VertexHandle(1), VertexHandle(2)});
  cycles.add({VertexHandle(0), VertexHandle(3), VertexHandle(2), VertexHandle(5)});
  ASSERT_EQ(cycles.size(), 2u);
  EXPECT_EQ(cycles[0].size(), 3u);
  EXPECT_EQ(cycles[1].size(), 4u);
  EXPECT_EQ(cycles[1][3], VertexHandle(5));
  EXPECT_EQ(cycles.vertices().size(), 7u);
  cycles.clear();
  EXPECT_EQ(cycles.size(), 0u);
}

}  // namespace
}  // namespace surfmesh
