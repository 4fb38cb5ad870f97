// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/segment_shape.hh"

#include <algorithm>

#include "surfmesh/geometry/segment_distance.hh"

namespace surfmesh {
namespace {

/// Samples of a segment, both ends included, less one.
constexpr int kSagSteps = 4;

/// Greatest distance of a segment's line in the parameters from contour and chord, in its length.
constexpr double kMostDetour = 0.2;

}  // namespace

double segment_sag(const Surface& surface, const Curve& curve, double from, double to) {
  const auto at = [&](double t) {
    return surface.evaluate(curve.evaluate(t), Order::Position).point;
  };
  const Vec3 a = at(from), b = at(to);
  double sag = 0;
  for (int i = 1; i < kSagSteps; ++i) {
    sag = std::max(sag, segment_distance(at(from + (to - from) * i / kSagSteps), a, b));
  }
  return sag;
}

bool makes_detour(const Model& model, const ContourUse& use, double from, double to) {
  const Surface& surface = model.surface(use);
  const auto point = [&](Uv uv) { return surface.evaluate(uv, Order::Position).point; };
  const Uv uv_a = use.curve->evaluate(from), uv_b = use.curve->evaluate(to);
  const Vec3 a = point(uv_a), b = point(uv_b);
  const Vec3 middle = model.point(use, 0.5 * (from + to));
  const Vec3 line = point(lerp(uv_a, uv_b, 0.5));
  const double distance = std::min({segment_distance(line, a, b), segment_distance(line, a, middle),
                                    segment_distance(line, middle, b)});
  return distance > kMostDetour * (b - a).norm();
}

}  // namespace surfmesh
