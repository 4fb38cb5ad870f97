// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh::detail {

/// The direction of a contour in the tangent frame of one of its patches.
struct ContourFrame {
  double cos = 1;  ///< of the angle from the first tangent axis to the contour's direction
  double sin = 0;
};

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
