// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "surfmesh/quad/front_quads.hh"

namespace surfmesh {
namespace {

/// A vertex serves as the end of a side edge if it is no farther from where that should be.
constexpr double kFarthestTip = 0.6;

/// A swapped edge must be nearer by this than one that is there.
constexpr double kSwapHandicap = 0.1;

/// Shares of an edge between which a new vertex is put on it, and its least length from the end of
/// the side edge.
constexpr double kLeastShare = 0.2, kMostShare = 0.8, kShortestSide = 0.4;

double length(Uv x) { return std::sqrt(x.u * x.u + x.v * x.v); }

/// Where the side edge of a unit square ends.
Uv place_of_tip(const FrontMesh& mesh, const FrontEdge& edge, const FrontEnd& end, double turn) {
  const VertexHandle other = end.vertex == edge.from.vertex ? edge.to.vertex : edge.from.vertex;
  const Uv along = edge.frame.in_frame(mesh.uv(other) - mesh.uv(end.vertex));
  const double scale = 1 / length(along);
  const double c = std::cos(turn), s = std::sin(turn);
  const Direction direction{scale * (c * along.u - s * along.v),
                            scale * (s * along.u + c * along.v)};
  return mesh.uv(end.vertex) + edge.frame.step(direction);
}

}  // namespace

/// The sides opposite to an end of all triangles at the front there, from the base on.
void FrontQuads::collect_fan(const FrontEdge& edge, End end) {
  const PolyMesh& mesh = mesh_.mesh();
  fan_.clear();
  HalfedgeHandle heh = edge.base;
  while (true) {
    const HalfedgeHandle spoke =
        end == End::From ? mesh.prev_halfedge_handle(heh) : mesh.next_halfedge_handle(heh);
    fan_.push_back(end == End::From ? mesh.next_halfedge_handle(heh)
                                    : mesh.prev_halfedge_handle(heh));
    if (mesh_.is_front(spoke)) return;
    heh = mesh.opposite_halfedge_handle(spoke);
  }
}

/// The vertices that an end is joined to, or can be by a swap, the nearest to a place first.
void FrontQuads::collect_tips(const FrontEdge& edge, End end, Uv place, EdgeHandle kept) {
  const PolyMesh& mesh = mesh_.mesh();
  tips_.clear();
  const auto distance = [&](VertexHandle vh) {
    return length(edge.frame.in_frame(mesh_.uv(vh) - place));
  };
  for (std::size_t i = 0; i < fan_.size(); ++i) {
    if (i + 1 < fan_.size()) {
      const VertexHandle tip =
          end == End::From ? mesh.to_vertex_handle(fan_[i]) : mesh.from_vertex_handle(fan_[i]);
      tips_.push_back({tip, distance(tip), EdgeHandle()});
    }
    const EdgeHandle eh = mesh.edge_handle(fan_[i]);
    if (eh == kept || !mesh_.can_flip(eh)) continue;
    const VertexHandle apex = apex_beyond(fan_[i]);
    tips_.push_back({apex, distance(apex) + kSwapHandicap, eh});
  }
  std::stable_sort(tips_.begin(), tips_.end(),
                   [](const SideTip& a, const SideTip& b) { return a.distance < b.distance; });
}

/// Put a new vertex on the side of the fan that is crossed on the way to a place.
VertexHandle FrontQuads::split_towards(const FrontEdge& edge, const FrontEnd& end, Uv place,
                                       EdgeHandle kept) {
  const PolyMesh& mesh = mesh_.mesh();
  const Uv at = mesh_.uv(end.vertex), way = place - at;
  for (const HalfedgeHandle heh : fan_) {
    const Uv a = mesh_.uv(mesh.from_vertex_handle(heh)) - at;
    const Uv b = mesh_.uv(mesh.to_vertex_handle(heh)) - at;
    const double left = cross(a, way), right = cross(way, b);
    if (!(left >= 0 && right >= 0 && left + right > 0)) continue;
    if (mesh.edge_handle(heh) == kept || !apex_beyond(heh).is_valid()) return VertexHandle();
    const double share = std::clamp(left / (left + right), kLeastShare, kMostShare);
    const Uv step = edge.frame.in_frame(lerp(a, b, share));
    return length(step) < kShortestSide ? VertexHandle() : mesh_.split(heh, share);
  }
  return VertexHandle();
}

/// The end of the side edge at one end of the base. `taken` is the other one, and `kept` its edge.
VertexHandle FrontQuads::side_tip(const FrontEdge& edge, End end_of_base, VertexHandle taken,
                                  EdgeHandle kept) {
  const FrontEnd& end = end_of_base == End::From ? edge.from : edge.to;
  if (end.has_side()) return end.beyond;
  const double turn = end.angle / end.quads;
  const Uv place = place_of_tip(mesh_, edge, end, end_of_base == End::From ? turn : -turn);
  collect_fan(edge, end_of_base);
  collect_tips(edge, end_of_base, place, kept);
  VertexHandle tip;
  for (const SideTip& candidate : tips_) {
    if (candidate.distance > kFarthestTip) break;
    if (candidate.vertex == taken || candidate.vertex == edge.from.vertex ||
        candidate.vertex == edge.to.vertex) {
      continue;
    }
    if (candidate.swapped.is_valid()) mesh_.flip(candidate.swapped);
    tip = candidate.vertex;
    break;
  }
  if (!tip.is_valid()) tip = split_towards(edge, end, place, kept);
  if (tip.is_valid() && mesh_.is_untouched(tip)) mesh_.move_towards(tip, place);
  return tip;
}

FaceHandle FrontQuads::advance(const FrontEdge& edge, double least_jacobian) {
  const VertexHandle a = edge.from.vertex, b = edge.to.vertex;
  // An end that has a side comes first: its tip is not free to be another one.
  const bool is_to_first = edge.to.has_side() && !edge.from.has_side();
  VertexHandle c, d;
  if (is_to_first) {
    c = side_tip(edge, End::To, VertexHandle(), EdgeHandle());
  } else {
    d = side_tip(edge, End::From, VertexHandle(), EdgeHandle());
  }
  const VertexHandle first = is_to_first ? c : d;
  if (!first.is_valid()) return FaceHandle();
  const HalfedgeHandle kept = mesh_.find_halfedge(is_to_first ? b : a, first);
  const VertexHandle second =
      side_tip(edge, is_to_first ? End::From : End::To, first, mesh_.mesh().edge_handle(kept));
  if (!second.is_valid() || second == first) return FaceHandle();
  (is_to_first ? d : c) = second;
  const QuadCycle cycle = {a, b, c, d};
  if (!(mesh_.least_jacobian(cycle) >= least_jacobian)) return FaceHandle();
  if (!mesh_.connect(c, d)) return FaceHandle();
  return make(edge.base, cycle, least_jacobian);
}

}  // namespace surfmesh
