// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "surfmesh/delaunay/metric_swaps.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/refine/fan.hh"
#include "surfmesh/refine/placement.hh"

namespace surfmesh {

/// How large the triangles of a mesh are in its metric, and what has become of them.
class FaceStates {
 public:
  struct State {
    float squared_radius = 0;
    float metric_area = 0;
    std::uint32_t stamp = 0;  ///< another one whenever the triangle is
    bool is_accepted = false;
    bool is_active = false;  ///< in the queue
  };

  /// Measure all triangles; they are accepted up to a squared metric circumradius.
  FaceStates(DelaunayMesh& delaunay, double accepted_size)
      : delaunay_(delaunay), accepted_size_(accepted_size), states_(delaunay.n_faces()) {
    for (std::size_t f = 0; f < delaunay_.n_faces(); ++f) {
      measure(FaceHandle(static_cast<int>(f)));
    }
  }

  State& operator[](FaceHandle fh) { return states_[index(fh)]; }
  const State& operator[](FaceHandle fh) const { return states_[index(fh)]; }

  /// Number of unit triangles that the metric area of the mesh asks for.
  double predicted_count() const { return metric_area_ / kUnitTriangleArea; }

  /// Make room for a node. Faces come two at a time; mesh and states grow in bulk, towards the
  /// count that is predicted by now: at first from the boundary alone, which may be far off.
  void grow() {
    if (delaunay_.n_faces() + 2 <= states_.size()) return;
    constexpr double reserve = 1.1, least = 1.5, most = 4;
    const auto count = static_cast<double>(delaunay_.n_faces());
    const double wanted = std::clamp(reserve * predicted_count(), least * count, most * count);
    const auto added = static_cast<std::size_t>(wanted - count) / 2 + kLeastGrowth;
    delaunay_.reserve(added);
    states_.resize(delaunay_.n_faces() + 2 * added);
  }

  /// Measure the triangles of the fan around a vertex.
  void measure_fan(VertexHandle centre, const Fan& fan) {
    const MetricCorner middle = corner(delaunay_, centre);
    const double middle_density = density(middle.metric);
    const double first_density = density(origin(fan.front()).metric);
    double near_density = first_density;
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const FanSide& side = fan[i];
      const bool is_last = i + 1 == fan.size();
      const FanSide& next = is_last ? fan.front() : fan[i + 1];
      const MetricCorner near = origin(side), far = origin(next);
      const double far_density = is_last ? first_density : density(far.metric);
      const double base = fast_edge_length(near.uv, near.metric, far.uv, far.metric);
      const double area = 0.5 * cross(near.uv - middle.uv, far.uv - middle.uv);
      set_size(delaunay_.mesh().face_handle(side.halfedge), side.spoke * base * next.spoke,
               area * (middle_density + near_density + far_density) / 3);
      near_density = far_density;
    }
  }

 private:
  /// Vertices for which room is made at least.
  static constexpr std::size_t kLeastGrowth = 64;

  MetricCorner origin(const FanSide& side) const {
    return corner(delaunay_, delaunay_.mesh().from_vertex_handle(side.halfedge));
  }

  void measure(FaceHandle fh) {
    const BaseTriangle t = triangle_at(delaunay_, delaunay_.mesh().halfedge_handle(fh));
    set_size(fh, product_of_sides(t.a, t.b, t.apex), metric_area(t.a, t.b, t.apex));
  }

  void set_size(FaceHandle fh, double product_of_sides, double metric_area) {
    State& state = states_[index(fh)];
    metric_area_ -= static_cast<double>(state.metric_area);
    state.metric_area = static_cast<float>(metric_area);
    if (!std::isfinite(state.metric_area)) state.metric_area = 0;
    metric_area_ += static_cast<double>(state.metric_area);
    const double size = squared_circumradius(product_of_sides, metric_area);
    state.squared_radius = static_cast<float>(size);
    state.is_accepted = size <= accepted_size_;
    state.is_active = false;
    ++state.stamp;
  }

  DelaunayMesh& delaunay_;
  double accepted_size_;
  std::vector<State> states_;
  double metric_area_ = 0;  ///< of all triangles
};

}  // namespace surfmesh
