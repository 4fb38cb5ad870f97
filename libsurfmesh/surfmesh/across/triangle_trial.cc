// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/triangle_trial.hh"

#include <algorithm>
#include <array>
#include <cmath>

#include "surfmesh/across/triangle_measures.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// Gains for which a change is kept.
constexpr double kBadnessGain = 0.05, kEnergyGain = 0.02;

/// Rounds of smoothing in a trial.
constexpr int kRounds = 2;

/// Triangles below this quality are bad; their weight, and that of inverted ones.
constexpr double kBadTriangle = 0.75;
constexpr double kWeightOfBad = 4, kWeightOfInverted = 1000;

/// An edge just outside of the unit range counts so much, one at the square of a limit by 1 more.
constexpr double kWeightOfEdge = 0.5;

/// How much the lack of quality of a triangle counts beside the squared logarithms of lengths.
constexpr double kWeightOfShape = 2;

}  // namespace

void TriangleTrial::Sum::add_length(double length) {
  static const double limit = std::log(kLongestUnit);
  const double off = std::abs(std::log(length));
  if (off > limit) badness += kWeightOfEdge + off / limit - 1;
  energy += off * off;
}

void TriangleTrial::Sum::add_quality(double quality) {
  energy += kWeightOfShape * (1 - quality);
  if (quality >= kBadTriangle) return;
  const double lack = 1 - quality / kBadTriangle;
  badness += kWeightOfBad * lack * lack + (quality <= 0 ? kWeightOfInverted : 0);
}

/// The triangles around vertices, and their sides.
TriangleTrial::Sum TriangleTrial::measure(std::span<const VertexHandle> around) {
  const PolyMesh& mesh = state_.mesh;
  faces_.clear();
  for (const VertexHandle vh : around) {
    for (const FaceHandle fh : mesh.vf_range(vh)) faces_.push_back(fh);
  }
  std::sort(faces_.begin(), faces_.end());
  faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
  Sum sum;
  edges_.clear();
  for (const FaceHandle fh : faces_) {
    const HalfedgeHandle heh = mesh.halfedge_handle(fh);
    const VertexHandle a = mesh.from_vertex_handle(heh), b = mesh.to_vertex_handle(heh),
                       c = mesh.to_vertex_handle(mesh.next_halfedge_handle(heh));
    sum.add_quality(triangle_quality(state_.chart(a), state_.chart(b), state_.chart(c)));
    for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, a}}) {
      edges_.push_back(std::minmax(from.idx(), to.idx()));
    }
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  for (const auto& [a, b] : edges_) {
    sum.add_length(metric_length(state_.chart(VertexHandle(a)), state_.chart(VertexHandle(b))));
  }
  return sum;
}

/// Replace the old triangles by the fresh ones. `moving` are the vertices that are smoothed then;
/// `around` those of the old triangles, around which all is measured.
bool TriangleTrial::attempt(std::span<const VertexHandle> moving,
                            std::span<const VertexHandle> around) {
  const Sum before = measure(around);
  before_.clear();
  for (const VertexHandle vh : moving) before_.emplace_back(vh, state_.chart(vh));
  state_.editor.replace(old_, fresh_, made_);
  for (int round = 0; round < kRounds; ++round) {
    for (const VertexHandle vh : moving) moves_.smooth(vh);
  }
  const Sum after = measure(moving);
  if (after.badness < before.badness - kBadnessGain ||
      (after.badness <= before.badness && after.energy < before.energy - kEnergyGain)) {
    return true;
  }
  state_.editor.undo_replacement();
  for (const auto& [vh, chart] : before_) state_.set_chart(vh, chart);
  return false;
}

bool TriangleTrial::swap(EdgeHandle eh) {
  if (!state_.is_inner(eh)) return false;
  const EdgeSurroundings e = state_.around(eh);
  if (!state_.can_lose_triangle(e.origin) || !state_.can_lose_triangle(e.tip) ||
      !state_.may_join(e.left, e.right) ||
      triangle_quality(state_.chart(e.right), state_.chart(e.tip), state_.chart(e.left)) <= 0 ||
      triangle_quality(state_.chart(e.left), state_.chart(e.origin), state_.chart(e.right)) <= 0) {
    return false;
  }
  old_ = {state_.mesh.face_handle(e.halfedge), state_.mesh.face_handle(e.opposite)};
  fresh_.clear();
  fresh_.add({e.right, e.tip, e.left});
  fresh_.add({e.left, e.origin, e.right});
  const std::array corners = {e.right, e.tip, e.left, e.origin};
  return attempt(corners, corners);
}

bool TriangleTrial::collapse(HalfedgeHandle heh) {
  const PolyMesh& mesh = state_.mesh;
  const VertexHandle gone = mesh.from_vertex_handle(heh), tip = mesh.to_vertex_handle(heh);
  if (!star_.collect(mesh, gone) || star_.ring().size() <= 3) return false;
  const HalfedgeHandle back = mesh.opposite_halfedge_handle(heh);
  const VertexHandle left = mesh.to_vertex_handle(mesh.next_halfedge_handle(heh));
  const VertexHandle right = mesh.to_vertex_handle(mesh.next_halfedge_handle(back));
  if (!state_.can_lose_triangle(left) || !state_.can_lose_triangle(right)) return false;
  old_.clear();
  for (const FaceHandle fh : mesh.vf_range(gone)) old_.push_back(fh);
  fresh_.clear();
  VertexHandle previous = star_.ring().back();
  for (const VertexHandle next : star_.ring()) {
    if (next != tip && next != left && next != right && !state_.may_join(next, tip)) return false;
    if (previous != tip && next != tip) {
      if (triangle_quality(state_.chart(tip), state_.chart(previous), state_.chart(next)) <= 0) {
        return false;
      }
      fresh_.add({tip, previous, next});
    }
    previous = next;
  }
  moving_ = star_.ring();
  around_ = moving_;
  around_.push_back(gone);
  if (!attempt(moving_, around_)) return false;
  state_.editor.free_vertex(gone);
  return true;
}

bool TriangleTrial::split(EdgeHandle eh) {
  const EdgeSurroundings e = state_.around(eh);
  const VertexChart& origin = state_.chart(e.origin);
  const Vec3 half = origin.in_chart(0.5 * (state_.chart(e.tip).point - origin.point));
  const auto middle = state_.maker.move(origin, {half.x(), half.y()});
  if (!middle) return false;
  around_ = {e.right, e.tip, e.left, e.origin};
  VertexHandle from = e.origin;
  for (const VertexHandle to : around_) {
    if (triangle_quality(*middle, state_.chart(from), state_.chart(to)) <= 0) return false;
    from = to;
  }
  const VertexHandle vh = state_.editor.add_vertex();
  state_.set_chart(vh, *middle);
  old_ = {state_.mesh.face_handle(e.halfedge), state_.mesh.face_handle(e.opposite)};
  fresh_.clear();
  from = e.origin;
  for (const VertexHandle to : around_) {
    fresh_.add({vh, from, to});
    from = to;
  }
  moving_ = around_;
  moving_.push_back(vh);
  if (attempt(moving_, around_)) return true;
  state_.editor.free_vertex(vh);
  return false;
}

}  // namespace surfmesh
