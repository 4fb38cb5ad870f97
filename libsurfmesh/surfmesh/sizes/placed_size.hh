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

/// The tangent frame of a jet of order First or more. If p_u and p_v are parallel, the second axis
/// is any perpendicular one; if both vanish, the axes are those of x and y.
TangentFrame tangent_frame(const Jet& jet);

/// Sizes wanted around a point, a segment or a box in space, in closed form.
///
/// Let d be the distance from the segment or the box; inside a box it is 0. Up to `radius`, the
/// sizes are those of the segment, which change linearly along it. With `outer`, they then change
/// linearly in H to the outer sizes, over the outer radius. Beyond that, H grows by the grade: H (1
/// + ln g · l), where l is the metric length of the rest of the way. The part of the way that
/// leaves the tangent plane counts with the larger size.
///
/// Sizes that follow their segment grow by ln g per unit of distance in both lengths:
/// H + ln g · d · I. The gradation of the control space, which comes last, lowers that to the law
/// above where the way is in the direction of the larger length. A chain of thousands of segments
/// can thus be searched fast, because the larger size of the nearest segment is soon below the
/// smaller ones of all others.
struct PlacedSize {
  /// The sizes at the end of the way outwards, and how long that is.
  struct OuterSize {
    SizeLengths lengths;
    double angle = 0;
    double radius = 0;
  };

  Vec3 from;
  Vec3 to;  ///< `from` again for a point
  SizeLengths at_from;
  SizeLengths at_to;
  /// Of the first length: radians from the first tangent axis at the query point.
  double angle = 0;
  /// True if the first length is along the segment, as seen in the tangent plane; `angle` then has
  /// no effect.
  bool follows_segment = false;
  /// True for the box whose least and greatest corner are `from` and `to`; its size is `at_from`.
  bool is_box = false;
  double radius = 0;  ///< model units
  std::optional<OuterSize> outer = {};
};

/// The sizes that a placed size asks for at a point of a surface; nothing out of its reach.
///
/// Units    growth is ln g; infinite without gradation, which ends the reach at the radii
std::optional<SizeTensor> size_around(const PlacedSize& placed, const TangentFrame& place,
                                      double growth);

/// The least length that a placed size asks for anywhere.
double least_length(const PlacedSize& placed);

/// Sizes grow by at least this value times ln g per unit of distance: the least ratio of the
/// smaller to the larger length, or 1 if both grow alike.
double least_ratio(const PlacedSize& placed);

/// ln g; infinite if gradation is off (0).
double growth_of_grade(double grade);

/// The distance up to which sizes do not grow by the grade.
inline double reach(const PlacedSize& placed) {
  return placed.radius + (placed.outer ? placed.outer->radius : 0);
}

}  // namespace surfmesh
