// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// The lengths of elements that follow from a curvature: factor × radius, and the length that keeps
/// the sag of elements below the requested one. If both are given, the shorter one.
///
/// A segment of length h over a curve of curvature k has the sag h² k / 8, and a triangle of sides
/// h over a sphere h² k / 6. Lengths in a mesh scatter, so no share of the sag guarantees it;
/// measuring finds the rest.
///
/// Units    curvatures 1/length, of either sign; lengths in model units, infinite at curvature 0
class CurvatureLength {
 public:
  explicit CurvatureLength(const ResolvedSizing& sizing)
      : factor_(sizing.curvature), sag_(sizing.sag) {}

  /// The lengths by the factor alone.
  CurvatureLength without_sag() const {
    CurvatureLength result = *this;
    result.sag_ = 0;
    return result;
  }

  /// True if no length follows from any curvature.
  bool is_off() const { return factor_ == 0 && sag_ == 0; }

  /// The length of triangles along a principal direction of their surface.
  double of_surface(double curvature) const;

  /// The length of triangles at an extraordinary vertex, from the greatest curvature on a ring
  /// around it.
  double around_vertex(double curvature) const;

  /// The length of segments of a curve.
  double of_curve(double curvature) const;

 private:
  double shorter(double curvature, double share_of_sag) const;

  double factor_;  ///< 0 is off
  double sag_;     ///< model units; 0 is off
};

}  // namespace surfmesh
