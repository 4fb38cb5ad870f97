// SPDX-License-Identifier: BSD-3-Clause
#include "compare/plane_judge.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "surfmesh/metric/tensor.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh::compare {
namespace {

struct GaussPoint {
  double at;  ///< in [0, 1]
  double weight;
};

/// Exact for polynomials of degree 9.
constexpr std::array<GaussPoint, 5> kGauss{{{0.046910077030668004, 0.11846344252809454},
                                            {0.23076534494715845, 0.23931433524968324},
                                            {0.5, 0.28444444444444444},
                                            {0.7692346550528415, 0.23931433524968324},
                                            {0.953089922969332, 0.11846344252809454}}};

Uv plane_point(const TriangleMesh& mesh, int vertex) {
  const Vec3& point = mesh.points[static_cast<std::size_t>(vertex)];
  return {point.x(), point.y()};
}

using Edge = std::pair<int, int>;

/// Every edge once, the lower vertex first.
std::vector<Edge> edges_of(const TriangleMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const auto& [from, to] : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) {
      edges.emplace_back(std::min(from, to), std::max(from, to));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double metric_length(Uv from, Uv to, const MetricFunction& metric) {
  double length = 0;
  for (const auto& [at, weight] : kGauss) {
    length += weight * std::sqrt(squared_length(metric(lerp(from, to, at)), to - from));
  }
  return length;
}

void judge_edges(const TriangleMesh& mesh, const MetricFunction& metric, Judgement& result) {
  std::vector<double> lengths;
  for (const auto& [from, to] : edges_of(mesh)) {
    lengths.push_back(metric_length(plane_point(mesh, from), plane_point(mesh, to), metric));
  }
  const auto count = static_cast<double>(lengths.size());
  std::size_t units = 0;
  for (const double length : lengths) {
    result.mean += length / count;
    if (length >= kShortestUnit && length <= kLongestUnit) ++units;
  }
  double variance = 0;
  for (const double length : lengths) variance += std::pow(length - result.mean, 2) / count;
  result.stddev = std::sqrt(variance);
  result.unit_fraction = static_cast<double>(units) / count;
}

double total_area(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Uv corner = plane_point(mesh, a);
    area += 0.5 * cross(plane_point(mesh, b) - corner, plane_point(mesh, c) - corner);
  }
  return area;
}

void judge_shapes(const TriangleMesh& mesh, const MetricFunction& metric, Judgement& result) {
  constexpr double kThird = 1.0 / 3.0;
  const double signed_area = total_area(mesh);
  const double sign = signed_area < 0 ? -1 : 1;
  result.area = std::abs(signed_area);
  result.least_quality = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.triangles) {
    const Uv a = plane_point(mesh, triangle[0]), b = plane_point(mesh, triangle[1]),
             c = plane_point(mesh, triangle[2]);
    const double quality = sign * triangle_quality(a, b, c, metric(kThird * (a + b + c)));
    result.least_quality = std::min(result.least_quality, quality);
    result.mean_quality += quality / static_cast<double>(mesh.triangles.size());
  }
}

}  // namespace

Judgement judge_plane(const TriangleMesh& mesh, const MetricFunction& metric) {
  Judgement result;
  result.triangles = mesh.triangles.size();
  judge_edges(mesh, metric, result);
  judge_shapes(mesh, metric, result);
  return result;
}

}  // namespace surfmesh::compare
