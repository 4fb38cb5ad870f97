// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "surfmesh/delaunay/metric_swaps.hh"
#include "surfmesh/metric/triangle.hh"
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

  /// Measure the triangles around a vertex, each spoke once.
  void measure_fan(VertexHandle vh) {
    const PolyMesh& mesh = delaunay_.mesh();
    const MetricCorner centre = corner(delaunay_, vh);
    const double centre_density = density(centre.metric);
    const HalfedgeHandle start = mesh.halfedge_handle(vh);
    HalfedgeHandle spoke = start;
    FanCorner near = fan_corner(centre, spoke);
    do {
      const FaceHandle fh = mesh.face_handle(spoke);
      spoke = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(spoke));
      const FanCorner far = fan_corner(centre, spoke);
      const double base = fast_edge_length(near.at.uv, near.at.metric, far.at.uv, far.at.metric);
      const double area = 0.5 * cross(near.at.uv - centre.uv, far.at.uv - centre.uv);
      set_size(fh, near.spoke * base * far.spoke,
               area * (centre_density + near.density + far.density) / 3);
      near = far;
    } while (spoke != start);
  }

 private:
  /// Vertices for which room is made at least.
  static constexpr std::size_t kLeastGrowth = 64;

  /// A neighbour of a vertex, with its own density and its distance.
  struct FanCorner {
    MetricCorner at;
    double density;
    double spoke;
  };

  FanCorner fan_corner(const MetricCorner& centre, HalfedgeHandle spoke) const {
    const MetricCorner at = corner(delaunay_, delaunay_.mesh().to_vertex_handle(spoke));
    return {at, density(at.metric), fast_edge_length(centre.uv, centre.metric, at.uv, at.metric)};
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
