// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/quad_moves.hh"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <set>

#include "quad/grid_patch.hh"
#include "support/expect_valid.hh"

namespace surfmesh {
namespace {

using testing::GridPatch;
using testing::kAny;

/// A grid whose connectivity is changed without regard to shapes.
class Grid {
 public:
  Grid(int columns, int rows) : patch_(columns, rows) {
    wanted_.assign(patch_.number.fixed(), 2);
    for (const auto& [i, j] : {std::pair{0, 0}, {columns, 0}, {columns, rows}, {0, rows}}) {
      wanted_[index(patch_.vertex(i, j))] = 1;
    }
    renew();
  }

  GridPatch& patch() { return patch_; }
  const PolyMesh& mesh() const { return patch_.mesh; }
  QuadState& state() { return *state_; }

  /// Make a change.
  void apply(const Replacement& change) {
    for (const Replacement::Middle& middle : change.middles) {
      patch_.geometry.put_between(middle.vertex, middle.others);
    }
    patch_.editor.replace(change.old, change.fresh, made_);
    for (const VertexHandle vh : change.removed) patch_.editor.free_vertex(vh);
    renew();
  }

  void discard(const Replacement& change) {
    for (const VertexHandle vh : change.added) patch_.editor.free_vertex(vh);
  }

  std::size_t count_faces() const {
    std::size_t count = 0;
    for (std::size_t f = 0; f < patch_.editor.face_bound(); ++f) {
      count += patch_.editor.is_used(FaceHandle(static_cast<int>(f))) ? 1 : 0;
    }
    return count;
  }

  std::vector<VertexHandle> vertices() const {
    std::vector<VertexHandle> used;
    for (std::size_t v = 0; v < patch_.editor.vertex_bound(); ++v) {
      const VertexHandle vh(static_cast<int>(v));
      if (patch_.editor.is_used(vh)) used.push_back(vh);
    }
    return used;
  }

  /// Σ excess², counted anew.
  int squares() const {
    int sum = 0;
    for (const VertexHandle vh : vertices()) {
      const auto wanted = index(vh) < wanted_.size() ? wanted_[index(vh)] : 4;
      const int excess = faces_at(vh) - wanted;
      sum += excess * excess;
    }
    return sum;
  }

  int faces_at(VertexHandle vh) const {
    int count = 0;
    for (const HalfedgeHandle heh : mesh().voh_range(vh)) count += mesh().is_boundary(heh) ? 0 : 1;
    return count;
  }

  /// The halfedges of all faces.
  std::vector<HalfedgeHandle> halfedges() const {
    std::vector<HalfedgeHandle> result;
    for (std::size_t f = 0; f < patch_.editor.face_bound(); ++f) {
      const FaceHandle fh(static_cast<int>(f));
      if (!patch_.editor.is_used(fh)) continue;
      for (const HalfedgeHandle heh : mesh().fh_range(fh)) result.push_back(heh);
    }
    return result;
  }

  /// A mesh of quads with the topology of a disc, inner vertices of three faces or more, and no two
  /// vertices joined twice. Compacts it.
  void expect_proper() {
    for (const VertexHandle vh : vertices()) {
      EXPECT_TRUE(mesh().is_boundary(vh) || faces_at(vh) >= 3);
    }
    patch_.editor.compact([](auto, auto) {});
    testing::expect_valid(mesh());
    EXPECT_EQ(measure_topology(mesh()).euler, 1);
    EXPECT_EQ(measure_topology(mesh()).components, 1u);
    for (const FaceHandle fh : mesh().faces()) EXPECT_EQ(mesh().valence(fh), 4u);
  }

 private:
  void renew() {
    state_ = std::make_unique<QuadState>(patch_.mesh, patch_.editor, patch_.geometry, wanted_);
  }

  GridPatch patch_;
  std::vector<int> wanted_;
  std::vector<FaceHandle> made_;
  std::unique_ptr<QuadState> state_;
};

// --- single moves on a lattice ---

class QuadMoves : public ::testing::Test {
 protected:
  VertexHandle at(int i, int j) { return grid_.patch().vertex(i, j); }
  HalfedgeHandle side(VertexHandle from, VertexHandle to) {
    return grid_.patch().halfedge(from, to);
  }

  Grid grid_{4, 4};
  Replacement change_;
};

TEST_F(QuadMoves, CollapseAQuadMergesTheTipIntoTheOppositeCorner) {
  ASSERT_TRUE(collapse_quad(grid_.state(), side(at(1, 2), at(1, 1)), kAny, change_));
  EXPECT_EQ(change_.removed, std::vector{at(1, 1)});
  grid_.apply(change_);
  EXPECT_EQ(grid_.count_faces(), 15u);
  EXPECT_EQ(grid_.vertices().size(), 24u);
  EXPECT_EQ(grid_.faces_at(at(2, 2)), 6);
  EXPECT_EQ(grid_.patch().uv(at(2, 2)), (Uv{1.5, 1.5}));
  grid_.expect_proper();
}

TEST_F(QuadMoves, CollapseAQuadIntoTheBoundaryLeavesThatWhereItIs) {
  ASSERT_TRUE(collapse_quad(grid_.state(), side(at(2, 0), at(2, 1)), kAny, change_));
  EXPECT_EQ(change_.removed, std::vector{at(2, 1)});
  grid_.apply(change_);
  EXPECT_EQ(grid_.patch().uv(at(1, 0)), (Uv{1, 0}));
  grid_.expect_proper();
}

TEST_F(QuadMoves, CollapseAQuadRefusesToMoveABoundaryVertex) {
  EXPECT_FALSE(collapse_quad(grid_.state(), side(at(1, 1), at(1, 0)), kAny, change_));
}

TEST_F(QuadMoves, CollapseAQuadMergesTwoVerticesThatMayMoveOneWayOnly) {
  EXPECT_FALSE(collapse_quad(grid_.state(), side(at(2, 1), at(2, 2)), kAny, change_));
}

/// Of the quad in the corner, (1,1) would merge into (0,0), and (1,0) and (0,1) lose a face.
TEST_F(QuadMoves, CollapseAQuadRefusesToTakeTheLastFaceOfAVertex) {
  const VertexHandle middle = at(1, 1);
  ASSERT_TRUE(collapse_quad(grid_.state(), side(at(1, 0), middle), kAny, change_));
  grid_.apply(change_);
  ASSERT_EQ(grid_.faces_at(at(1, 0)), 1);
  for (const HalfedgeHandle heh : grid_.halfedges()) {
    const HalfedgeHandle next = grid_.mesh().next_halfedge_handle(heh);
    const bool is_beside = grid_.mesh().from_vertex_handle(heh) == at(1, 0) ||
                           grid_.mesh().to_vertex_handle(next) == at(1, 0);
    EXPECT_FALSE(is_beside && collapse_quad(grid_.state(), heh, kAny, change_));
  }
}

TEST_F(QuadMoves, RotateAnEdgeToTheNextCornersOfItsFaces) {
  ASSERT_TRUE(
      rotate_edge(grid_.state(), side(at(2, 1), at(2, 2)), Turn::CounterClockwise, kAny, change_));
  grid_.apply(change_);
  EXPECT_FALSE(side(at(2, 1), at(2, 2)).is_valid());
  EXPECT_TRUE(side(at(1, 2), at(3, 1)).is_valid());
  EXPECT_EQ(grid_.count_faces(), 16u);
  EXPECT_EQ(grid_.vertices().size(), 25u);
  grid_.expect_proper();
}

TEST_F(QuadMoves, RotateAnEdgeTheOtherWay) {
  ASSERT_TRUE(rotate_edge(grid_.state(), side(at(2, 1), at(2, 2)), Turn::Clockwise, kAny, change_));
  grid_.apply(change_);
  EXPECT_TRUE(side(at(1, 1), at(3, 2)).is_valid());
  grid_.expect_proper();
}

TEST_F(QuadMoves, RotateAnEdgeAndBackIsTheLattice) {
  ASSERT_TRUE(
      rotate_edge(grid_.state(), side(at(2, 1), at(2, 2)), Turn::CounterClockwise, kAny, change_));
  grid_.apply(change_);
  ASSERT_TRUE(rotate_edge(grid_.state(), side(at(1, 2), at(3, 1)), Turn::Clockwise, kAny, change_));
  grid_.apply(change_);
  EXPECT_TRUE(side(at(2, 1), at(2, 2)).is_valid());
  EXPECT_EQ(grid_.squares(), 0);
}

TEST_F(QuadMoves, RotateAnEdgeRefusesOneOfTheBoundary) {
  for (const Turn turn : {Turn::CounterClockwise, Turn::Clockwise}) {
    EXPECT_FALSE(rotate_edge(grid_.state(), side(at(1, 0), at(2, 0)), turn, kAny, change_));
    EXPECT_FALSE(rotate_edge(grid_.state(), side(at(2, 0), at(1, 0)), turn, kAny, change_));
  }
}

TEST_F(QuadMoves, RotateAnEdgeRefusesToLeaveAnInnerVertexWithTwoFaces) {
  ASSERT_TRUE(
      rotate_edge(grid_.state(), side(at(2, 1), at(2, 2)), Turn::CounterClockwise, kAny, change_));
  grid_.apply(change_);
  ASSERT_EQ(grid_.faces_at(at(2, 2)), 3);
  for (const Turn turn : {Turn::CounterClockwise, Turn::Clockwise}) {
    EXPECT_FALSE(rotate_edge(grid_.state(), side(at(2, 2), at(2, 3)), turn, kAny, change_));
    EXPECT_FALSE(rotate_edge(grid_.state(), side(at(2, 3), at(2, 2)), turn, kAny, change_));
  }
}

TEST_F(QuadMoves, OpenAVertexPutsAQuadBetweenItAndANewOne) {
  ASSERT_TRUE(open_vertex(grid_.state(), side(at(2, 2), at(3, 2)), 2, kAny, change_));
  ASSERT_EQ(change_.added.size(), 1u);
  const VertexHandle added = change_.added[0];
  grid_.apply(change_);
  EXPECT_EQ(grid_.count_faces(), 17u);
  EXPECT_EQ(grid_.vertices().size(), 26u);
  EXPECT_EQ(grid_.faces_at(at(2, 2)), 3);
  EXPECT_EQ(grid_.faces_at(added), 3);
  EXPECT_EQ(grid_.faces_at(at(3, 2)), 5);
  EXPECT_EQ(grid_.faces_at(at(1, 2)), 5);
  grid_.expect_proper();
}

TEST_F(QuadMoves, OpenAVertexRefusesFacesBeyondTheBoundary) {
  EXPECT_FALSE(open_vertex(grid_.state(), side(at(2, 0), at(3, 0)), 3, kAny, change_));
  EXPECT_FALSE(open_vertex(grid_.state(), side(at(2, 0), at(1, 0)), 2, kAny, change_));
}

TEST_F(QuadMoves, InsertAColumnGivesACornerOfTheBoundaryAnotherEdge) {
  // The neighbour of the corner (0,0) gets five faces first, so that it can be split.
  ASSERT_TRUE(open_vertex(grid_.state(), side(at(2, 1), at(3, 1)), 2, kAny, change_));
  grid_.apply(change_);
  ASSERT_EQ(grid_.faces_at(at(1, 1)), 5);
  ASSERT_TRUE(insert_column(grid_.state(), side(at(0, 0), at(1, 0)), 2, change_));
  grid_.apply(change_);
  EXPECT_EQ(grid_.count_faces(), 18u);
  EXPECT_EQ(grid_.vertices().size(), 27u);
  EXPECT_EQ(grid_.faces_at(at(0, 0)), 2);
  grid_.expect_proper();
}

TEST_F(QuadMoves, InsertAPillowPutsFiveQuadsInPlaceOfOne) {
  ASSERT_TRUE(insert_pillow(grid_.state(), grid_.patch().face(1, 1), change_));
  ASSERT_EQ(change_.added.size(), 4u);
  const std::vector<VertexHandle> added = change_.added;
  grid_.apply(change_);
  EXPECT_EQ(grid_.count_faces(), 20u);
  EXPECT_EQ(grid_.vertices().size(), 29u);
  for (const VertexHandle vh : added) EXPECT_EQ(grid_.faces_at(vh), 3);
  EXPECT_EQ(grid_.faces_at(at(1, 1)), 5);
  grid_.expect_proper();
}

TEST_F(QuadMoves, InsertAPillowKeepsTheSquareShape) {
  ASSERT_TRUE(insert_pillow(grid_.state(), grid_.patch().face(1, 1), change_));
  grid_.apply(change_);
  EXPECT_GT(testing::least_jacobian(grid_.patch()), 0.7);
}

TEST_F(QuadMoves, DissolveADoubletLeavesOneQuad) {
  GridPatch& patch = grid_.patch();
  const VertexHandle v = patch.editor.add_vertex();
  patch.geometry.put_between(v, std::vector{at(1, 1), at(2, 2)});
  Replacement doublet;
  doublet.old = {patch.face(1, 1)};
  doublet.fresh.add({at(1, 1), at(2, 1), at(2, 2), v});
  doublet.fresh.add({at(2, 2), at(1, 2), at(1, 1), v});
  grid_.apply(doublet);
  ASSERT_EQ(grid_.faces_at(v), 2);
  ASSERT_TRUE(dissolve_doublet(grid_.state(), v, change_));
  grid_.apply(change_);
  EXPECT_FALSE(patch.editor.is_used(v));
  EXPECT_EQ(grid_.squares(), 0);
  EXPECT_EQ(grid_.count_faces(), 16u);
  grid_.expect_proper();
}

TEST_F(QuadMoves, LeaveTrianglesAsTheyAre) {
  GridPatch& patch = grid_.patch();
  Replacement cut;
  cut.old = {patch.face(1, 1)};
  cut.fresh.add({at(1, 1), at(2, 1), at(2, 2)});
  cut.fresh.add({at(2, 2), at(1, 2), at(1, 1)});
  grid_.apply(cut);
  EXPECT_FALSE(
      rotate_edge(grid_.state(), side(at(1, 1), at(2, 2)), Turn::Clockwise, kAny, change_));
  EXPECT_FALSE(
      rotate_edge(grid_.state(), side(at(1, 1), at(2, 1)), Turn::Clockwise, kAny, change_));
  EXPECT_FALSE(collapse_quad(grid_.state(), side(at(3, 2), at(2, 2)), kAny, change_));
  EXPECT_FALSE(open_vertex(grid_.state(), side(at(1, 1), at(2, 1)), 2, kAny, change_));
  for (const FaceHandle fh : grid_.mesh().vf_range(at(1, 1))) {
    EXPECT_EQ(insert_pillow(grid_.state(), fh, change_), grid_.mesh().valence(fh) == 4);
  }
}

TEST(RotateEdge, RefusesToJoinTwoVerticesTwice) {
  Grid grid(3, 3);
  GridPatch& patch = grid.patch();
  const auto at = [&](int i, int j) { return patch.vertex(i, j); };
  Replacement change;
  // Joins (1,2) and (3,1); then the edge beside it would do so again.
  ASSERT_TRUE(rotate_edge(grid.state(), patch.halfedge(at(2, 1), at(2, 2)), Turn::CounterClockwise,
                          kAny, change));
  grid.apply(change);
  for (const HalfedgeHandle heh : grid.halfedges()) {
    for (const Turn turn : {Turn::CounterClockwise, Turn::Clockwise}) {
      if (!rotate_edge(grid.state(), heh, turn, kAny, change)) continue;
      const auto first = change.fresh[0];
      EXPECT_FALSE(patch.halfedge(first[0], first[3]).is_valid()) << "the new edge is there";
    }
  }
}

// --- all moves on irregular meshes ---

using Move = std::function<bool(Grid&, HalfedgeHandle, int most, Replacement&)>;

std::vector<Move> bounded_moves() {
  std::vector<Move> moves = {[](Grid& grid, HalfedgeHandle heh, int most, Replacement& change) {
    return collapse_quad(grid.state(), heh, most, change);
  }};
  for (const Turn turn : {Turn::CounterClockwise, Turn::Clockwise}) {
    moves.push_back([turn](Grid& grid, HalfedgeHandle heh, int most, Replacement& change) {
      return rotate_edge(grid.state(), heh, turn, most, change);
    });
  }
  for (const int faces : {2, 3}) {
    moves.push_back([faces](Grid& grid, HalfedgeHandle heh, int most, Replacement& change) {
      const VertexHandle vh = grid.mesh().from_vertex_handle(heh);
      const int possible = grid.faces_at(vh) - (grid.mesh().is_boundary(vh) ? 1 : 2);
      return faces <= possible && open_vertex(grid.state(), heh, faces, most, change);
    });
  }
  return moves;
}

/// Columns and pillows, which have no bound.
std::vector<Move> free_moves() {
  return {[](Grid& grid, HalfedgeHandle heh, int, Replacement& change) {
            const VertexHandle vh = grid.mesh().from_vertex_handle(heh);
            const VertexHandle opposite =
                grid.mesh().to_vertex_handle(grid.mesh().next_halfedge_handle(heh));
            return grid.mesh().is_boundary(vh) && grid.faces_at(vh) == 1 &&
                   grid.faces_at(opposite) >= 5 && insert_column(grid.state(), heh, 2, change);
          },
          [](Grid& grid, HalfedgeHandle heh, int, Replacement& change) {
            return insert_pillow(grid.state(), grid.mesh().face_handle(heh), change);
          }};
}

/// Change a grid at random, the same for the same seed.
void make_irregular(Grid& grid, unsigned seed) {
  std::mt19937 random(seed);
  const std::vector<Move> moves = bounded_moves();
  Replacement change;
  for (int made = 0; made < 6;) {
    const auto halfedges = grid.halfedges();
    const HalfedgeHandle heh = halfedges[random() % halfedges.size()];
    if (!moves[random() % moves.size()](grid, heh, kAny, change)) continue;
    grid.apply(change);
    ++made;
  }
}

class EveryQuadMove : public ::testing::TestWithParam<unsigned> {};

TEST_P(EveryQuadMove, LeavesAProperMesh) {
  std::vector<Move> moves = bounded_moves();
  for (const Move& move : free_moves()) moves.push_back(move);
  for (const Move& move : moves) {
    Grid first(4, 3);
    make_irregular(first, GetParam());
    const std::size_t count = first.halfedges().size();
    for (std::size_t i = 0; i < count; ++i) {
      Grid grid(4, 3);
      make_irregular(grid, GetParam());
      Replacement change;
      if (!move(grid, grid.halfedges()[i], kAny, change)) continue;
      grid.apply(change);
      grid.expect_proper();
    }
  }
}

TEST_P(EveryQuadMove, IsMadeExactlyUpToItsGrowthOfTheSumOfSquares) {
  std::size_t made = 0;
  for (const Move& move : bounded_moves()) {
    Grid first(4, 3);
    make_irregular(first, GetParam());
    const std::size_t count = first.halfedges().size();
    for (std::size_t i = 0; i < count; ++i) {
      Grid grid(4, 3);
      make_irregular(grid, GetParam());
      const HalfedgeHandle heh = grid.halfedges()[i];
      Replacement change;
      if (!move(grid, heh, kAny, change)) continue;
      grid.discard(change);
      const int before = grid.squares();
      Grid changed(4, 3);
      make_irregular(changed, GetParam());
      ASSERT_TRUE(move(changed, heh, kAny, change));
      changed.apply(change);
      const int growth = changed.squares() - before;
      EXPECT_FALSE(move(grid, heh, growth - 1, change));
      EXPECT_TRUE(move(grid, heh, growth, change));
      ++made;
    }
  }
  EXPECT_GT(made, 30u);
}

TEST_P(EveryQuadMove, TellsTheCountsOfFacesThatAStateHas) {
  Grid grid(4, 3);
  make_irregular(grid, GetParam());
  for (const VertexHandle vh : grid.vertices()) {
    EXPECT_EQ(grid.state().count(vh), grid.faces_at(vh));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, EveryQuadMove, ::testing::Values(1u, 2u, 3u, 4u));

}  // namespace
}  // namespace surfmesh
