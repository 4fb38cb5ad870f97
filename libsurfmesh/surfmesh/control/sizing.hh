// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// A length in model units, or a share of the diagonal of the model's bounding box.
struct Length {
  double value = 0;
  bool is_relative = false;

  double in_units(double diagonal) const { return is_relative ? value * diagonal : value; }
};

/// What sizes follow from the shape, and the bounds of all sizes.
struct Sizing {
  double curvature = 0.25;      ///< size = factor × radius of curvature; 0 is off
  Length hmin = {0.001, true};  ///< lower clamp of all sizes, above 0
  Length hmax = {0.2, true};    ///< upper clamp of all sizes, at least hmin
  double stretch = 2;           ///< greatest ratio of the two sizes from curvature, at least 1
  double grade = 1.5;           ///< sizes grow by at most ln(grade) per unit of length; 0 is off
};

/// Wanted edge lengths: l_s along the first axis turned by `angle`, l_t across.
struct Size {
  Length along;
  Length across;
  double angle = 0;  ///< radians, from the first tangent axis (along p_u)
};

/// An area source: one size in the whole patch.
struct EverywhereSource {
  int patch = -1;
  Size size;
};

/// A node source: a size at one point of a patch.
struct AtSource {
  int patch = -1;
  Uv at;
  Size size;
};

/// All wishes of the user for sizes besides the curvature.
struct Sources {
  std::vector<EverywhereSource> everywhere;
  std::vector<AtSource> at;
};

}  // namespace surfmesh
