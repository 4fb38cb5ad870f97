// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// The two lengths of a size, model units.
struct SizeLengths {
  double along = kUnset;   ///< l_s, above 0
  double across = kUnset;  ///< l_t, above 0
};

/// The bounds of all sizes, in model units, and the diagonal that shares refer to. See
/// ResolvedSizing.
struct SizeBounds {
  double hmin = 0;
  double hmax = 0;
  double diagonal = 0;

  double clamp(double length) const;
  SizeTensor clamp(const SizeTensor& size) const;

  /// The lengths of a user's size in model units, not clamped.
  /// Throws   InvalidInput if a length is not positive and finite or is a share above 1, or if the
  ///          angle is not finite
  SizeLengths lengths(const Size& size) const;

  /// The same, clamped.
  SizeLengths clamped(const Size& size) const;

  /// The size tensor of a user's size, not clamped.
  /// Throws   as lengths
  SizeTensor tensor(const Size& size) const;

  /// True if a length of the size is above hmax or below hmin, beyond rounding.
  bool changes(const Size& size) const;

  /// A radius in model units.
  /// Throws   InvalidInput if it is negative, not finite or a share above 1
  double radius(const Length& length) const;
};

}  // namespace surfmesh
