// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "surfmesh/geometry/surface.hh"

namespace surfmesh::detail {

/// A triangle in space, whose corners have parameters on a surface.
struct SurfaceTriangle {
  std::array<Vec3, 3> points;
  std::array<Uv, 3> uvs;
};

using Weights = std::array<double, 3>;

/// Cosine of the angle between two triangles up to which the bend between them is sharp: beyond it
/// their planes tell how far their edge is from the surface, to within 4 %.
inline constexpr double kSharpCosine = 0.87;

/// Share of a distance from the surface by which it may be too great: far less than samples miss.
inline constexpr double kSagAccuracy = 1e-5;

/// The 25 points at which a triangle is compared with its surface, those nearest to the middle
/// first, where the distance is greatest.
const std::vector<Weights>& sag_samples();

/// Steps along a side between samples, and the shares of it with which the search for a greater
/// distance begins and ends.
inline constexpr int kSampleSteps = 6;
inline constexpr double kFirstSearchStep = 0.5 / kSampleSteps;
inline constexpr double kLastSearchStep = 0.125 / kSampleSteps;

/// Share of the distance up to which nothing is sought from which the search goes on from samples:
/// they may miss a narrow bend.
inline constexpr double kSearchedShare = 0.5;

/// A point of a triangle and the distance there.
struct SagSample {
  Weights weights{};
  double distance = 0;
};

/// Climb from the sample with the greatest distance to one with a greater one: over a rounded
/// crease, which is much narrower than the triangle, all samples may miss it.
///
/// `distance(weights)` is asked about 20 times.
template <class Distance>
SagSample search_sag(SagSample sample, Distance distance);

/// Where a search for the greatest distance may be spared.
struct PlaneSagBounds {
  /// Below this an estimate is enough.
  double searched_from = 0;
  /// Above this any distance is enough.
  double ends_above = std::numeric_limits<double>::infinity();
};

/// The greatest distance of the surface from the plane of the triangle, over the samples, and
/// around the greatest one if that is above half of `searched_from`.
///
/// Unlike the distance from the triangle it does not grow where parameters run unevenly and a
/// sample lies beyond a side, over the next triangle.
double plane_sag(const Surface& surface, const SurfaceTriangle& triangle,
                 const PlaneSagBounds& bounds = {});

/// About the greatest distance of the surface from the plane of the triangle, and how far off it
/// may be.
struct SagEstimate {
  double sag = 0;
  double error = 0;  ///< infinite where nothing is known
  /// How far along the plane the surface is from the middle of a side at the same parameters.
  double aside = 0;
  SagSample greatest;  ///< of those that the estimate took
};

/// Fit a quadratic polynomial, which a surface of even curvature follows, to the distances at the
/// middles of the sides. Its greatest value is the estimate; what it misses inside gives the error.
/// Nothing is known where the parameters are so uneven that the middle of a side lies far aside, or
/// where the estimate ended at a distance above `ends_above`.
///
/// Cost     at most seven surface evaluations
SagEstimate estimate_plane_sag(const Surface& surface, const SurfaceTriangle& triangle,
                               double ends_above = std::numeric_limits<double>::infinity());

template <class Distance>
SagSample search_sag(SagSample sample, Distance distance) {
  for (double step = kFirstSearchStep; step >= kLastSearchStep;) {
    const SagSample before = sample;
    for (std::size_t from = 0; from < 3; ++from) {
      for (std::size_t to = 0; to < 3; ++to) {
        if (from == to || before.weights[from] < step) continue;
        Weights weights = before.weights;
        weights[from] -= step;
        weights[to] += step;
        const double there = distance(weights);
        if (there > sample.distance) sample = {weights, there};
      }
    }
    if (sample.distance <= before.distance) step /= 2;
  }
  return sample;
}

}  // namespace surfmesh::detail
