// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vertex_metric.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/shared_vertices.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/result_corners.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {
namespace {

/// The sum of the metrics of some corners.
struct MetricSum {
  SpaceMetric sum = {};
  int count = 0;

  void add(const MetricSum& other) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += other.sum[i];
    count += other.count;
  }
};

/// Rows and columns of the entries of a metric in space.
constexpr std::array<std::array<int, 2>, 6> kEntries = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

/// Add `factor` times (abᵀ + baᵀ)/2.
void add_product(double factor, const Vec3& a, const Vec3& b, SpaceMetric& metric) {
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    const auto [row, column] = kEntries[i];
    metric[i] += factor * 0.5 * (a[row] * b[column] + b[row] * a[column]);
  }
}

/// With the steps e₁, e₂ along the sides at the corner as columns of E, their products G = EᵀE and
/// their metric products B: J⁺ᵀ M_uv J⁺ = E G⁻¹BG⁻¹ Eᵀ.
void add_corner(const detail::ResultCorners& values, HalfedgeHandle corner, MetricSum& sum) {
  const PolyMesh& mesh = values.mesh;
  const HalfedgeHandle next = mesh.next_halfedge_handle(corner);
  const HalfedgeHandle before = mesh.prev_halfedge_handle(corner);
  const Vec3 here = detail::point_of(mesh, corner);
  const Vec3 e1 = detail::point_of(mesh, next) - here, e2 = detail::point_of(mesh, before) - here;
  const Uv uv1 = values.uv(next) - values.uv(corner), uv2 = values.uv(before) - values.uv(corner);
  const Metric& m = values.metric(corner);
  const double g11 = e1.squaredNorm(), g12 = e1.dot(e2), g22 = e2.squaredNorm();
  const double b11 = squared_length(m, uv1), b12 = inner_product(m, uv1, uv2),
               b22 = squared_length(m, uv2);
  const Vec3 normal = e1.cross(e2);
  const double g = normal.squaredNorm(), b = b11 * b22 - b12 * b12;
  if (!(g > 0) || !(b > 0)) return;
  // Rows of G⁻¹B times G, then again G⁻¹ from the right.
  const double p11 = (g22 * b11 - g12 * b12) / g, p12 = (g22 * b12 - g12 * b22) / g;
  const double p21 = (g11 * b12 - g12 * b11) / g, p22 = (g11 * b22 - g12 * b12) / g;
  const double c11 = (p11 * g22 - p12 * g12) / g, c12 = (p12 * g11 - p11 * g12) / g;
  const double c22 = (p22 * g11 - p21 * g12) / g;
  SpaceMetric metric = {};
  add_product(c11, e1, e1, metric);
  add_product(2 * c12, e1, e2, metric);
  add_product(c22, e2, e2, metric);
  add_product(std::sqrt(b / g) / g, normal, normal, metric);
  if (!std::all_of(metric.begin(), metric.end(), [](double x) { return std::isfinite(x); })) return;
  sum.add({metric, 1});
}

/// The sums of all vertices, those of copies added to the first.
std::vector<MetricSum> metric_sums(const PolyMesh& mesh) {
  const detail::ResultCorners values(mesh);
  const SharedVertices vertices(mesh);
  std::vector<MetricSum> sums(mesh.n_vertices());
  share_ranges(sums.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) {
      for (const HalfedgeHandle heh : mesh.vih_range(VertexHandle(static_cast<int>(v)))) {
        if (!mesh.is_boundary(heh)) add_corner(values, heh, sums[v]);
      }
    }
  });
  if (vertices.count() == sums.size()) return sums;
  std::vector<MetricSum> result(vertices.count());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    result[static_cast<std::size_t>(vertices.number(static_cast<int>(v)))].add(sums[v]);
  }
  return result;
}

/// The metric that asks for the geometric mean of all sizes in every direction.
SpaceMetric mean_metric(const std::vector<SpaceMetric>& metrics, std::size_t known) {
  if (known == 0) {
    throw Error(ErrorCode::Geometry,
                "no corner of the mesh has a metric that is positive definite on its face");
  }
  double sum = 0;
  for (const SpaceMetric& metric : metrics) {
    if (!std::isnan(metric[0])) sum += std::log(size_of(metric));
  }
  const double size = std::exp(sum / static_cast<double>(known));
  const double entry = 1 / (size * size);
  return {entry, entry, entry, 0, 0, 0};
}

}  // namespace

bool has_vertex_metrics(const PolyMesh& mesh) { return has_parameters(mesh) && has_metric(mesh); }

std::vector<SpaceMetric> vertex_metrics(const PolyMesh& mesh) {
  const std::vector<MetricSum> sums = metric_sums(mesh);
  std::vector<SpaceMetric> metrics(sums.size());
  std::size_t known = 0;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    metrics[v].fill(kUnset);
    if (sums[v].count == 0) continue;
    ++known;
    for (std::size_t i = 0; i < metrics[v].size(); ++i) {
      metrics[v][i] = sums[v].sum[i] / sums[v].count;
    }
  }
  if (known == metrics.size()) return metrics;
  const SpaceMetric mean = mean_metric(metrics, known);
  for (SpaceMetric& metric : metrics) {
    if (std::isnan(metric[0])) metric = mean;
  }
  return metrics;
}

/// The determinant is λ₁λ₂√(λ₁λ₂), and the size (λ₁λ₂)^(-1/4).
double size_of(const SpaceMetric& metric) {
  const auto& [xx, yy, zz, xy, yz, xz] = metric;
  const double determinant =
      xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  return 1 / std::sqrt(std::cbrt(determinant));
}

}  // namespace surfmesh
