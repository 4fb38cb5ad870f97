// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/placed_size.hh"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surfmesh/geometry/curve_polyline.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// The first length along the direction (c,s) of the frame, not normalised.
SizeTensor directed(const SizeLengths& lengths, double c, double s) {
  const double squared = c * c + s * s;
  if (squared == 0) return isotropic(std::min(lengths.along, lengths.across));
  const double more = (lengths.along - lengths.across) / squared;
  return {lengths.across + more * c * c, more * c * s, lengths.across + more * s * s};
}

SizeTensor size_on_segment(const PlacedSize& placed, double share, const TangentFrame& frame) {
  const SizeLengths& a = placed.at_from;
  const SizeLengths& b = placed.at_to;
  const SizeLengths lengths{(1 - share) * a.along + share * b.along,
                            (1 - share) * a.across + share * b.across};
  if (lengths.along == lengths.across) return isotropic(lengths.along);
  if (!placed.follows_segment) return size_tensor(lengths.along, lengths.across, placed.angle);
  const Vec3 direction = placed.to - placed.from;
  return directed(lengths, direction.dot(frame.first), direction.dot(frame.second));
}

/// Metric length of a step in space per its length.
double length_per_unit(const SizeTensor& size, const Vec3& unit, const TangentFrame& frame) {
  const double x = unit.dot(frame.first), y = unit.dot(frame.second);
  const double scale = 1 / determinant(size);
  const double a = scale * (size.h22 * x - size.h12 * y);
  const double b = scale * (size.h11 * y - size.h12 * x);
  const double normal = std::sqrt(std::max(0.0, 1 - x * x - y * y)) / principal_sizes(size).l_s;
  return std::sqrt(a * a + b * b + normal * normal);
}

}  // namespace

TangentFrame tangent_frame(const Jet& jet) {
  const Vec3& main = jet.du.squaredNorm() > 0 ? jet.du : jet.dv;
  if (main.squaredNorm() == 0) return {jet.point, Vec3::UnitX(), Vec3::UnitY()};
  const Vec3 first = main.normalized();
  const Vec3 across = jet.dv - jet.dv.dot(first) * first;
  if (!is_regular(first_form_factor(jet.du, jet.dv))) {
    return {jet.point, first, first.unitOrthogonal()};
  }
  return {jet.point, first, across.normalized()};
}

std::optional<SizeTensor> size_around(const PlacedSize& placed, const TangentFrame& frame,
                                      double growth) {
  const double share = placed.is_box ? 0 : nearest_share(placed.from, placed.to, frame.point);
  const Vec3 nearest = placed.is_box ? Vec3(frame.point.cwiseMax(placed.from).cwiseMin(placed.to))
                                     : Vec3((1 - share) * placed.from + share * placed.to);
  const Vec3 step = frame.point - nearest;
  const double distance = step.norm();
  const double rest = distance - reach(placed);
  if (rest > 0 && std::isinf(growth)) return std::nullopt;
  SizeTensor size = size_on_segment(placed, share, frame);
  if (distance <= placed.radius) return size;
  if (placed.outer) {
    const PlacedSize::OuterSize& outer = *placed.outer;
    const SizeTensor far = size_tensor(outer.lengths.along, outer.lengths.across, outer.angle);
    size = rest >= 0 ? far : lerp(size, far, (distance - placed.radius) / outer.radius);
  }
  if (rest <= 0) return size;
  if (placed.follows_segment) {
    return SizeTensor{size.h11 + growth * rest, size.h12, size.h22 + growth * rest};
  }
  return scaled(size, 1 + growth * rest * length_per_unit(size, step / distance, frame));
}

double growth_of_grade(double grade) {
  return grade > 0 ? std::log(grade) : std::numeric_limits<double>::infinity();
}

double least_length(const PlacedSize& placed) {
  double least = std::min(
      {placed.at_from.along, placed.at_from.across, placed.at_to.along, placed.at_to.across});
  if (placed.outer) {
    least = std::min({least, placed.outer->lengths.along, placed.outer->lengths.across});
  }
  return least;
}

double least_ratio(const PlacedSize& placed) {
  const auto ratio = [](const SizeLengths& s) {
    return std::min(s.along / s.across, s.across / s.along);
  };
  if (placed.follows_segment) return 1;
  if (placed.outer) return ratio(placed.outer->lengths);
  return std::min(ratio(placed.at_from), ratio(placed.at_to));
}

}  // namespace surfmesh
