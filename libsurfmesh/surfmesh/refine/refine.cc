// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/refine.hh"

#include <fmt/format.h>

#include <cmath>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/delaunay/metric_swaps.hh"
#include "surfmesh/refine/front_queue.hh"
#include "surfmesh/refine/placement.hh"

namespace surfmesh {
namespace {

/// Squared metric circumradius up to which a triangle is accepted; the unit triangle has 1/3.
double accepted_size(Placement placement) {
  // A front of unit triangles needs room for those a little too large; circumcentres halve what
  // they split, so the mean edge is 1 only with a higher bound.
  return placement == Placement::Frontal ? 0.72 * 0.72 : 0.74 * 0.74;
}

/// How many times too large a triangle may be for a place inside it that its vertices do not show.
constexpr double kMissedSize = 2;

/// Vertices for which room is made at least.
constexpr std::size_t kLeastGrowth = 64;

/// Least metric distance of a new node from the others.
double least_distance(Placement placement) { return placement == Placement::Frontal ? 0.7 : 0.5; }

/// Triangles for each that the metric area asks for above which a run is given up.
constexpr double kMostTriangles = 3;

class Refinement {
 public:
  Refinement(DelaunayMesh& delaunay, const MetricField& field, const RefineOptions& options)
      : delaunay_(delaunay),
        field_(field),
        options_(options),
        rule_{delaunay.uv_handle(), delaunay.metric_handle()},
        accepted_size_(accepted_size(options.placement)),
        least_distance_(least_distance(options.placement)) {}

  RefineReport run() {
    slack_ = delaunay_.n_faces();
    states_.resize(delaunay_.n_faces());
    for (std::size_t f = 0; f < delaunay_.n_faces(); ++f) {
      measure(FaceHandle(static_cast<int>(f)));
    }
    for (std::size_t f = 0; f < delaunay_.n_faces(); ++f) {
      activate(FaceHandle(static_cast<int>(f)));
    }
    empty_queue();
    if (!report_.is_stopped && insert_missed_places()) empty_queue();
    report_.queries = hint_.answers;
    return report_;
  }

 private:
  struct State {
    float squared_radius = 0;
    float metric_area = 0;
    std::uint32_t stamp = 0;
    bool is_accepted = false;
    bool is_active = false;
  };

  void empty_queue() {
    FrontQueue::Entry entry;
    std::size_t steps = 0;
    while (queue_.pop(entry)) {
      if (is_astray()) {
        report_.is_stopped = true;
        return;
      }
      State& state = states_[index(entry.face)];
      if (state.stamp != entry.stamp || state.is_accepted) continue;
      if (++steps % kStepsBetweenCancellation == 0) throw_if_cancelled(options_.observer);
      const HalfedgeHandle base = base_of(entry.face);
      if (!base.is_valid()) {
        state.is_active = false;  // its accepted neighbour has been replaced since
      } else if (!split(entry.face, base)) {
        ++report_.refused;
        accept(entry.face);
      }
    }
  }

  double predicted_count() const { return metric_area_ / kUnitTriangleArea; }

  /// True if there are far more triangles than the metric area of the mesh asks for: no triangles
  /// of unit edges follow a metric that turns too fast.
  bool is_astray() const {
    return static_cast<double>(delaunay_.n_faces() - slack_) > kMostTriangles * predicted_count();
  }

  /// Insert places of the field that lie in triangles much too large for them: what lies between
  /// the vertices of a triangle alone is never asked for.
  bool insert_missed_places() {
    bool is_any = false;
    FaceHandle near(0);
    for (const MetricCorner& place : field_.required_points()) {
      if (is_astray()) {
        report_.is_stopped = true;
        return false;
      }
      const Location location = delaunay_.locate(place.uv, near);
      near = location.face;
      if (!is_insertable(location) || !is_missed(place, location.face)) continue;
      delaunay_.find_cavity(place.uv, location, rule_, cavity_);
      if (!is_good_place(place)) continue;
      insert(place.uv, place.metric, location);
      near = delaunay_.mesh().face_handle(delaunay_.mesh().halfedge_handle(
          VertexHandle(static_cast<int>(delaunay_.n_vertices()) - 1)));
      is_any = true;
    }
    return is_any;
  }

  bool is_missed(const MetricCorner& place, FaceHandle fh) const {
    const auto [a, b, c] = corners(delaunay_.mesh(), fh, delaunay_.uv_handle());
    const MetricCircle circle = circumcircle({a, b, c}, place.metric);
    return circle.squared_radius > kMissedSize * kMissedSize * accepted_size_;
  }

  static std::size_t index(FaceHandle fh) { return static_cast<std::size_t>(fh.idx()); }

  /// Faces come two at a time; mesh and states grow in bulk, towards the count that is predicted by
  /// now: at first from the boundary alone, which may be far off.
  void grow() {
    if (delaunay_.n_faces() + 2 <= states_.size()) return;
    constexpr double reserve = 1.1, least = 1.5, most = 4;
    const auto count = static_cast<double>(delaunay_.n_faces());
    const double wanted = std::clamp(reserve * predicted_count(), least * count, most * count);
    const auto added = static_cast<std::size_t>(wanted - count) / 2 + kLeastGrowth;
    delaunay_.reserve(added);
    states_.resize(delaunay_.n_faces() + 2 * added);
  }

  BaseTriangle triangle_at(HalfedgeHandle base) const {
    const TriMesh& mesh = delaunay_.mesh();
    return {corner(delaunay_, mesh.from_vertex_handle(base)),
            corner(delaunay_, mesh.to_vertex_handle(base)),
            corner(delaunay_, mesh.to_vertex_handle(mesh.next_halfedge_handle(base)))};
  }

  void measure(FaceHandle fh) {
    const BaseTriangle t = triangle_at(delaunay_.mesh().halfedge_handle(fh));
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

  bool is_front(HalfedgeHandle heh) const {
    const FaceHandle neighbour =
        delaunay_.mesh().face_handle(delaunay_.mesh().opposite_halfedge_handle(heh));
    return !neighbour.is_valid() || states_[index(neighbour)].is_accepted;
  }

  /// Put a triangle into the queue if it is to be split and, with frontal placement, is at the
  /// front.
  void activate(FaceHandle fh) {
    State& state = states_[index(fh)];
    if (state.is_accepted || state.is_active) return;
    const HalfedgeHandle a = delaunay_.mesh().halfedge_handle(fh);
    const HalfedgeHandle b = delaunay_.mesh().next_halfedge_handle(a);
    const HalfedgeHandle c = delaunay_.mesh().next_halfedge_handle(b);
    if (options_.placement == Placement::Frontal && !is_front(a) && !is_front(b) && !is_front(c)) {
      return;
    }
    state.is_active = true;
    queue_.push({fh, state.stamp}, static_cast<double>(state.squared_radius));
  }

  void activate_neighbour(HalfedgeHandle heh) {
    const FaceHandle neighbour =
        delaunay_.mesh().face_handle(delaunay_.mesh().opposite_halfedge_handle(heh));
    if (neighbour.is_valid()) activate(neighbour);
  }

  void accept(FaceHandle fh) {
    states_[index(fh)].is_accepted = true;
    HalfedgeHandle heh = delaunay_.mesh().halfedge_handle(fh);
    for (int k = 0; k < 3; ++k, heh = delaunay_.mesh().next_halfedge_handle(heh)) {
      activate_neighbour(heh);
    }
  }

  /// The shortest side at the front (frontal; invalid if there is none), or the longest
  /// (circumcentre).
  HalfedgeHandle base_of(FaceHandle fh) const {
    const TriMesh& mesh = delaunay_.mesh();
    const bool is_frontal = options_.placement == Placement::Frontal;
    HalfedgeHandle best;
    double best_length = INFINITY;
    HalfedgeHandle heh = mesh.halfedge_handle(fh);
    for (int k = 0; k < 3; ++k, heh = mesh.next_halfedge_handle(heh)) {
      if (is_frontal && !is_front(heh)) continue;
      const MetricCorner a = corner(delaunay_, mesh.from_vertex_handle(heh));
      const MetricCorner b = corner(delaunay_, mesh.to_vertex_handle(heh));
      const double length = fast_edge_length(a.uv, a.metric, b.uv, b.metric);
      const double rank = is_frontal ? length : -length;
      if (rank < best_length) {
        best_length = rank;
        best = heh;
      }
    }
    return best;
  }

  bool split(FaceHandle fh, HalfedgeHandle base) {
    const BaseTriangle triangle = triangle_at(base);
    if (options_.placement == Placement::Frontal && try_frontal(fh, triangle)) return true;
    if (try_insert(circumcentre(triangle), fh, triangle, true)) return true;
    return options_.placement == Placement::Circumcentre &&
           try_insert(0.5 * (triangle.a.uv + triangle.b.uv), fh, triangle, false);
  }

  /// The place before its correction is asked for the metric only if it lies inside.
  bool try_frontal(FaceHandle fh, const BaseTriangle& triangle) {
    const std::optional<Uv> place = frontal_point(triangle);
    if (!place) return false;
    const Location location = delaunay_.locate(*place, fh);
    if (!is_insertable(location)) return false;
    const MetricCorner point{*place, field_.at(*place, hint_)};
    return try_insert(correct_frontal_point(triangle, point), location.face, triangle, false);
  }

  bool try_insert(Uv p, FaceHandle fh, const BaseTriangle& triangle, bool must_conform) {
    if (!std::isfinite(p.u) || !std::isfinite(p.v)) return false;
    const Location location = delaunay_.locate(p, fh);
    if (!is_insertable(location)) return false;
    const Metric metric = field_.at(p, hint_);
    if (must_conform && !conforms(triangle, p, metric)) return false;
    delaunay_.find_cavity(p, location, rule_, cavity_);
    if (!is_good_place({p, metric})) return false;
    insert(p, metric, location);
    return true;
  }

  bool is_insertable(const Location& location) const {
    return location.kind == Location::Kind::Inside ||
           (location.kind == Location::Kind::OnEdge &&
            !delaunay_.is_constrained(delaunay_.mesh().edge_handle(location.edge)));
  }

  /// The check of the paper: in the metric at the new point, the point still splits its triangle.
  static bool conforms(const BaseTriangle& t, Uv p, const Metric& metric) {
    return in_metric_circle({t.a.uv, t.b.uv, t.apex.uv}, p, metric);
  }

  /// Far enough from all nodes around, and not facing a boundary edge under more than 90°.
  bool is_good_place(const MetricCorner& p) const {
    const TriMesh& mesh = delaunay_.mesh();
    for (const HalfedgeHandle heh : cavity_.rim) {
      const MetricCorner a = corner(delaunay_, mesh.from_vertex_handle(heh));
      if (fast_edge_length(a.uv, a.metric, p.uv, p.metric) < least_distance_) return false;
      if (!delaunay_.is_constrained(mesh.edge_handle(heh))) continue;
      const Uv to_a = a.uv - p.uv, to_b = delaunay_.uv(mesh.to_vertex_handle(heh)) - p.uv;
      if (inner_product(p.metric, to_a, to_b) < 0) return false;
    }
    return true;
  }

  void insert(Uv p, const Metric& metric, const Location& location) {
    grow();
    VertexHandle vh;
    if (options_.kernel == Kernel::Cavity) {
      vh = delaunay_.fill(cavity_, p);
    } else {
      vh = delaunay_.insert_by_swaps(p, location.face, rule_);
    }
    delaunay_.metric(vh) = metric;
    ++report_.inserted;
    if (delaunay_.n_faces() > options_.max_elements) {
      throw Error(ErrorCode::Limit,
                  fmt::format("more than max_elements = {} triangles", options_.max_elements));
    }
    update_fan(vh);
  }

  /// Measure the triangles around a vertex: as measure() does, but each spoke once.
  void measure_fan(VertexHandle vh) {
    const TriMesh& mesh = delaunay_.mesh();
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

  void update_fan(VertexHandle vh) {
    measure_fan(vh);
    const TriMesh& mesh = delaunay_.mesh();
    const HalfedgeHandle start = mesh.halfedge_handle(vh);
    HalfedgeHandle spoke = start;
    do {
      activate(mesh.face_handle(spoke));
      // A neighbour of an accepted triangle is at the front now.
      if (states_[index(mesh.face_handle(spoke))].is_accepted) {
        activate_neighbour(mesh.next_halfedge_handle(spoke));
      }
      spoke = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(spoke));
    } while (spoke != start);
  }

  DelaunayMesh& delaunay_;
  const MetricField& field_;
  const RefineOptions& options_;
  TriangleMetricRule rule_;
  double accepted_size_;
  double least_distance_;
  QueryHint hint_;
  FrontQueue queue_;
  std::vector<State> states_;
  double metric_area_ = 0;  ///< of all triangles
  std::size_t slack_ = 0;   ///< triangles that the boundary alone makes
  Cavity cavity_;
  RefineReport report_;
};

}  // namespace

void check(const RefineOptions& options) {
  check_option(ranges::kPlacement, options.placement);
  check_option(ranges::kKernel, options.kernel);
  check_option(ranges::kMaxElements, static_cast<double>(options.max_elements));
}

RefineReport refine(DelaunayMesh& delaunay, const MetricField& field,
                    const RefineOptions& options) {
  check(options);
  const std::size_t boundary_count = delaunay.n_vertices();
  RefineReport report = Refinement(delaunay, field, options).run();
  delaunay.shrink();
  delaunay.sort_spatially(boundary_count);
  return report;
}

}  // namespace surfmesh
