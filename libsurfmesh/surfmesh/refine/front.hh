// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "surfmesh/refine/face_states.hh"
#include "surfmesh/refine/front_queue.hh"
#include "surfmesh/refine/placement.hh"
#include "surfmesh/refine/refine.hh"

namespace surfmesh {

/// The triangles that are to be split, in their order: with frontal placement those that touch the
/// boundary or an accepted triangle, else all that are not accepted.
class Front {
 public:
  Front(const DelaunayMesh& delaunay, FaceStates& states, Placement placement)
      : delaunay_(delaunay), states_(states), is_frontal_(placement == Placement::Frontal) {
    for (std::size_t f = 0; f < delaunay_.n_faces(); ++f) {
      activate(FaceHandle(static_cast<int>(f)));
    }
  }

  /// Take the next entry, which may be out of date; false if there is none.
  bool pop(FrontQueue::Entry& entry) { return queue_.pop(entry); }

  /// True if the triangle is still as it was when it was put in.
  bool is_current(const FrontQueue::Entry& entry) const {
    const FaceStates::State& state = states_[entry.face];
    return state.stamp == entry.stamp && !state.is_accepted;
  }

  /// The shortest side at the front (frontal; invalid if there is none), or the longest
  /// (circumcentre).
  HalfedgeHandle base_of(FaceHandle fh) const {
    const PolyMesh& mesh = delaunay_.mesh();
    HalfedgeHandle best;
    double best_rank = kUnset;  // measured when there is a second side
    HalfedgeHandle heh = mesh.halfedge_handle(fh);
    for (int k = 0; k < 3; ++k, heh = mesh.next_halfedge_handle(heh)) {
      if (is_frontal_ && !is_front(heh)) continue;
      if (!best.is_valid()) {
        best = heh;
        continue;
      }
      if (std::isnan(best_rank)) best_rank = rank(best);
      const double other = rank(heh);
      if (other < best_rank) {
        best_rank = other;
        best = heh;
      }
    }
    return best;
  }

  /// Leave a triangle as it is.
  void accept(FaceHandle fh) {
    states_[fh].is_accepted = true;
    HalfedgeHandle heh = delaunay_.mesh().halfedge_handle(fh);
    for (int k = 0; k < 3; ++k, heh = delaunay_.mesh().next_halfedge_handle(heh)) {
      activate_neighbour(heh);
    }
  }

  /// Take in the triangles around a new vertex, which have been measured.
  void add(const Fan& fan) {
    for (const FanSide& side : fan) {
      const FaceHandle fh = delaunay_.mesh().face_handle(side.halfedge);
      activate(fh);
      // A neighbour of an accepted triangle is at the front now.
      if (states_[fh].is_accepted) activate_neighbour(side.halfedge);
    }
  }

 private:
  /// The lower, the sooner a side is the base.
  double rank(HalfedgeHandle heh) const {
    const MetricCorner a = corner(delaunay_, delaunay_.mesh().from_vertex_handle(heh));
    const MetricCorner b = corner(delaunay_, delaunay_.mesh().to_vertex_handle(heh));
    const double length = fast_edge_length(a.uv, a.metric, b.uv, b.metric);
    return is_frontal_ ? length : -length;
  }

  bool is_front(HalfedgeHandle heh) const {
    const FaceHandle neighbour =
        delaunay_.mesh().face_handle(delaunay_.mesh().opposite_halfedge_handle(heh));
    return !neighbour.is_valid() || states_[neighbour].is_accepted;
  }

  /// Put a triangle into the queue if it is to be split and, with frontal placement, is at the
  /// front.
  void activate(FaceHandle fh) {
    FaceStates::State& state = states_[fh];
    if (state.is_accepted || state.is_active) return;
    const HalfedgeHandle a = delaunay_.mesh().halfedge_handle(fh);
    const HalfedgeHandle b = delaunay_.mesh().next_halfedge_handle(a);
    const HalfedgeHandle c = delaunay_.mesh().next_halfedge_handle(b);
    if (is_frontal_ && !is_front(a) && !is_front(b) && !is_front(c)) return;
    state.is_active = true;
    queue_.push({fh, state.stamp}, static_cast<double>(state.squared_radius));
  }

  void activate_neighbour(HalfedgeHandle heh) {
    const FaceHandle neighbour =
        delaunay_.mesh().face_handle(delaunay_.mesh().opposite_halfedge_handle(heh));
    if (neighbour.is_valid()) activate(neighbour);
  }

  const DelaunayMesh& delaunay_;
  FaceStates& states_;
  bool is_frontal_;
  FrontQueue queue_;
};

}  // namespace surfmesh
