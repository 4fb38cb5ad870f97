// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/triangle_sag.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

/// The middles of the sides, and points inside at which the fit to them is tested; all are samples.
constexpr std::array<Weights, 3> kMiddles = {{{0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};
constexpr std::array<Weights, 4> kTests = {{{1.0 / 3, 1.0 / 3, 1.0 / 3},
                                            {2.0 / 3, 1.0 / 6, 1.0 / 6},
                                            {1.0 / 6, 2.0 / 3, 1.0 / 6},
                                            {1.0 / 6, 1.0 / 6, 2.0 / 3}}};

std::vector<Weights> make_further_samples() {
  std::vector<Weights> samples = sag_samples();
  const auto is_estimated = [](const Weights& w) {
    return std::find(kMiddles.begin(), kMiddles.end(), w) != kMiddles.end() ||
           std::find(kTests.begin(), kTests.end(), w) != kTests.end();
  };
  samples.erase(std::remove_if(samples.begin(), samples.end(), is_estimated), samples.end());
  return samples;
}

/// The samples that an estimate does not take.
const std::vector<Weights>& further_samples() {
  static const std::vector<Weights> samples = make_further_samples();
  return samples;
}

/// Misses elsewhere are up to so many times those at the tests.
constexpr double kErrorPerMiss = 2;

/// Share of the least height of a triangle that the middle of a side may lie aside, above which
/// nothing is known.
constexpr double kMostAside = 0.3;

/// The polynomial of second order that is 0 at the corners of a triangle, by its values at the
/// middles of the sides: d = 4 (a w0 w1 + b w1 w2 + c w2 w0).
struct Bulge {
  double a, b, c;

  double at(const Weights& w) const {
    return 4 * (a * w[0] * w[1] + b * w[1] * w[2] + c * w[2] * w[0]);
  }

  /// The greatest absolute value on the triangle: on a side, or where the gradient is 0.
  double greatest() const {
    const double on_sides = std::max({std::abs(a), std::abs(b), std::abs(c)});
    const Weights w = {b * (a + c - b), c * (a + b - c), a * (b + c - a)};
    const double sum = w[0] + w[1] + w[2];
    const bool is_inside = w[0] * sum > 0 && w[1] * sum > 0 && w[2] * sum > 0;
    return is_inside ? std::max(on_sides, std::abs(4 * a * b * c / sum)) : on_sides;
  }
};

/// The distance of the surface from the plane of a triangle, at the parameters of a point in it.
class PlaneDistance {
 public:
  PlaneDistance(const Surface& surface, const SurfaceTriangle& triangle)
      : surface_(surface), triangle_(triangle) {
    const auto& [a, b, c] = triangle.points;
    normal_ = (b - a).cross(c - a).stableNormalized();
  }

  /// From the point of the triangle to that of the surface.
  Vec3 offset(const Weights& w) const {
    const auto& [points, uvs] = triangle_;
    const Uv uv = w[0] * uvs[0] + w[1] * uvs[1] + w[2] * uvs[2];
    const Vec3 on_triangle = w[0] * points[0] + w[1] * points[1] + w[2] * points[2];
    return surface_.evaluate(uv, Order::Position).point - on_triangle;
  }

  double along_normal(const Vec3& offset) const { return normal_.dot(offset); }

  double operator()(const Weights& w) const { return std::abs(along_normal(offset(w))); }

 private:
  const Surface& surface_;
  const SurfaceTriangle& triangle_;
  Vec3 normal_;
};

double least_height(const SurfaceTriangle& triangle) {
  const auto& [a, b, c] = triangle.points;
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

}  // namespace

const std::vector<Weights>& sag_samples() {
  static const std::vector<Weights> samples = make_samples();
  return samples;
}

double plane_sag(const Surface& surface, const SurfaceTriangle& triangle,
                 const PlaneSagBounds& bounds) {
  const SagEstimate estimate = estimate_plane_sag(surface, triangle, bounds.ends_above);
  SagSample greatest = estimate.greatest;
  if (greatest.distance > bounds.ends_above) return greatest.distance;
  if (estimate.sag + estimate.error < bounds.searched_from) return estimate.sag;
  const PlaneDistance distance(surface, triangle);
  for (const Weights& w : further_samples()) {
    const double there = distance(w);
    if (there > greatest.distance) greatest = {w, there};
    if (there > bounds.ends_above) return there;
  }
  if (greatest.distance > kSearchedShare * bounds.searched_from) {
    greatest = search_sag(greatest, distance);
  }
  return greatest.distance;
}

SagEstimate estimate_plane_sag(const Surface& surface, const SurfaceTriangle& triangle,
                               double ends_above) {
  const PlaneDistance distance(surface, triangle);
  SagEstimate estimate;
  estimate.error = std::numeric_limits<double>::infinity();
  double aside = 0;
  const auto sample = [&](const Weights& w) {
    const Vec3 offset = distance.offset(w);
    const double there = distance.along_normal(offset);
    if (std::abs(there) > estimate.greatest.distance) estimate.greatest = {w, std::abs(there)};
    return std::pair(there, offset.squaredNorm() - there * there);
  };
  std::array<double, 4> tests;
  for (std::size_t k = 0; k < tests.size(); ++k) {
    tests[k] = sample(kTests[k]).first;
    if (estimate.greatest.distance > ends_above) return estimate;
  }
  std::array<double, 3> middles;
  for (std::size_t k = 0; k < middles.size(); ++k) {
    const auto [there, squared_aside] = sample(kMiddles[k]);
    middles[k] = there;
    aside = std::max(aside, squared_aside);
    if (estimate.greatest.distance > ends_above) return estimate;
  }
  const Bulge bulge{middles[0], middles[1], middles[2]};
  estimate.sag = bulge.greatest();
  estimate.aside = std::sqrt(std::max(0.0, aside));
  if (!(estimate.aside < kMostAside * least_height(triangle))) return estimate;
  estimate.error = 0;
  for (std::size_t k = 0; k < tests.size(); ++k) {
    const double miss = std::abs(tests[k] - bulge.at(kTests[k]));
    estimate.error = std::max(estimate.error, kErrorPerMiss * miss);
  }
  return estimate;
}

}  // namespace surfmesh::detail
