// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/refine.hh"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "surfmesh/core/option_range.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/delaunay/metric_swaps.hh"
#include "surfmesh/delaunay/spatial_order.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/refine/face_states.hh"
#include "surfmesh/refine/front.hh"
#include "surfmesh/refine/placement.hh"

namespace surfmesh {
namespace {

/// Squared metric circumradius up to which a triangle is accepted; the unit triangle has 1/3.
double accepted_size(Placement placement) {
  // A front of unit triangles needs room for those a little too large; circumcentres halve what
  // they split, so the mean edge is 1 only with a higher bound.
  return placement == Placement::Frontal ? 0.72 * 0.72 : 0.74 * 0.74;
}

/// How many times too large a triangle may be for a point inside it that its vertices do not show.
constexpr double kMissedSize = 2;

/// Least metric distance of a new node from the others.
double least_distance(Placement placement) { return placement == Placement::Frontal ? 0.7 : 0.5; }

/// Triangles for each that the metric area asks for above which a run is given up.
constexpr double kMostTriangles = 3;

/// A run is not given up either for fewer triangles than this many for each that the boundary makes
/// by itself: between near sides of many nodes there is next to no area.
constexpr double kMostForBoundary = 2;

bool is_finite(Uv p) { return std::isfinite(p.u) && std::isfinite(p.v); }

/// Inserts nodes into the triangles of the front.
class Refinement {
 public:
  Refinement(DelaunayMesh& delaunay, const MetricField& field, const RefineOptions& options,
             const RunContext& context)
      : delaunay_(delaunay),
        field_(field),
        options_(options),
        context_(context),
        most_faces_(context.elements_left()),
        rule_{delaunay.uv_handle(), delaunay.metric_handle()},
        accepted_size_(accepted_size(options.placement)),
        least_distance_(least_distance(options.placement)),
        slack_(delaunay.n_faces()),
        states_(delaunay, accepted_size_),
        front_(delaunay, states_, options.placement) {}

  RefineReport run() {
    empty_front();
    if (!report_.is_stopped && insert_required_points()) empty_front();
    count_faces();
    report_.queries = hint_.answers;
    return report_;
  }

 private:
  /// Let the observer know of the triangles that have come since.
  void count_faces() {
    const std::size_t count = delaunay_.n_faces();
    context_.change_unfinished(static_cast<std::ptrdiff_t>(count - counted_faces_));
    counted_faces_ = count;
  }

  void empty_front() {
    FrontQueue::Entry entry;
    std::size_t steps = 0;
    while (front_.pop(entry)) {
      if (exceeds_prediction()) {
        report_.is_stopped = true;
        return;
      }
      if (!front_.is_current(entry)) continue;
      if (++steps % kStepsBetweenCancellation == 0) {
        count_faces();
        context_.throw_if_cancelled();
      }
      const HalfedgeHandle base = front_.base_of(entry.face);
      if (!base.is_valid()) {
        states_[entry.face].is_active = false;  // its accepted neighbour has been replaced since
      } else if (!split(entry.face, base)) {
        ++report_.counts.refused;
        front_.accept(entry.face);
      }
    }
  }

  /// True if there are far more triangles than the metric area of the mesh asks for: no triangles
  /// of unit edges follow a metric that turns too fast.
  bool exceeds_prediction() const {
    return static_cast<double>(delaunay_.n_faces() - slack_) >
           std::max(kMostTriangles * states_.predicted_count(),
                    kMostForBoundary * static_cast<double>(slack_));
  }

  /// Insert points of the field that lie in triangles much too large for them: what lies between
  /// the vertices of a triangle alone is never asked for.
  bool insert_required_points() {
    bool is_any = false;
    for (const auto& [point, face] : missed_points()) {
      if (exceeds_prediction()) {
        report_.is_stopped = true;
        return false;
      }
      const Location location = delaunay_.locate(point.uv, face);
      if (!is_insertable(location) || !is_missed(point, location.face)) continue;
      delaunay_.find_cavity(point.uv, location, rule_, cavity_);
      if (!keeps_its_distance(point)) continue;
      insert(point.uv, point.metric, location);
      is_any = true;
    }
    return is_any;
  }

  /// A point that the field requires, and the triangle that it lies in.
  struct RequiredPoint {
    MetricCorner point;
    FaceHandle face;
  };

  /// The required points in triangles that are too large for them, in the order of the field. They
  /// are looked for along a curve: the walk from each to the next one is short.
  std::vector<RequiredPoint> missed_points() {
    const std::span<const MetricCorner> points = field_.required_points();
    std::vector<Uv> uvs;
    uvs.reserve(points.size());
    for (const MetricCorner& point : points) uvs.push_back(point.uv);
    std::vector<FaceHandle> faces(points.size());  // invalid where none is too large
    FaceHandle near(0);
    for (const int i : cell_order(uvs)) {
      const auto at = static_cast<std::size_t>(i);
      const Location location = delaunay_.locate(uvs[at], near);
      near = location.face;
      if (is_insertable(location) && is_missed(points[at], near)) faces[at] = near;
    }
    std::vector<RequiredPoint> missed;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (faces[i].is_valid()) missed.push_back({points[i], faces[i]});
    }
    return missed;
  }

  bool is_missed(const MetricCorner& point, FaceHandle fh) const {
    const auto [a, b, c] = corners(delaunay_.mesh(), fh, delaunay_.uv_handle());
    const MetricCircle circle = circumcircle({a, b, c}, point.metric);
    return circle.squared_radius > kMissedSize * kMissedSize * accepted_size_;
  }

  bool split(FaceHandle fh, HalfedgeHandle base) {
    const BaseTriangle triangle = triangle_at(delaunay_, base);
    if (options_.placement == Placement::Frontal && try_frontal(fh, triangle)) return true;
    if (try_insert(circumcentre(triangle), fh, triangle, true)) return true;
    return options_.placement == Placement::Circumcentre &&
           try_insert(0.5 * (triangle.a.uv + triangle.b.uv), fh, triangle, false);
  }

  /// The point before its correction is asked for the metric only if it lies inside.
  bool try_frontal(FaceHandle fh, const BaseTriangle& triangle) {
    const std::optional<Uv> uv = frontal_point(triangle);
    if (!uv || !is_finite(*uv)) return false;
    const Location location = delaunay_.locate(*uv, fh);
    if (!is_insertable(location)) return false;
    const MetricCorner point{*uv, field_.at(*uv, hint_)};
    return try_insert(correct_frontal_point(triangle, point), location.face, triangle, false);
  }

  bool try_insert(Uv p, FaceHandle fh, const BaseTriangle& triangle, bool must_conform) {
    if (!is_finite(p)) return false;
    const Location location = delaunay_.locate(p, fh);
    if (!is_insertable(location)) return false;
    const Metric metric = field_.at(p, hint_);
    if (must_conform && !conforms(triangle, p, metric)) {
      ++report_.counts.unconforming;
      return false;
    }
    delaunay_.find_cavity(p, location, rule_, cavity_);
    if (!keeps_its_distance({p, metric})) return false;
    insert(p, metric, location);
    return true;
  }

  bool is_insertable(const Location& location) const {
    return location.kind == Location::Kind::Inside ||
           (location.kind == Location::Kind::OnEdge &&
            !delaunay_.is_constrained(delaunay_.mesh().edge_handle(location.edge)));
  }

  /// The check of the paper: the metric at the new point is that of the triangle, nearly. Without
  /// a threshold, in the metric at the new point, the point still splits its triangle.
  bool conforms(const BaseTriangle& t, Uv p, const Metric& metric) const {
    if (options_.conformity == 0 || options_.placement == Placement::Frontal) {
      return in_metric_circle({t.a.uv, t.b.uv, t.apex.uv}, p, metric);
    }
    const Metric of_triangle = mean(t.a.metric, t.b.metric, t.apex.metric);
    return metric_conformity(of_triangle, metric) <= options_.conformity;
  }

  /// Far enough from all nodes around, and not facing a boundary edge under more than 90°. Collects
  /// the fan that replaces the cavity.
  bool keeps_its_distance(const MetricCorner& p) {
    const PolyMesh& mesh = delaunay_.mesh();
    fan_.clear();
    for (const HalfedgeHandle heh : cavity_.rim) {
      const MetricCorner a = corner(delaunay_, mesh.from_vertex_handle(heh));
      const double spoke = fast_edge_length(a.uv, a.metric, p.uv, p.metric);
      if (spoke < least_distance_) return false;
      fan_.push_back({heh, spoke});
      if (!delaunay_.is_constrained(mesh.edge_handle(heh))) continue;
      const Uv to_a = a.uv - p.uv, to_b = delaunay_.uv(mesh.to_vertex_handle(heh)) - p.uv;
      if (inner_product(p.metric, to_a, to_b) < 0) return false;
    }
    return true;
  }

  void insert(Uv p, const Metric& metric, const Location& location) {
    states_.grow();
    VertexHandle vh;
    if (options_.kernel == Kernel::Cavity) {
      vh = delaunay_.fill(cavity_, p);
    } else {
      vh = delaunay_.insert_by_swaps(p, location.face, rule_);
    }
    delaunay_.metric(vh) = metric;
    ++report_.counts.inserted;
    if (delaunay_.n_faces() > most_faces_) context_.throw_too_many_elements();
    // Swaps do not end at the cavity.
    if (options_.kernel == Kernel::Swap) collect_fan(delaunay_, vh, fan_);
    states_.measure_fan(vh, fan_);
    front_.add(fan_);
  }

  DelaunayMesh& delaunay_;
  const MetricField& field_;
  const RefineOptions& options_;
  const RunContext& context_;
  std::size_t most_faces_;
  TriangleMetricRule rule_;
  double accepted_size_;
  double least_distance_;
  std::size_t counted_faces_ = 0;
  std::size_t slack_;  ///< triangles that the boundary alone makes
  FaceStates states_;
  Front front_;
  QueryHint hint_;
  Cavity cavity_;
  Fan fan_;  ///< of the point that is tried
  RefineReport report_;
};

}  // namespace

RefineCounts& RefineCounts::operator+=(const RefineCounts& other) {
  inserted += other.inserted;
  refused += other.refused;
  unconforming += other.unconforming;
  return *this;
}

void check(const RefineOptions& options) {
  check_option(ranges::kPlacement, options.placement);
  check_option(ranges::kKernel, options.kernel);
  check_option(ranges::kConformity, options.conformity);
}

RefineReport refine(DelaunayMesh& delaunay, const MetricField& field, const RefineOptions& options,
                    const RunContext& context) {
  check(options);
  const std::size_t boundary_count = delaunay.n_vertices();
  RefineReport report = tell_out_of_memory(
      [&] { return Refinement(delaunay, field, options, context).run(); },
      [&] { return "at " + std::to_string(delaunay.n_faces()) + " triangles of it"; });
  delaunay.shrink();
  context.throw_if_cancelled();
  delaunay.sort_spatially(boundary_count);
  return report;
}

}  // namespace surfmesh
