// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/quad_trial.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "quad/grid_patch.hh"
#include "surfmesh/quad/quad_moves.hh"

namespace surfmesh {
namespace {

using testing::GridPatch;
using testing::kAny;
using testing::wanted_of;

/// Everything that is known of a mesh in use: links, places, metrics, counts and measures.
std::vector<double> everything(const GridPatch& patch, const QuadState& state) {
  std::vector<double> all;
  for (std::size_t f = 0; f < patch.editor.face_bound(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    all.push_back(patch.mesh.halfedge_handle(fh).idx());
    if (!patch.editor.is_used(fh)) continue;
    all.push_back(state.measures[f].energy);
    all.push_back(state.measures[f].least_jacobian);
    for (const HalfedgeHandle heh : patch.mesh.fh_range(fh)) {
      all.push_back(heh.idx());
      all.push_back(patch.mesh.to_vertex_handle(heh).idx());
      all.push_back(patch.mesh.prev_halfedge_handle(heh).idx());
    }
  }
  for (std::size_t v = 0; v < patch.editor.vertex_bound(); ++v) {
    const VertexHandle vh(static_cast<int>(v));
    if (!patch.editor.is_used(vh)) continue;
    const Uv uv = patch.uv(vh);
    const Metric& m = patch.metric(vh);
    all.insert(all.end(), {uv.u, uv.v, m.m11, m.m12, m.m22, 1.0 * state.count(vh),
                           1.0 * patch.mesh.halfedge_handle(vh).idx()});
  }
  return all;
}

class QuadTrials : public ::testing::Test {
 protected:
  VertexHandle at(int i, int j) const { return patch_.vertex(i, j); }

  GridPatch patch_{4, 4, testing::isotropic_field([](Uv p) { return 1 + 0.02 * p.u; })};
  QuadState state_{patch_.mesh, patch_.editor, patch_.geometry, wanted_of(patch_)};
  QuadTrial trial_{state_};
  Replacement change_;
};

TEST_F(QuadTrials, LeaveEverythingAsItWasWhereAChangeIsWorse) {
  const auto before = everything(patch_, state_);
  for (const HalfedgeHandle heh : patch_.mesh.fh_range(patch_.face(1, 1))) {
    ASSERT_TRUE(rotate_edge(state_, heh, Turn::Clockwise, kAny, change_));
    EXPECT_FALSE(trial_.attempt(change_));
    EXPECT_EQ(everything(patch_, state_), before);
    ASSERT_TRUE(open_vertex(state_, heh, 2, kAny, change_));
    EXPECT_FALSE(trial_.attempt(change_));
    EXPECT_EQ(everything(patch_, state_), before);
    if (!collapse_quad(state_, heh, kAny, change_)) continue;
    EXPECT_FALSE(trial_.attempt(change_));
    EXPECT_EQ(everything(patch_, state_), before);
  }
}

TEST_F(QuadTrials, GiveNumbersOfVerticesBackThatTheyDoNotUse) {
  const HalfedgeHandle heh = patch_.halfedge(at(2, 2), at(3, 2));
  const std::size_t bound = patch_.editor.vertex_bound();
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(open_vertex(state_, heh, 2, kAny, change_));
    ASSERT_FALSE(trial_.attempt(change_));
    ASSERT_TRUE(insert_pillow(state_, patch_.face(1, 1), change_));
    trial_.discard(change_);
  }
  EXPECT_LE(patch_.editor.vertex_bound(), bound + 4);
}

/// A lattice one of whose edges is turned: turning it back is better.
class TurnedEdge : public ::testing::Test {
 protected:
  TurnedEdge() {
    QuadState before(patch_.mesh, patch_.editor, patch_.geometry, wanted_of(patch_));
    EXPECT_TRUE(rotate_edge(before, patch_.halfedge(patch_.vertex(2, 1), patch_.vertex(2, 2)),
                            Turn::CounterClockwise, kAny, change_));
    std::vector<FaceHandle> made;
    patch_.editor.replace(change_.old, change_.fresh, made);
    state_.emplace(patch_.mesh, patch_.editor, patch_.geometry, wanted_of(patch_));
  }

  /// Prepare the turn back.
  bool prepare() {
    return rotate_edge(*state_, patch_.halfedge(patch_.vertex(1, 2), patch_.vertex(3, 1)),
                       Turn::Clockwise, 0, change_);
  }

  GridPatch patch_{4, 4};
  std::optional<QuadState> state_;
  Replacement change_;
};

TEST_F(TurnedEdge, IsTurnedBack) {
  QuadTrial trial(*state_);
  ASSERT_TRUE(prepare());
  EXPECT_TRUE(trial.attempt(change_));
  EXPECT_TRUE(patch_.halfedge(patch_.vertex(2, 1), patch_.vertex(2, 2)).is_valid());
}

TEST_F(TurnedEdge, HasItsCountsAndMeasuresRenewed) {
  QuadTrial trial(*state_);
  ASSERT_TRUE(prepare());
  ASSERT_TRUE(trial.attempt(change_));
  const QuadState fresh(patch_.mesh, patch_.editor, patch_.geometry, wanted_of(patch_));
  for (std::size_t v = 0; v < patch_.editor.vertex_bound(); ++v) {
    EXPECT_EQ(state_->counts[v], fresh.counts[v]) << "vertex " << v;
  }
  for (std::size_t f = 0; f < patch_.editor.face_bound(); ++f) {
    if (!patch_.editor.is_used(FaceHandle(static_cast<int>(f)))) continue;
    EXPECT_EQ(state_->measures[f].energy, fresh.measures[f].energy) << "face " << f;
    EXPECT_EQ(state_->measures[f].least_jacobian, fresh.measures[f].least_jacobian);
  }
}

TEST_F(TurnedEdge, TouchesTheVerticesAroundItOnce) {
  QuadTrial trial(*state_);
  ASSERT_TRUE(prepare());
  ASSERT_TRUE(trial.attempt(change_));
  std::vector<VertexHandle> touched = trial.touched();
  for (const VertexHandle vh : {patch_.vertex(2, 1), patch_.vertex(2, 2), patch_.vertex(1, 2)}) {
    EXPECT_EQ(std::count(touched.begin(), touched.end(), vh), 1);
  }
  EXPECT_EQ(std::count(touched.begin(), touched.end(), patch_.vertex(0, 4)), 0);
}

TEST(QuadTrial, FreesTheVertexOfACollapseThatIsKept) {
  GridPatch patch(5, 5);
  QuadState before(patch.mesh, patch.editor, patch.geometry, wanted_of(patch));
  Replacement change;
  ASSERT_TRUE(
      open_vertex(before, patch.halfedge(patch.vertex(2, 2), patch.vertex(3, 2)), 2, kAny, change));
  for (const auto& middle : change.middles) {
    patch.geometry.put_between(middle.vertex, middle.others);
  }
  const VertexHandle added = change.added[0];
  std::vector<FaceHandle> made;
  patch.editor.replace(change.old, change.fresh, made);
  QuadState state(patch.mesh, patch.editor, patch.geometry, wanted_of(patch));
  QuadTrial trial(state);
  // The quad in between closes by merging the two again.
  bool is_kept = false;
  for (const VertexHandle vh : {patch.vertex(2, 2), added}) {
    const HalfedgeHandle heh = patch.halfedge(patch.vertex(3, 2), vh);
    const HalfedgeHandle other = patch.halfedge(patch.vertex(1, 2), vh);
    for (const HalfedgeHandle side : {heh, other}) {
      if (!is_kept && patch.mesh.face_handle(side) == made.back() &&
          collapse_quad(state, side, kAny, change)) {
        is_kept = trial.attempt(change);
      }
    }
  }
  ASSERT_TRUE(is_kept);
  EXPECT_FALSE(patch.editor.is_used(change.removed[0]));
  EXPECT_EQ(patch.editor.add_vertex(), change.removed[0]);
}

}  // namespace
}  // namespace surfmesh
