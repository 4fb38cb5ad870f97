// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/triangle_sag.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "surfmesh/quality/triangle_distance.hh"

namespace surfmesh::detail {
namespace {

std::vector<Weights> make_samples() {
  std::vector<Weights> samples;
  for (int i = 0; i < kSampleSteps; ++i) {
    for (int j = 0; j < kSampleSteps && i + j <= kSampleSteps; ++j) {
      const int k = kSampleSteps - i - j;
      if (k == kSampleSteps) continue;
      samples.push_back(
          {double(i) / kSampleSteps, double(j) / kSampleSteps, double(k) / kSampleSteps});
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

double plane_sag(const Surface& surface, const SurfaceTriangle& triangle, double searched_from) {
  const auto& [a, b, c] = triangle.points;
  const Vec3 normal = (b - a).cross(c - a).stableNormalized();
  const auto distance = [&](const Weights& w) {
    const Uv uv = w[0] * triangle.uvs[0] + w[1] * triangle.uvs[1] + w[2] * triangle.uvs[2];
    return std::abs(normal.dot(surface.evaluate(uv, Order::Position).point - a));
  };
  SagSample greatest;
  for (const Weights& w : sag_samples()) {
    const double there = distance(w);
    if (there > greatest.distance) greatest = {w, there};
  }
  if (greatest.distance > searched_from) greatest = search_sag(greatest, distance);
  return greatest.distance;
}

}  // namespace surfmesh::detail
