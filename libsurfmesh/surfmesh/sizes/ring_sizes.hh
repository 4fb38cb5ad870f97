// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/size_bounds.hh"

namespace surfmesh {

/// The lengths of the closed lines around a patch that meets itself at a seam.
struct Ring {
  bool is_along_u = true;  ///< the lines are those of constant v
  double from = 0;         ///< of the other parameter, along which the seam runs
  double to = 0;
  std::vector<double> lengths;  ///< at even steps between these, at least two; model units

  /// Length of the line through a point, infinite where there is no seam.
  double length_at(Uv uv) const;
};

/// Find the rings of a patch that is a block of faces, if they are so short that `bounds` alone
/// would leave less than `kUnitsAround` elements around. A mesh would be flat there, or improper.
///
/// Error    lengths are those of polylines of 8 chords a face, interpolated between 4 lines a face:
///          below by 3 % for a round ring of four faces (test RingSizes.*)
/// Cost     32 evaluations a face
std::vector<Ring> short_rings(const Model& model, int patch, const SizeBounds& bounds);

/// Elements wanted around a ring, also if they have to be smaller than hmin.
inline constexpr double kUnitsAround = 4;

/// The size along a ring line of this length; it does not go below a small share of hmin.
double size_around(double ring_length, const SizeBounds& bounds);

}  // namespace surfmesh
