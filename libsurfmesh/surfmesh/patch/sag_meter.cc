// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/sag_meter.hh"

#include <Eigen/Geometry>
#include <algorithm>

#include "surfmesh/quality/surface_search.hh"
#include "surfmesh/quality/triangle_distance.hh"
#include "surfmesh/quality/triangle_sag.hh"

namespace surfmesh::detail {
namespace {

/// Triangles whose estimate is below this share of the aim, error included, are not sampled.
constexpr double kSampledShare = 0.95;

/// True if the triangle has the edge from one of these parameters to the other.
bool has_edge(const CornerTriangle& t, Uv from, Uv to) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (t[k].uv == from && t[(k + 1) % 3].uv == to) return true;
  }
  return false;
}

/// Of the angle between the normals of two triangles.
double cosine(const CornerTriangle& s, const CornerTriangle& t) {
  const auto normal = [](const CornerTriangle& triangle) {
    const auto& [a, b, c] = triangle;
    return (b.point - a.point).cross(c.point - a.point).stableNormalized().eval();
  };
  return normal(s).dot(normal(t));
}

double distance(const Vec3& point, const CornerTriangle& t) {
  return triangle_distance(point, {t[0].point, t[1].point, t[2].point}).distance;
}

SurfaceTriangle surface_triangle(const CornerTriangle& t) {
  return {{t[0].point, t[1].point, t[2].point}, {t[0].uv, t[1].uv, t[2].uv}};
}

}  // namespace

double SagMeter::sag_of(const CornerTriangle& t) const {
  return plane_sag(surface_, surface_triangle(t), {.searched_from = kSampledShare * aim_});
}

double SagMeter::sag_of(const CornerTriangles& triangles) const {
  double sag = ridge_sag(triangles, kSharpCosine);
  for (const CornerTriangle& t : triangles) sag = std::max(sag, sag_of(t));
  return sag;
}

bool SagMeter::holds(const CornerTriangle& t) const {
  return plane_sag(surface_, surface_triangle(t),
                   {.searched_from = kSampledShare * aim_, .ends_above = aim_}) <= aim_;
}

bool SagMeter::holds(const CornerTriangles& triangles) const {
  return std::all_of(triangles.begin(), triangles.end(),
                     [this](const CornerTriangle& t) { return holds(t); }) &&
         ridge_sag(triangles, kSharpCosine) <= aim_;
}

double SagMeter::ridge_sag(const CornerTriangles& triangles, double most_cosine) const {
  double sag = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const PatchCorner &a = triangles[i][k], &b = triangles[i][(k + 1) % 3];
      for (std::size_t j = 0; j < i; ++j) {
        if (has_edge(triangles[j], b.uv, a.uv) &&
            cosine(triangles[i], triangles[j]) <= most_cosine) {
          sag = std::max(sag, ridge_sag(a, b, triangles[i], triangles[j]));
        }
      }
    }
  }
  return sag;
}

double SagMeter::ridge_sag(const PatchCorner& a, const PatchCorner& b, const CornerTriangle& left,
                           const CornerTriangle& right) const {
  const Uv middle = lerp(a.uv, b.uv, 0.5);
  const Vec3 on_surface = surface_.evaluate(middle, Order::Position).point;
  const Vec3 on_edge = 0.5 * (a.point + b.point);
  const double from_mesh = std::min(distance(on_surface, left), distance(on_surface, right));
  if ((on_surface - on_edge).norm() <= aim_) return from_mesh;
  return std::max(from_mesh,
                  find_near_point(surface_, on_edge, middle, {0, kSagAccuracy}).distance);
}

}  // namespace surfmesh::detail
