// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "support/metric_fields.hh"
#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/delaunay/metric_swaps.hh"
#include "surfmesh/refine/boundary_triangulation.hh"

/// Meshes of plane domains and their measures.
namespace surfmesh::testing {

inline std::vector<Uv> random_points(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Uv> points;
  for (int i = 0; i < count; ++i) {
    const double u = uniform(random);
    points.push_back({u, uniform(random)});
  }
  return points;
}

/// Of triangles that are accepted: the square of their metric circumradius.
inline constexpr double kAcceptedSize = 0.5;

inline const std::vector<Uv> kUnitSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// `count` points on a circle, counter-clockwise; clockwise for a negative count.
inline std::vector<Uv> circle(Uv centre, double radius, int count) {
  std::vector<Uv> points;
  for (int i = 0; i < std::abs(count); ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back(centre + Uv{radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

/// Half the sum of cross products: positive for a counter-clockwise polygon.
inline double polygon_area(const std::vector<Uv>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum += 0.5 * cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  }
  return sum;
}

/// The polygon with nodes on its sides at equal metric lengths near 1.
inline std::vector<Uv> with_nodes(const std::vector<Uv>& polygon, const MetricField& field) {
  std::vector<Uv> nodes;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SegmentCurve side(polygon[i], polygon[(i + 1) % polygon.size()]);
    const MetricArc arc(side, field);
    const int count = std::max(1, static_cast<int>(std::lround(arc.length())));
    for (int k = 0; k < count; ++k) {
      nodes.push_back(side.evaluate(k == 0 ? 0 : arc.parameter(k * arc.length() / count)));
    }
  }
  return nodes;
}

/// The unit square with its boundary nodes and no others.
inline std::unique_ptr<DelaunayMesh> empty_square(const MetricField& field) {
  return triangulate_boundary({with_nodes(kUnitSquare, field)}, field).delaunay;
}

/// Sum of the areas in (u,v); 0 if a triangle is not counter-clockwise, by exact orientation.
inline double valid_area(const DelaunayMesh& delaunay) {
  long double sum = 0;  // of a hundred thousand triangles, to 1e-12
  for (std::size_t i = 0; i < delaunay.n_faces(); ++i) {
    const auto t = corners(delaunay.mesh(), FaceHandle(static_cast<int>(i)), delaunay.uv_handle());
    if (orient2d(t[0], t[1], t[2]) <= 0) return 0;
    sum += 0.5 * cross(t[1] - t[0], t[2] - t[0]);
  }
  return static_cast<double>(sum);
}

inline double least_quality(const DelaunayMesh& delaunay) {
  double least = 1;
  for (std::size_t i = 0; i < delaunay.n_faces(); ++i) {
    least = std::min(least, quality(delaunay, FaceHandle(static_cast<int>(i))));
  }
  return least;
}

inline double mean_quality(const DelaunayMesh& delaunay) {
  double sum = 0;
  for (std::size_t i = 0; i < delaunay.n_faces(); ++i) {
    sum += quality(delaunay, FaceHandle(static_cast<int>(i)));
  }
  return sum / static_cast<double>(delaunay.n_faces());
}

/// Metric lengths of all edges.
struct EdgeLengths {
  double mean = 0;
  double deviation = 0;      ///< σ
  double unit_fraction = 0;  ///< share in [1/√2, √2]
};

inline EdgeLengths edge_lengths(const DelaunayMesh& delaunay) {
  const PolyMesh& mesh = delaunay.mesh();
  double sum = 0, squares = 0, units = 0;
  const auto count = static_cast<double>(delaunay.n_edges());
  for (std::size_t i = 0; i < delaunay.n_edges(); ++i) {
    const HalfedgeHandle heh = mesh.halfedge_handle(EdgeHandle(static_cast<int>(i)), 0);
    const MetricCorner a = corner(delaunay, mesh.from_vertex_handle(heh));
    const MetricCorner b = corner(delaunay, mesh.to_vertex_handle(heh));
    const double length = edge_length(std::sqrt(squared_length(a.metric, b.uv - a.uv)),
                                      std::sqrt(squared_length(b.metric, b.uv - a.uv)));
    sum += length;
    squares += length * length;
    if (length * length >= 0.5 && length * length <= 2) units += 1;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean)), units / count};
}

/// Positions of all vertices, in their order.
inline std::vector<Uv> positions(const DelaunayMesh& delaunay) {
  std::vector<Uv> result;
  for (std::size_t i = 0; i < delaunay.n_vertices(); ++i) {
    result.push_back(delaunay.uv(VertexHandle(static_cast<int>(i))));
  }
  return result;
}

/// Vertices of all triangles, in their order.
inline std::vector<int> connectivity(const DelaunayMesh& delaunay) {
  std::vector<int> result;
  for (std::size_t i = 0; i < delaunay.n_faces(); ++i) {
    for (const VertexHandle vh : delaunay.mesh().fv_range(FaceHandle(static_cast<int>(i)))) {
      result.push_back(vh.idx());
    }
  }
  return result;
}

/// Number of segments between following nodes of the loop that are constrained edges. `first` is
/// the vertex of its first node.
inline std::size_t count_constrained(const DelaunayMesh& delaunay, std::size_t first,
                                     std::size_t count) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const VertexHandle a(static_cast<int>(first + i));
    const VertexHandle b(static_cast<int>(first + (i + 1) % count));
    const HalfedgeHandle heh = delaunay.find_halfedge(a, b);
    if (heh.is_valid() && delaunay.is_constrained(delaunay.mesh().edge_handle(heh))) ++found;
  }
  return found;
}

/// All faces but the spare ones.
inline std::vector<FaceHandle> faces_of(const DelaunayMesh& delaunay) {
  std::vector<FaceHandle> faces;
  for (std::size_t f = 0; f < delaunay.n_faces(); ++f) faces.emplace_back(static_cast<int>(f));
  return faces;
}

}  // namespace surfmesh::testing
