// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/resolved_sizing.hh"
#include "surfmesh/sizes/size_bounds.hh"

namespace surfmesh {

/// The closed lines around a tube, as one of its patches sees them. The tube is a patch that meets
/// itself at a seam, or up to eight patches of one cell each, one after the other.
struct Ring {
  bool is_along_u = true;  ///< the lines are those of constant v
  double from = 0;         ///< of the other parameter: the tube runs along it
  double to = 0;
  std::vector<double> lengths;         ///< at equal steps between these, at least two; model units
  std::vector<double> distances = {};  ///< of these lines from the first one, along the patch
  std::vector<double> poles = {};      ///< distances at which the line is one point

  /// The length of the line through a point; infinite beside the tube. Near a pole, that of the
  /// line as far from it as an element is long, for the triangles up to there meet in the pole.
  double length_at(Uv uv, double element_length) const;
};

/// The greatest length of a ring that can have fewer than `kUnitsAround` elements around without
/// a size of its own: longer ones get enough from hmax, or from curvature above hmin.
double greatest_ring(const ResolvedSizing& sizing);

/// Find the rings of a patch that are shorter than `greatest` somewhere, or meet in a pole. A mesh
/// would be flat or improper there.
///
/// Error    lengths are those of polylines of 8 chords per cell of the surface and at least 32,
///          interpolated between 4 lines per cell and at least 32: 3 % too short for a round ring
///          of four faces (test RingSizes.*)
/// Cost     32 evaluations per cell, at least 1,000, for a patch that has such rings; a quarter for
///          one that has longer rings
std::vector<Ring> short_rings(const Model& model, int patch, double greatest);

/// Elements wanted around a ring, even if they have to be smaller than hmin.
inline constexpr double kUnitsAround = 4;

/// The size along a ring line of this length; never below a very small share of hmin.
double size_around(double ring_length, const SizeBounds& bounds);

}  // namespace surfmesh
