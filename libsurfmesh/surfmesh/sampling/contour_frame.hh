// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/first_form.hh"

namespace surfmesh::detail {

/// The direction of a contour in the tangent frame of one of its patches.
struct ContourFrame {
  double cos = 1;  ///< of the angle from the first tangent axis to the contour's direction
  double sin = 0;
};

/// Step of t for the direction of a contour: its error is of second order in the step.
inline constexpr double kTangentStep = 1e-4;

/// The direction of a curve in the tangent frame at a point of it; nothing where there is none.
inline std::optional<ContourFrame> contour_frame(const Curve& curve, double t,
                                                 const FirstFormFactor& form) {
  if (!is_regular(form)) return std::nullopt;
  const Uv step = curve.evaluate(std::min(1.0, t + kTangentStep)) -
                  curve.evaluate(std::max(0.0, t - kTangentStep));
  const double x = form.l11 * step.u + form.l21 * step.v, y = form.l22 * step.v;
  const double length = std::hypot(x, y);
  if (!(length > 0)) return std::nullopt;
  return ContourFrame{x / length, y / length};
}

/// H in the frame of the contour's direction and the direction to its left in the parameters.
inline SizeTensor to_contour(const SizeTensor& h, const ContourFrame& frame) {
  const double c = frame.cos, s = frame.sin;
  return {c * c * h.h11 + 2 * c * s * h.h12 + s * s * h.h22,
          c * s * (h.h22 - h.h11) + (c * c - s * s) * h.h12,
          s * s * h.h11 - 2 * c * s * h.h12 + c * c * h.h22};
}

inline SizeTensor from_contour(const SizeTensor& h, const ContourFrame& frame) {
  return to_contour(h, {frame.cos, -frame.sin});
}

/// Sizes in the contour's frame of one patch, in that of another, unfolded around their contour.
/// Where both lie on the same side of its direction, their left sides point away from each other.
inline SizeTensor unfolded(const SizeTensor& along, bool is_mirrored) {
  return is_mirrored ? SizeTensor{along.h11, -along.h12, along.h22} : along;
}

}  // namespace surfmesh::detail
