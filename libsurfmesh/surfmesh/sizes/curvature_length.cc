// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/curvature_length.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/core/option_range.hh"

namespace surfmesh {
namespace {

/// Shares of the sag for which sizes are made. 0.75 is what a perfect triangle over a sphere takes.
constexpr double kSurfaceShare = 0.7;
/// The fan around an extraordinary vertex then has 0.12 to 0.70 of the sag.
constexpr double kVertexShare = 0.5;
/// Segments lie at equal arcs and do not scatter.
constexpr double kCurveShare = 0.9;

}  // namespace

CurvatureLength::CurvatureLength(const Sizing& sizing, double diagonal)
    : factor_(sizing.curvature_factor()), sag_(sizing.sag ? sizing.sag->in_units(diagonal) : 0) {
  check_option(ranges::kCurvature, factor_);
  check_option(ranges::kSag, sizing.sag);
}

double CurvatureLength::of_surface(double curvature) const {
  return shorter(curvature, kSurfaceShare);
}

double CurvatureLength::around_vertex(double curvature) const {
  return shorter(curvature, kVertexShare);
}

double CurvatureLength::of_curve(double curvature) const { return shorter(curvature, kCurveShare); }

double CurvatureLength::shorter(double curvature, double share_of_sag) const {
  const double k = std::abs(curvature);
  const double by_factor = factor_ > 0 ? factor_ / k : INFINITY;
  const double by_sag = sag_ > 0 ? std::sqrt(8 * share_of_sag * sag_ / k) : INFINITY;
  return std::min(by_factor, by_sag);
}

}  // namespace surfmesh
