// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/sizes/size_bounds.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// A checked sizing in model units. It is made once per model, and everything that makes sizes uses
/// it.
struct ResolvedSizing {
  SizeBounds bounds;
  double curvature = 0;  ///< factor of the radius of curvature; 0 is off
  double sag = 0;        ///< greatest distance between mesh and surface, model units; 0 is off
  double stretch = 2;    ///< greatest ratio of the two sizes from curvature
  double grade = 1.5;    ///< sizes grow by at most ln(grade) per unit of length; 0 is off
  bool contour_curvature = true;
  double proximity = 1;  ///< elements wanted across a gap; 0 is off
  bool features = true;
  CurvatureFrom curvature_from = CurvatureFrom::Exact;

  /// True if sizes follow from curvature at all.
  bool follows_curvature() const { return curvature > 0 || sag > 0; }
};

/// Check a sizing and turn its shares of the model's diagonal into lengths.
///
/// Throws   InvalidOption naming the option, its value and its range
ResolvedSizing resolve(const Sizing& sizing, double diagonal);

}  // namespace surfmesh
