// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/size_bounds.hh"

namespace surfmesh {

/// The lengths of closed lines around a patch that meets itself at a seam.
struct Ring {
  bool is_along_u = true;  ///< the lines are those of constant v
  double from = 0;         ///< of the other parameter: the seam runs along it
  double to = 0;
  std::vector<double> lengths;  ///< at equal steps between these, at least two; model units

  /// The length of the line through a point; infinite where there is no seam.
  double length_at(Uv uv) const;
};

/// Find the rings of a patch that is a block of faces, if they are so short that `bounds` alone
/// would leave fewer than `kUnitsAround` elements around. A mesh would be flat or improper there.
///
/// Error    lengths are those of polylines of 8 chords per face, interpolated between 4 lines per
///          face: 3 % too short for a round ring of four faces (test RingSizes.*)
/// Cost     32 evaluations per face
std::vector<Ring> short_rings(const Model& model, int patch, const SizeBounds& bounds);

/// Elements wanted around a ring, even if they have to be smaller than hmin.
inline constexpr double kUnitsAround = 4;

/// The size along a ring line of this length; never below a small share of hmin.
double size_around(double ring_length, const SizeBounds& bounds);

}  // namespace surfmesh
