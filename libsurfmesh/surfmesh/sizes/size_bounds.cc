// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/size_bounds.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

/// A length that differs from a bound by rounding of its unit (percent) is at the bound.
constexpr double kRounding = 1e-12;

}  // namespace

double SizeBounds::clamp(double length) const { return std::clamp(length, hmin, hmax); }

SizeTensor SizeBounds::clamp(const SizeTensor& size) const { return clamp_sizes(size, hmin, hmax); }

SizeLengths SizeBounds::lengths(const Size& size) const {
  const SizeLengths lengths{size.along.in_units(diagonal), size.across.in_units(diagonal)};
  const auto [along, across] = lengths;
  if (!(along > 0 && across > 0 && size.along.is_legal() && size.across.is_legal())) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("a size of [{}, {}] is not positive and finite, or a share above 100%",
                            to_text(size.along), to_text(size.across)));
  }
  if (!std::isfinite(size.angle)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("the angle {} of a size is not finite", size.angle));
  }
  return lengths;
}

SizeLengths SizeBounds::clamped(const Size& size) const {
  const SizeLengths raw = lengths(size);
  return {clamp(raw.along), clamp(raw.across)};
}

SizeTensor SizeBounds::tensor(const Size& size) const {
  const SizeLengths raw = lengths(size);
  return size_tensor(raw.along, raw.across, size.angle);
}

bool SizeBounds::changes(const Size& size) const {
  const SizeLengths raw = lengths(size);
  const double least = std::min(raw.along, raw.across), largest = std::max(raw.along, raw.across);
  return least < (1 - kRounding) * hmin || largest > (1 + kRounding) * hmax;
}

double SizeBounds::radius(const Length& length) const {
  const double radius = length.in_units(diagonal);
  if (!length.is_legal()) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("a radius of {} is negative, not finite, or a share above 100%",
                            to_text(length)));
  }
  return radius;
}

}  // namespace surfmesh
