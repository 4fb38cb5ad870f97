// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/place_nodes.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/delaunay/metric_swaps.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// Least distance of a new node from the others, in the larger of the two coordinates along a
/// cross. Larger values leave gaps: the mean scaled Jacobian of c2 is 0.963 with 0.55, 0.960 with
/// 0.7.
constexpr double kLeastDistance = 0.55;

/// Distance in the metric halfway below which a place is not looked at any further.
constexpr double kHopelessDistance = 0.4;

/// Least metric distance of a new node from a segment of the boundary.
constexpr double kLeastToBoundary = 0.45;

/// A neighbour within these bounds stands for the node that would be placed.
constexpr double kNearestNode = 0.6, kFarthest = 1.35, kSideways = 0.4;

/// Metric length at which the metric is differentiated.
constexpr double kDifference = 0.3;

/// A first place of a length within so much of 1 is good enough.
constexpr double kLengthError = 0.003;

/// Squared metric circumradius of a triangle from which a node is missing; that of half a unit
/// square is 1/2.
constexpr double kMissingNode = 1.3;

/// How many times larger a triangle may be at a point that must be resolved.
constexpr double kMissedSize = 2;

/// Triangles for each that the metric area asks for above which a run is given up.
constexpr double kMostTriangles = 3;

/// Beside the metric area, triangles for each node of the boundary.
constexpr double kMostForBoundary = 12;

/// A vertex and its cross.
struct Cross {
  RootFrame frame;
  Direction axis;
};

/// A new node that is not inserted yet.
struct Candidate {
  MetricCorner at;
  Cross cross;
};

class Placement {
 public:
  Placement(DelaunayMesh& delaunay, const MetricField& field,
            std::span<const BoundaryCorner> corners, const RunContext& context)
      : delaunay_(delaunay),
        field_(field),
        corners_(corners),
        context_(context),
        most_faces_(triangles_for(context.elements_left())),
        rule_{delaunay.uv_handle(), delaunay.metric_handle()} {
    predicted_ = metric_area() / 0.5;
    for (std::size_t v = 0; v < corners.size(); ++v) add_boundary_cross(v);
  }

  PlacementReport run() {
    do {
      empty_queue();
    } while (!report_.is_stopped && seed_missed_places());
    // Others count from here on, as quads.
    context_.change_unfinished(-static_cast<std::ptrdiff_t>(counted_faces_));
    report_.queries = hint_.answers;
    return report_;
  }

 private:
  /// Two triangles become a quad, and some nodes too many go again. The quads are counted later.
  static std::size_t triangles_for(std::size_t quads) {
    return quads > std::numeric_limits<std::size_t>::max() / 4 ? quads : 4 * quads;
  }

  // --- crosses ---

  /// At the boundary, the cross halves what the corner has more than its quads.
  void add_boundary_cross(std::size_t v) {
    const BoundaryCorner& corner = corners_[v];
    const VertexHandle vh(static_cast<int>(v));
    const double excess = corner.angle - corner.quads * 0.5 * std::numbers::pi;
    crosses_.push_back({RootFrame(delaunay_.metric(vh)), rotated(corner.ahead, 0.5 * excess)});
  }

  static Direction rotated(Direction d, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * d.c - s * d.s, c * d.s + s * d.c};
  }

  bool is_boundary(VertexHandle vh) const { return index(vh) < corners_.size(); }

  // --- the queue ---

  void empty_queue() {
    for (; next_ < crosses_.size(); ++next_) {
      if (next_ % kStepsBetweenCancellation == 0) {
        count_faces();
        context_.throw_if_cancelled();
      }
      if (exceeds_prediction()) {
        report_.is_stopped = true;
        return;
      }
      const VertexHandle vh(static_cast<int>(next_));
      if (is_boundary(vh)) {
        step_from_boundary(vh);
      } else {
        step_from_inside(vh);
      }
    }
  }

  void step_from_boundary(VertexHandle vh) {
    const BoundaryCorner& corner = corners_[index(vh)];
    connection_.reset();
    for (int k = 1; k < corner.quads; ++k) {
      step(vh, rotated(corner.ahead, corner.angle * k / corner.quads));
    }
  }

  void step_from_inside(VertexHandle vh) {
    connection_.reset();
    Direction direction = crosses_[index(vh)].axis;
    for (int k = 0; k < 4; ++k, direction = direction.quarter_turn()) step(vh, direction);
  }

  /// Try a new node in a direction from a vertex.
  void step(VertexHandle from, Direction direction) {
    if (is_taken(from, direction)) return;
    const std::optional<Candidate> candidate = candidate_at(from, direction);
    if (candidate) try_insert(*candidate, start_face(from));
  }

  FaceHandle start_face(VertexHandle vh) const {
    const PolyMesh& mesh = delaunay_.mesh();
    const HalfedgeHandle heh = mesh.halfedge_handle(vh);
    return mesh.face_handle(mesh.is_boundary(heh) ? mesh.opposite_halfedge_handle(heh) : heh);
  }

  /// True if a neighbour is about where the new node would be.
  bool is_taken(VertexHandle from, Direction direction) const {
    const Cross& cross = crosses_[index(from)];
    const Uv at = delaunay_.uv(from);
    for (const VertexHandle vh : delaunay_.mesh().vv_range(from)) {
      const Uv there = cross.frame.along(direction, delaunay_.uv(vh) - at);
      if (there.u >= kNearestNode && there.u <= kFarthest && std::abs(there.v) <= kSideways) {
        return true;
      }
    }
    return false;
  }

  // --- places ---

  /// The place at metric length 1, by the direction and the metric halfway.
  std::optional<Candidate> candidate_at(VertexHandle from, Direction direction) {
    const Cross& cross = crosses_[index(from)];
    const Uv at = delaunay_.uv(from);
    const Connection& connection = connection_at(from);
    const Uv half = 0.5 * cross.frame.step(direction);
    if (!is_inside(at + half, from)) return {};
    const RootFrame halfway(field_.at(at + half, hint_));
    const Direction carried = direction.turned(connection.angle(half));
    const Uv step = halfway.step(carried);
    if (is_hopeless(from, at + step, halfway, carried) || !is_inside(at + step, from)) return {};
    return at_unit_length(from, step, connection, direction);
  }

  /// Correct the length of a step by the metrics at both ends.
  std::optional<Candidate> at_unit_length(VertexHandle from, Uv step, const Connection& connection,
                                          Direction direction) {
    const Uv at = delaunay_.uv(from);
    const Metric& near = delaunay_.metric(from);
    Metric far = field_.at(at + step, hint_);
    for (int attempt = 0; attempt < 2; ++attempt) {
      const double length =
          edge_length(std::sqrt(squared_length(near, step)), std::sqrt(squared_length(far, step)));
      if (std::abs(length - 1) < kLengthError) break;
      if (!(length > 0)) return {};
      step = 1 / length * step;
      if (!is_inside(at + step, from)) return {};
      far = field_.at(at + step, hint_);
    }
    const Cross cross{RootFrame(far), direction.turned(connection.angle(step))};
    return Candidate{{at + step, far}, cross};
  }

  /// Beyond the boundary, the metric may not be asked for.
  bool is_inside(Uv p, VertexHandle from) {
    return std::isfinite(p.u) && std::isfinite(p.v) &&
           is_insertable(delaunay_.locate(p, start_face(from)));
  }

  bool is_insertable(const Location& location) const {
    return location.kind == Location::Kind::Inside ||
           (location.kind == Location::Kind::OnEdge &&
            !delaunay_.is_constrained(delaunay_.mesh().edge_handle(location.edge)));
  }

  bool is_hopeless(VertexHandle from, Uv p, const RootFrame& frame, Direction direction) const {
    for (const VertexHandle vh : delaunay_.mesh().vv_range(from)) {
      const Uv there = frame.along(direction, delaunay_.uv(vh) - p);
      if (std::max(std::abs(there.u), std::abs(there.v)) < kHopelessDistance) return true;
    }
    return false;
  }

  /// The connection at a vertex, once for all of its directions.
  const Connection& connection_at(VertexHandle vh) {
    if (!connection_) {
      const Cross& cross = crosses_[index(vh)];
      connection_ = connection_from(cross.frame, root_along(vh, cross.frame.step({1, 0})),
                                    root_along(vh, cross.frame.step({0, 1})));
    }
    return *connection_;
  }

  /// The derivative of the root along a unit step: by central differences, or by one-sided ones
  /// where a point is outside.
  RootFrame root_along(VertexHandle vh, Uv unit_step) {
    const Uv at = delaunay_.uv(vh), step = kDifference * unit_step;
    const bool has_after = is_inside(at + step, vh);
    const RootFrame after =
        has_after ? RootFrame(field_.at(at + step, hint_)) : crosses_[index(vh)].frame;
    const bool has_before = is_inside(at - step, vh);
    const RootFrame before =
        has_before ? RootFrame(field_.at(at - step, hint_)) : crosses_[index(vh)].frame;
    const double scale = 1 / (kDifference * (has_after && has_before ? 2 : 1));
    RootFrame result;
    result.s11 = scale * (after.s11 - before.s11);
    result.s12 = scale * (after.s12 - before.s12);
    result.s22 = scale * (after.s22 - before.s22);
    return result;
  }

  // --- insertion ---

  void try_insert(const Candidate& candidate, FaceHandle start) {
    const Location location = delaunay_.locate(candidate.at.uv, start);
    if (!is_insertable(location)) return;
    delaunay_.find_cavity(candidate.at.uv, location, rule_, cavity_);
    if (keeps_its_distance(candidate)) insert(candidate);
  }

  void insert(const Candidate& candidate) {
    const VertexHandle vh = delaunay_.fill(cavity_, candidate.at.uv);
    delaunay_.metric(vh) = candidate.at.metric;
    crosses_.push_back(candidate.cross);
    ++report_.inserted;
    if (delaunay_.n_faces() > most_faces_) context_.throw_too_many_elements();
  }

  bool keeps_its_distance(const Candidate& candidate) const {
    const PolyMesh& mesh = delaunay_.mesh();
    for (const HalfedgeHandle heh : cavity_.rim) {
      if (distance(candidate, mesh.from_vertex_handle(heh)) < kLeastDistance) return false;
      if (delaunay_.is_constrained(mesh.edge_handle(heh)) &&
          squared_distance_to(candidate.at, heh) < kLeastToBoundary * kLeastToBoundary) {
        return false;
      }
    }
    return true;
  }

  /// The mean of both crosses' distances, each the larger of its two coordinates.
  double distance(const Candidate& candidate, VertexHandle vh) const {
    const Uv step = delaunay_.uv(vh) - candidate.at.uv;
    return 0.5 * (distance(candidate.cross, step) + distance(crosses_[index(vh)], step));
  }

  static double distance(const Cross& cross, Uv step) {
    const Uv there = cross.frame.along(cross.axis, step);
    return std::max(std::abs(there.u), std::abs(there.v));
  }

  double squared_distance_to(const MetricCorner& p, HalfedgeHandle segment) const {
    const PolyMesh& mesh = delaunay_.mesh();
    const Uv a = delaunay_.uv(mesh.from_vertex_handle(segment)) - p.uv;
    const Uv side = delaunay_.uv(mesh.to_vertex_handle(segment)) - p.uv - a;
    const double share =
        std::clamp(-inner_product(p.metric, a, side) / squared_length(p.metric, side), 0.0, 1.0);
    return squared_length(p.metric, a + share * side);
  }

  // --- places that no step reached ---

  /// Put nodes into triangles that are much too large, and at points that must be resolved.
  /// Returns  whether there were any
  bool seed_missed_places() {
    const std::size_t before = report_.inserted;
    seed_required_points();
    for (std::size_t f = 0; f < delaunay_.n_faces(); ++f) {
      if (f % kStepsBetweenCancellation == 0) context_.throw_if_cancelled();
      if (exceeds_prediction()) {
        report_.is_stopped = true;
        return false;
      }
      const FaceHandle fh(static_cast<int>(f));
      const MetricCircle circle = circle_of(fh);
      if (circle.squared_radius > kMissingNode) seed(circle.centre, fh);
    }
    return report_.inserted > before;
  }

  MetricCircle circle_of(FaceHandle fh) const {
    const TriangleVertices v = vertices(delaunay_.mesh(), fh);
    const Metric m = mean(delaunay_.metric(v[0]), delaunay_.metric(v[1]), delaunay_.metric(v[2]));
    return circumcircle(corners(delaunay_.mesh(), v, delaunay_.uv_handle()), m);
  }

  void seed_required_points() {
    FaceHandle near(0);
    for (const MetricCorner& point : field_.required_points()) {
      const Location location = delaunay_.locate(point.uv, near);
      near = location.face;
      if (!is_insertable(location)) continue;
      const auto triangle = surfmesh::corners(delaunay_.mesh(), near, delaunay_.uv_handle());
      if (circumcircle(triangle, point.metric).squared_radius > kMissedSize * kMissingNode) {
        seed(point.uv, near);
        near = FaceHandle(0);
      }
    }
  }

  /// Insert a node whose cross is along the axes of the metric's root.
  void seed(Uv uv, FaceHandle start) {
    if (!std::isfinite(uv.u) || !std::isfinite(uv.v)) return;
    const Location location = delaunay_.locate(uv, start);
    if (!is_insertable(location)) return;
    const Metric metric = field_.at(uv, hint_);
    try_insert({{uv, metric}, {RootFrame(metric), {}}}, location.face);
  }

  // --- bounds ---

  double metric_area() const {
    double sum = 0;
    for (std::size_t f = 0; f < delaunay_.n_faces(); ++f) {
      const TriangleVertices v = vertices(delaunay_.mesh(), FaceHandle(static_cast<int>(f)));
      sum += surfmesh::metric_area(corner(delaunay_, v[0]), corner(delaunay_, v[1]),
                                   corner(delaunay_, v[2]));
    }
    return sum;
  }

  /// The area is asked for again as the mesh grows: its metric is known better then.
  bool exceeds_prediction() {
    const double slack = kMostForBoundary * static_cast<double>(corners_.size());
    if (static_cast<double>(delaunay_.n_faces()) <= kMostTriangles * predicted_ + slack) {
      return false;
    }
    predicted_ = metric_area() / 0.5;
    return static_cast<double>(delaunay_.n_faces()) > kMostTriangles * predicted_ + slack;
  }

  /// Let the observer know of the triangles that have come since.
  void count_faces() {
    const std::size_t count = delaunay_.n_faces();
    context_.change_unfinished(static_cast<std::ptrdiff_t>(count - counted_faces_));
    counted_faces_ = count;
  }

  DelaunayMesh& delaunay_;
  const MetricField& field_;
  std::span<const BoundaryCorner> corners_;
  const RunContext& context_;
  std::size_t most_faces_;
  TriangleMetricRule rule_;
  double predicted_ = 0;                  ///< triangles that the metric area asks for
  std::vector<Cross> crosses_;            ///< by vertex
  std::size_t next_ = 0;                  ///< vertex whose turn it is
  std::optional<Connection> connection_;  ///< at that vertex
  std::size_t counted_faces_ = 0;
  QueryHint hint_;
  Cavity cavity_;
  PlacementReport report_;
};

}  // namespace

PlacementReport place_square_nodes(DelaunayMesh& delaunay, const MetricField& field,
                                   std::span<const BoundaryCorner> corners,
                                   const RunContext& context) {
  const std::size_t boundary_count = delaunay.n_vertices();
  PlacementReport report = tell_out_of_memory(
      [&] { return Placement(delaunay, field, corners, context).run(); },
      [&] { return "at " + std::to_string(delaunay.n_faces()) + " triangles of it"; });
  delaunay.shrink();
  context.throw_if_cancelled();
  delaunay.sort_spatially(boundary_count);
  return report;
}

}  // namespace surfmesh
