// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/sizes/size_bounds.hh"

namespace surfmesh {

/// A point of a surface with the axes of its tangent frame, orthonormal vectors in space.
struct TangentFrame {
  Vec3 point;
  Vec3 first;   ///< along p_u; along p_v where p_u vanishes
  Vec3 second;  ///< towards p_v
};

/// The place of a jet of order First or more; where p_u and p_v are parallel, the second axis is
/// any that is perpendicular, and where both vanish the axes are those of x and y.
TangentFrame tangent_frame(const Jet& jet);

/// Sizes wanted around a point or a segment in space, in closed form.
///
/// With d the distance from the segment: the sizes of the segment, which change linearly along it,
/// for d up to `radius`; with `outer`, linearly in H from these to the outer sizes over the outer
/// radius; beyond, H grows by the grade, H (1 + ln g · l) with l the metric length of the rest of
/// the way. What is out of the tangent plane counts with the larger size. Sizes that follow their
/// segment grow by ln g per unit of distance in both lengths, H + ln g · d · I: the gradation of
/// the control space, which comes last, lowers that to the law where the way is in the direction of
/// the larger one, and a chain of thousands of segments can be searched fast, for the larger size
/// of the nearest is soon below the smaller ones of all others.
struct PlacedSize {
  struct OuterSize {
    SizeLengths lengths;
    double angle = 0;
    double radius = 0;
  };

  Vec3 from;
  Vec3 to;  ///< `from` again for a point
  SizeLengths at_from;
  SizeLengths at_to;
  /// Of the first length: radians from the first tangent axis at the point asked for.
  double angle = 0;
  /// True if the first length is along the segment, as seen in the tangent plane, whatever `angle`.
  bool follows_segment = false;
  double radius = 0;  ///< model units
  std::optional<OuterSize> outer = {};
};

/// The sizes that a placed size asks for at a point of a surface; none out of its reach.
///
/// Units    growth is ln g; infinite without gradation, and then nothing is wanted beyond the radii
std::optional<SizeTensor> size_around(const PlacedSize& placed, const TangentFrame& place,
                                      double growth);

/// Least length that a placed size asks for anywhere.
double least_length(const PlacedSize& placed);

/// Sizes grow by at least so much times ln g per unit of distance: the least ratio of the smaller
/// to the larger length, 1 where both grow alike.
double least_ratio(const PlacedSize& placed);

/// ln g; infinite if gradation is off (0).
double growth_of_grade(double grade);

/// Distance up to which sizes do not grow by the grade.
inline double reach(const PlacedSize& placed) {
  return placed.radius + (placed.outer ? placed.outer->radius : 0);
}

}  // namespace surfmesh
