// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/boundary_triangulation.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "surfmesh/core/error.hh"
#include "surfmesh/delaunay/metric_swaps.hh"
#include "surfmesh/delaunay/spatial_order.hh"

namespace surfmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The box around the loops is wider than them by this share on each side.
constexpr double kMargin = 0.25;

struct Box {
  Uv lower{kInfinity, kInfinity};
  Uv upper{-kInfinity, -kInfinity};
};

void extend(Box& box, Uv p) {
  box.lower = {std::min(box.lower.u, p.u), std::min(box.lower.v, p.v)};
  box.upper = {std::max(box.upper.u, p.u), std::max(box.upper.v, p.v)};
}

Box box_around(const std::vector<Uv>& points) {
  Box box;
  for (const Uv p : points) extend(box, p);
  const Uv margin = kMargin * (box.upper - box.lower);
  return {box.lower - margin, box.upper + margin};
}

Metric plane_metric(const std::vector<Metric>& metrics) {
  Metric sum{0, 0, 0};
  for (const Metric& m : metrics) {
    sum.m11 += m.m11;
    sum.m22 += m.m22;
  }
  return sum;
}

/// The nodes of loops, one after the other.
struct LoopNodes {
  std::vector<Uv> points;
  std::vector<std::size_t> next;  ///< in the loop

  explicit LoopNodes(const std::vector<std::vector<Uv>>& loops) {
    for (const auto& loop : loops) {
      const std::size_t first = points.size();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        points.push_back(loop[i]);
        next.push_back(first + (i + 1) % loop.size());
      }
    }
  }
};

/// Triangulates all nodes in a box and knows which vertex each one became. Nodes at which loops
/// touch are one vertex.
class BoxTriangulation {
 public:
  BoxTriangulation(const LoopNodes& nodes, const Metric& plane)
      : nodes_(nodes), box_(box_around(nodes.points)), delaunay_(box_.lower, box_.upper) {
    const std::vector<Uv>& points = nodes.points;
    const ConstantMetricRule rule{delaunay_.uv_handle(), plane};
    delaunay_.reserve(points.size() + 4);
    vertices_.resize(points.size());
    FaceHandle hint(0);
    for (const int i : spatial_order(points)) {
      const std::size_t before = delaunay_.n_vertices();
      const VertexHandle vh = delaunay_.insert(points[static_cast<std::size_t>(i)], hint, rule);
      if (!vh.is_valid()) throw_touching(points[static_cast<std::size_t>(i)]);
      is_touching_ |= delaunay_.n_vertices() == before;
      vertices_[static_cast<std::size_t>(i)] = vh;
      hint = delaunay_.mesh().face_handle(delaunay_.mesh().halfedge_handle(vh));
    }
  }

  void constrain(std::size_t from, std::size_t to) {
    const VertexHandle a = vertices_[from], b = vertices_[to];
    if (is_touching_ && is_constrained(a, b)) {
      throw_touching(delaunay_.uv(std::count(vertices_.begin(), vertices_.end(), a) > 1 ? a : b));
    }
    delaunay_.insert_constraint(a, b);
    // A chain of edges passes through a node that is not of this segment.
    if (delaunay_.find_halfedge(a, b).is_valid()) return;
    throw_touching(node_between(a, b));
  }

  /// The triangles at an odd number of segments from the box's rim, as indices of nodes.
  std::vector<std::array<int, 3>> inside() const {
    std::vector<int> node_of(delaunay_.n_vertices(), -1);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      int& node = node_of[index(vertices_[i])];
      node = node == -1 ? static_cast<int>(i) : kSeveral;
    }
    const std::vector<char> depth = depth_of_faces();
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t f = 0; f < delaunay_.n_faces(); ++f) {
      if (depth[f] != 1) continue;
      std::array<int, 3> triangle{};
      std::size_t k = 0;
      for (const HalfedgeHandle heh : delaunay_.mesh().fh_range(FaceHandle(static_cast<int>(f)))) {
        const PolyMesh& mesh = delaunay_.mesh();
        const int node = node_of[index(mesh.to_vertex_handle(heh))];
        triangle[k++] = node == kSeveral ? node_of_sector(mesh.next_halfedge_handle(heh)) : node;
      }
      triangles.push_back(triangle);
    }
    return triangles;
  }

 private:
  [[noreturn]] static void throw_touching(Uv p) {
    throw Error(ErrorCode::Geometry,
                fmt::format("the boundary touches itself at (u,v) = ({}, {})", p.u, p.v));
  }

  bool is_constrained(VertexHandle a, VertexHandle b) const {
    const HalfedgeHandle heh = delaunay_.find_halfedge(a, b);
    return heh.is_valid() && delaunay_.is_constrained(delaunay_.mesh().edge_handle(heh));
  }

  /// Where loops touch, the node from which the segment starts that has the sector of a halfedge on
  /// its left.
  int node_of_sector(HalfedgeHandle heh) const {
    const PolyMesh& mesh = delaunay_.mesh();
    const VertexHandle from = mesh.from_vertex_handle(heh);
    while (!delaunay_.is_constrained(mesh.edge_handle(heh))) {
      heh = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(heh));  // clockwise
    }
    const VertexHandle to = mesh.to_vertex_handle(heh);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (vertices_[i] == from && vertices_[nodes_.next[i]] == to) return static_cast<int>(i);
    }
    throw_touching(delaunay_.uv(from));  // the loops have their inside on the right
  }

  /// A node on the segment from a to b; a's position if there is none.
  Uv node_between(VertexHandle a, VertexHandle b) const {
    const Uv from = delaunay_.uv(a), to = delaunay_.uv(b);
    for (const VertexHandle vh : vertices_) {
      const Uv p = delaunay_.uv(vh), back = from - p, ahead = to - p;
      if (orient2d(from, to, p) == 0 && back.u * ahead.u + back.v * ahead.v < 0) return p;
    }
    return from;
  }

  /// 0 outside and in holes, 1 inside.
  std::vector<char> depth_of_faces() const {
    const PolyMesh& mesh = delaunay_.mesh();
    constexpr char unknown = 2;
    std::vector<char> depth(delaunay_.n_faces(), unknown);
    // The first vertex is a corner of the box.
    const FaceHandle first = *mesh.cvf_begin(VertexHandle(0));
    std::vector<FaceHandle> stack = {first};
    depth[index(first)] = 0;
    while (!stack.empty()) {
      const FaceHandle fh = stack.back();
      stack.pop_back();
      for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
        const FaceHandle next = mesh.face_handle(mesh.opposite_halfedge_handle(heh));
        if (!next.is_valid() || depth[index(next)] != unknown) continue;
        const char here = depth[index(fh)];
        const bool is_crossing = delaunay_.is_constrained(mesh.edge_handle(heh));
        depth[index(next)] = is_crossing ? static_cast<char>(1 - here) : here;
        stack.push_back(next);
      }
    }
    return depth;
  }

  static constexpr int kSeveral = -2;

  const LoopNodes& nodes_;
  Box box_;
  DelaunayMesh delaunay_;
  std::vector<VertexHandle> vertices_;  ///< by node
  bool is_touching_ = false;            ///< some vertex is several nodes
};

/// Refuse what no box can be put around: a kernel in it would not end.
void check_loops(const std::vector<std::vector<Uv>>& loops) {
  Box box;
  for (const auto& loop : loops) {
    for (const Uv p : loop) {
      if (!std::isfinite(p.u) || !std::isfinite(p.v)) {
        throw Error(ErrorCode::Geometry,
                    fmt::format("the boundary is not finite at (u,v) = ({}, {})", p.u, p.v));
      }
      extend(box, p);
    }
    if (loop.size() < 3) {
      throw Error(ErrorCode::Geometry,
                  "the boundary leaves nothing inside: a loop has fewer than "
                  "three nodes");
    }
  }
  if (!(box.lower.u < box.upper.u && box.lower.v < box.upper.v)) {
    throw Error(ErrorCode::Geometry, "the boundary leaves nothing inside");
  }
}

}  // namespace

BoundaryTriangulation triangulate_boundary(const std::vector<std::vector<Uv>>& loops,
                                           const MetricField& field) {
  check_loops(loops);
  const LoopNodes nodes(loops);
  std::vector<Metric> metrics;
  QueryHint hint;
  for (const Uv p : nodes.points) metrics.push_back(field.at(p, hint));
  BoxTriangulation box(nodes, plane_metric(metrics));
  for (std::size_t i = 0; i < nodes.next.size(); ++i) box.constrain(i, nodes.next[i]);
  const auto triangles = box.inside();
  if (triangles.empty()) {
    throw Error(ErrorCode::Geometry, "the boundary leaves nothing inside");
  }
  auto delaunay = std::make_unique<DelaunayMesh>(nodes.points, triangles);
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    delaunay->metric(VertexHandle(static_cast<int>(i))) = metrics[i];
  }
  swap_edges(*delaunay);
  return {std::move(delaunay), hint.answers};
}

}  // namespace surfmesh
