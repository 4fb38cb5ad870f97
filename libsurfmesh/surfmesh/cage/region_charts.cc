// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/region_charts.hh"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "surfmesh/cage/face_angles.hh"
#include "surfmesh/cage/face_loops.hh"
#include "surfmesh/geometry/crossing_segments.hh"

namespace surfmesh {
namespace {

/// Rings of faces around a region that its chart covers, too.
constexpr int kMarginRings = 4;

/// Points of a side of a face that stand for it: sides are curves.
constexpr int kSideSamples = 4;

}  // namespace

std::optional<FaceRegion> RegionChartMaker::make(const std::vector<int>& faces, const Vec3& axis) {
  FaceRegion region{faces, true, frame_of(faces, axis)};
  const bool all_fit = std::all_of(faces.begin(), faces.end(), [&](int face) {
    return turn_from(shape(face), axis) <= kMostTurnOfMargin / detail::kDegrees;
  });
  if (!all_fit) return std::nullopt;
  ++mark_;
  for (const int face : region.faces) mark(face) = mark_;
  if (!lies_side_by_side(region.faces, region.frame)) return std::nullopt;
  for (int rings = kMarginRings; rings > 0; rings /= 2) {
    region.margin = margin_of(region, rings);
    std::vector<int> all = region.faces;
    all.insert(all.end(), region.margin.begin(), region.margin.end());
    std::sort(all.begin(), all.end());
    if (lies_side_by_side(all, region.frame)) return region;
    for (const int face : region.margin) mark(face) = 0;
  }
  region.margin.clear();
  return region;
}

std::vector<std::vector<int>> RegionChartMaker::halves(const std::vector<int>& faces) {
  const int end = last_reached(faces, {faces.front()});
  const int other_end = last_reached(faces, {end});
  last_reached(faces, {end, other_end});
  std::vector<std::vector<int>> result(2);
  for (const int face : faces) result[mark(face) == mark_ ? 0 : 1].push_back(face);
  return result;
}

ChartFrame RegionChartMaker::frame_of(const std::vector<int>& faces, const Vec3& axis) const {
  Vec3 centre = Vec3::Zero();
  for (const int face : faces) centre += shape(face).centre;
  return ChartFrame::at(centre / static_cast<double>(faces.size()), axis);
}

/// Mark the faces with the number of the start that they are nearest to, counted down from
/// `mark_`.
/// Returns  the last face that is reached
int RegionChartMaker::last_reached(const std::vector<int>& faces, const std::vector<int>& starts) {
  const int is_free = ++mark_;
  for (const int face : faces) mark(face) = is_free;
  mark_ += static_cast<int>(starts.size());
  std::vector<int> queue = starts;
  for (std::size_t i = 0; i < starts.size(); ++i) mark(starts[i]) = mark_ - static_cast<int>(i);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (int side = 0; side < neighbours_.corner_count(); ++side) {
      const int next = neighbours_.across({queue[i], side}).face;
      if (next < 0 || mark(next) != is_free) continue;
      mark(next) = mark(queue[i]);
      queue.push_back(next);
    }
  }
  return queue.back();
}

/// Rings of neighbours around a region that lie over its plane. They are marked.
std::vector<int> RegionChartMaker::margin_of(const FaceRegion& region, int rings) {
  std::vector<int> margin;
  std::vector<int> last = region.faces;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<int> next;
    for (const int face : last) {
      for (int side = 0; side < neighbours_.corner_count(); ++side) {
        const int other = neighbours_.across({face, side}).face;
        if (other < 0 || mark(other) == mark_ || !may_be_in_margin(other, region.frame.normal)) {
          continue;
        }
        mark(other) = mark_;
        next.push_back(other);
      }
    }
    margin.insert(margin.end(), next.begin(), next.end());
    last = std::move(next);
  }
  return margin;
}

/// Not beyond a crease: there a point of the plane would have two tangent planes.
bool RegionChartMaker::may_be_in_margin(int face, const Vec3& axis) const {
  if (turn_from(shape(face), axis) > kMostTurnOfMargin / detail::kDegrees) return false;
  for (int side = 0; side < neighbours_.corner_count(); ++side) {
    if (neighbours_.across({face, side}).face >= 0) continue;
    for (const int other : neighbours_.level().GetEdgeFaces(neighbours_.edge({face, side}))) {
      if (other != face && marks_[static_cast<std::size_t>(other)] == mark_) return false;
    }
  }
  return true;
}

/// True if marked faces, seen along the normal, cover no part of each other, and their borders do
/// not touch. As all turn counter-clockwise, it is enough that borders do not cross.
bool RegionChartMaker::lies_side_by_side(const std::vector<int>& faces,
                                         const ChartFrame& frame) const {
  std::vector<detail::NodeLoop> loops;
  std::vector<int> vertices;
  for (const FaceLoop& loop : face_loops(neighbours_, faces, marks_, mark_)) {
    detail::NodeLoop& nodes = loops.emplace_back();
    for (const FaceNeighbours::Side side : loop) {
      const Surface& surface = *surfaces_[static_cast<std::size_t>(side.face)];
      const Domain domain = surface.domain();
      const Uv from = domain.corner(side.side);
      const Uv to = domain.corner((side.side + 1) % domain.corner_count());
      vertices.push_back(neighbours_.vertex(side));
      for (int i = 0; i < kSideSamples; ++i) {
        const Uv at = lerp(from, to, double(i) / kSideSamples);
        nodes.push_back(frame.project(surface.evaluate(at, Order::Position).point));
      }
    }
  }
  std::sort(vertices.begin(), vertices.end());
  const bool is_touching = std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
  return !is_touching && detail::crossing_segments(loops).empty();
}

}  // namespace surfmesh
