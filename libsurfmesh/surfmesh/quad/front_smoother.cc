// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/front_smoother.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Vertices of triangles that are nearer to the corner of a quad are merged into it.
constexpr double kNearest = 0.55;

/// Rounds in which an inverted quad is opened.
constexpr int kUntanglingRounds = 30;

}  // namespace

/// Move a vertex to the mean of the places at unit distance from its neighbours.
void FrontSmoother::spring(VertexHandle vh) {
  const Uv at = front_.uv(vh);
  Uv sum{0, 0};
  int count = 0;
  for (const VertexHandle other : front_.mesh().vv_range(vh)) {
    const Uv step = at - front_.uv(other);
    const double length = std::sqrt(squared_length(front_.metric(vh), step));
    sum = sum + front_.uv(other) + 1 / length * step;
    ++count;
  }
  front_.move_towards(vh, 1.0 / count * sum);
}

void FrontSmoother::smooth_before(VertexHandle corner) {
  before_.clear();
  for (const VertexHandle vh : front_.mesh().vv_range(corner)) {
    if (front_.is_untouched(vh)) before_.push_back(vh);
  }
  for (const VertexHandle vh : before_) {
    const Uv step = front_.uv(vh) - front_.uv(corner);
    const double squared = squared_length(front_.metric(corner), step);
    if (squared < kNearest * kNearest && front_.absorb(vh, corner)) continue;
    spring(vh);
  }
  front_.swap_around(corner);
}

void FrontSmoother::smooth_around(FaceHandle quad) {
  QuadCycle corners;
  std::size_t k = 0;
  for (const VertexHandle vh : front_.mesh().fv_range(quad)) corners[k++] = vh;
  for (const VertexHandle vh : corners) {
    if (front_.is_free(vh)) quads_.smooth(vh, {});
  }
  for (const VertexHandle vh : corners) smooth_before(vh);
}

/// The vertices that may move of some and those beside them.
std::vector<VertexHandle> FrontSmoother::free_vertices_near(
    std::span<const VertexHandle> vertices) const {
  std::vector<VertexHandle> near;
  const auto add = [&](VertexHandle vh) {
    if (front_.is_free(vh) && std::find(near.begin(), near.end(), vh) == near.end()) {
      near.push_back(vh);
    }
  };
  for (const VertexHandle vh : vertices) add(vh);
  for (const VertexHandle vertex : vertices) {
    for (const VertexHandle vh : front_.mesh().vv_range(vertex)) add(vh);
  }
  for (std::size_t i = 0, end = near.size(); i < end; ++i) {
    const VertexHandle vertex = near[i];
    for (const VertexHandle vh : front_.mesh().vv_range(vertex)) add(vh);
  }
  return near;
}

bool FrontSmoother::untangle(std::span<const VertexHandle> vertices) {
  const std::vector<VertexHandle> near = free_vertices_near(vertices);
  const auto is_valid = [&](VertexHandle vh) { return front_.count_invalid(vh) == 0; };
  front_.begin_trial();
  for (int round = 0; round < kUntanglingRounds; ++round) {
    for (const VertexHandle vh : near) quads_.smooth(vh, {.size = 0.2});
  }
  if (std::all_of(vertices.begin(), vertices.end(), is_valid)) {
    front_.keep_trial();
    return true;
  }
  front_.undo_trial();
  return false;
}

}  // namespace surfmesh
