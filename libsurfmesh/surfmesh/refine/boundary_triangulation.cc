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

/// Triangulates all nodes in a box and knows which vertex each one became.
class BoxTriangulation {
 public:
  BoxTriangulation(const std::vector<Uv>& points, const Metric& plane)
      : box_(box_around(points)), delaunay_(box_.lower, box_.upper) {
    const ConstantMetricRule rule{delaunay_.uv_handle(), plane};
    delaunay_.reserve(points.size() + 4);
    vertices_.resize(points.size());
    FaceHandle hint(0);
    for (const int i : spatial_order(points)) {
      const std::size_t before = delaunay_.n_vertices();
      const VertexHandle vh = delaunay_.insert(points[static_cast<std::size_t>(i)], hint, rule);
      if (!vh.is_valid() || delaunay_.n_vertices() == before) {
        throw_touching(points[static_cast<std::size_t>(i)]);
      }
      vertices_[static_cast<std::size_t>(i)] = vh;
      hint = delaunay_.mesh().face_handle(delaunay_.mesh().halfedge_handle(vh));
    }
  }

  void constrain(std::size_t from, std::size_t to) {
    const VertexHandle a = vertices_[from], b = vertices_[to];
    delaunay_.insert_constraint(a, b);
    // A chain of edges passes through a node that is not of this segment.
    if (delaunay_.find_halfedge(a, b).is_valid()) return;
    throw_touching(node_between(a, b));
  }

  /// The triangles at an odd number of segments from the box's rim, as indices of nodes.
  std::vector<std::array<int, 3>> inside() const {
    std::vector<int> node_of(delaunay_.n_vertices(), -1);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      node_of[index(vertices_[i])] = static_cast<int>(i);
    }
    const std::vector<char> depth = depth_of_faces();
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t f = 0; f < delaunay_.n_faces(); ++f) {
      if (depth[f] != 1) continue;
      std::array<int, 3> triangle{};
      std::size_t k = 0;
      for (const VertexHandle vh : delaunay_.mesh().fv_range(FaceHandle(static_cast<int>(f)))) {
        triangle[k++] = node_of[index(vh)];
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

  Box box_;
  DelaunayMesh delaunay_;
  std::vector<VertexHandle> vertices_;
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
  std::vector<Uv> points;
  std::vector<Metric> metrics;
  QueryHint hint;
  for (const auto& loop : loops) {
    for (const Uv p : loop) {
      points.push_back(p);
      metrics.push_back(field.at(p, hint));
    }
  }
  BoxTriangulation box(points, plane_metric(metrics));
  std::size_t first = 0;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      box.constrain(first + i, first + (i + 1) % loop.size());
    }
    first += loop.size();
  }
  const auto triangles = box.inside();
  if (triangles.empty()) {
    throw Error(ErrorCode::Geometry, "the boundary leaves nothing inside");
  }
  auto delaunay = std::make_unique<DelaunayMesh>(points, triangles);
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    delaunay->metric(VertexHandle(static_cast<int>(i))) = metrics[i];
  }
  swap_edges(*delaunay);
  return {std::move(delaunay), hint.answers};
}

}  // namespace surfmesh
