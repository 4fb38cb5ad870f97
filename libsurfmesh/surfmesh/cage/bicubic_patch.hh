// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>

#include "surfmesh/cage/cage_surface.hh"

namespace surfmesh {

/// The bicubic polynomial over the unit square that has the given point, du, dv and duv at the
/// corners (0,0), (1,0), (1,1), (0,1).
///
/// These sixteen vectors determine it, whatever basis was used to evaluate them.
/// Error    rounding (test BicubicPatchTest.*)
class BicubicPolynomial {
 public:
  /// True if the vectors that matter at a corner are finite.
  static bool can_have(const Jet& corner);

  /// Throws   Geometry if a vector is not finite
  explicit BicubicPolynomial(const std::array<Jet, 4>& corners);

  /// Pre      uv is finite
  Jet evaluate(Uv uv, Order order) const;

 private:
  /// Bézier points, rows_[j][i] at (i/3, j/3), with an unused fourth coordinate, so that one
  /// instruction works on two coordinates.
  std::array<std::array<Eigen::Vector4d, 4>, 4> rows_;
};

/// Make a surface from such a polynomial, over the given face of a cage.
///
/// Throws   Geometry if a vector is not finite
std::shared_ptr<const Surface> make_bicubic_patch(const std::array<Jet, 4>& corners,
                                                  const FaceOfCage& face = {});

}  // namespace surfmesh
