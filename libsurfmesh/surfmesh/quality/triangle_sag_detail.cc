// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/triangle_sag_detail.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "surfmesh/quality/triangle_distance_detail.hh"

namespace surfmesh::detail {
namespace {

/// Steps along a side between samples.
constexpr int kSteps = 6;

std::vector<Weights> make_samples() {
  std::vector<Weights> samples;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps && i + j <= kSteps; ++j) {
      const int k = kSteps - i - j;
      if (k == kSteps) continue;
      samples.push_back({double(i) / kSteps, double(j) / kSteps, double(k) / kSteps});
    }
  }
  const auto spread = [](const Weights& w) { return w[0] * w[0] + w[1] * w[1] + w[2] * w[2]; };
  std::stable_sort(samples.begin(), samples.end(),
                   [&](const Weights& a, const Weights& b) { return spread(a) < spread(b); });
  return samples;
}

}  // namespace

const std::vector<Weights>& sag_samples() {
  static const std::vector<Weights> samples = make_samples();
  return samples;
}

double plane_sag(const Surface& surface, const SurfaceTriangle& triangle) {
  const auto& [a, b, c] = triangle.points;
  const Vec3 normal = (b - a).cross(c - a).stableNormalized();
  double sag = 0;
  for (const Weights& w : sag_samples()) {
    const Uv uv = w[0] * triangle.uvs[0] + w[1] * triangle.uvs[1] + w[2] * triangle.uvs[2];
    const Vec3 on_surface = surface.evaluate(uv, Order::Position).point;
    sag = std::max(sag, std::abs(normal.dot(on_surface - a)));
  }
  return sag;
}

}  // namespace surfmesh::detail
