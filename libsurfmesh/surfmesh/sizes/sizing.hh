// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/interval.hh"
#include "surfmesh/core/length.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/curve.hh"

namespace surfmesh {

/// Where the curvature of a surface comes from.
enum class CurvatureFrom {
  Exact,       ///< its second derivatives
  Differences  ///< differences of its positions, for surfaces without derivatives
};

/// What shares of the diagonal in the bounds of sizes refer to.
enum class SharesOf {
  Model,  ///< its diagonal
  Part    ///< that of each part of the model: what hangs together by contours
};

/// What the lower clamp of sizes is if it is not given, as shares of the diagonal. Holes of CAD
/// parts may be a thousandth of the part.
inline constexpr double kUsualHmin = 1e-3;
inline constexpr double kHminOfCircles = 1e-5;

/// Which sizes follow from the shape, and the bounds of all sizes.
struct Sizing {
  /// Size = factor × radius of curvature; 0 is off. Unset: 0.25, or off with `sag` or `size`.
  std::optional<double> curvature = {};
  /// Segments of a full circle, at least 3, in place of `curvature`: of surfaces, and of contours,
  /// down to holes of a thousandth of the model. 0 is off.
  double segments_per_circle = 0;
  /// Lower clamp of all sizes, above 0. Unset: 0.1 % of the diagonal, or 0.001 % with
  /// `segments_per_circle`.
  std::optional<Length> hmin = {};
  Length hmax = Length::share(0.2);      ///< upper clamp of all sizes, at least hmin
  SharesOf shares_of = SharesOf::Model;  ///< of hmin and hmax
  double stretch = 2;  ///< greatest ratio of the two sizes from curvature, at least 1
  double grade = 1.5;  ///< sizes grow by at most ln(grade) per unit of length; 0 is off
  /// Sizes from the curvature of true boundaries, creases and trims; off without `curvature` and
  /// `sag`.
  bool contour_curvature = true;
  double proximity = 1;  ///< elements wanted across a gap between two parts of a boundary; 0 is off
  bool features = true;  ///< short contours bound the sizes near them
  CurvatureFrom curvature_from = CurvatureFrom::Exact;
  /// One length everywhere, above 0: it is both bounds, and nothing else has an effect. Unset is
  /// off.
  std::optional<Length> size = {};
  bool isotropic = false;  ///< at each point the least size holds in all directions
  /// Greatest permitted distance between mesh and surface, above 0; unset is off.
  std::optional<Length> sag = {};

  /// The effective factor: the length of an arc of the unit circle for so many segments.
  double curvature_factor() const {
    if (segments_per_circle > 0) return 2 * std::numbers::pi / segments_per_circle;
    return curvature.value_or(sag || size ? 0 : 0.25);
  }

  /// The effective lower clamp.
  Length least_size() const {
    return hmin.value_or(Length::share(segments_per_circle > 0 ? kHminOfCircles : kUsualHmin));
  }
};

namespace ranges {

inline constexpr LengthRange kSag = {"sag", true};
inline constexpr LengthRange kSize = {"size", true};
inline constexpr LengthRange kHmin = {"hmin"};
inline constexpr LengthRange kHmax = {"hmax"};

}  // namespace ranges

/// Wanted edge lengths: l_s along the first axis turned by `angle`, l_t across.
struct Size {
  Length along = {};
  Length across = {};
  double angle = 0;  ///< radians, from the first tangent axis (along p_u)

  static Size isotropic(Length length) { return {length, length}; }
};

/// The size farther away: beyond the `radius` of the source, sizes change linearly to `size` over
/// the length `radius` given here.
/// Source   paper, section 3.1: M′ and r′
struct Outer {
  Size size = {};
  Length radius = {};
};

/// A size around a point or curve. It holds within `radius` and, with `outer`, changes to the outer
/// size beyond that. From there it grows by the grade; without gradation it has no effect farther
/// away. Distances are measured in space.
struct LocalSize {
  Size size = {};
  Length radius = {};
  std::optional<Outer> outer = {};
};

/// An area source: one size in the whole patch.
struct EverywhereSource {
  int patch = -1;
  Size size = {};
  /// Where it is given (a file and JSON pointer), for messages; empty if in C++.
  std::string origin = {};
};

/// A node source: a size at one point of a patch, in any form of the paper's section 3.1.
struct AtSource {
  int patch = -1;
  Uv at = {};
  Size size = {};
  Length radius = {};
  std::optional<Outer> outer = {};
  /// Where it is given (a file and JSON pointer), for messages; empty if in C++.
  std::string origin = {};
};

/// A size along curves in the parameters of a patch.
struct AlongSource {
  int patch = -1;
  std::vector<std::shared_ptr<const Curve>> curves = {};
  LocalSize wish = {};
  /// Where it is given (a file and JSON pointer), for messages; empty if in C++.
  std::string origin = {};
};

/// An area source: a size inside a polygon in the parameters of a patch, its border included.
struct InsideSource {
  int patch = -1;
  /// At least three corners, in either direction, without crossings.
  std::vector<Uv> polygon = {};
  LocalSize wish = {};
  /// Where it is given (a file and JSON pointer), for messages; empty if in C++.
  std::string origin = {};
};

/// A size near a point or a polyline in space. With a radius, a point is a ball.
struct NearSource {
  std::vector<Vec3> line = {};  ///< one point or more
  LocalSize wish = {};
  std::vector<int> patches = {};  ///< where it applies; empty for every patch
  /// Where it is given (a file and JSON pointer), for messages; empty if in C++.
  std::string origin = {};
};

/// A size inside a box in space, its faces included.
struct BoxSource {
  Eigen::AlignedBox3d box = {};
  LocalSize wish = {};
  std::vector<int> patches = {};  ///< where it applies; empty for every patch
  /// Where it is given (a file and JSON pointer), for messages; empty if in C++.
  std::string origin = {};
};

/// Bounds of the entries of a metric.
struct MetricBounds {
  Interval m11;
  Interval m12;
  Interval m22;
};

/// An area source: sizes as a function of (u,v) and the position in space. One of the two functions
/// is set; it is called from several threads at once, as are those of its bounds.
///
/// Bounds hold for all (u,v) in a box whose positions are in the other box. With them, no small
/// size can hide between samples (sizes/field_search.hh); without them, it is looked for by
/// samples (sizes/hidden_sizes.hh). Formulas of model files have bounds.
struct FieldSource {
  int patch = -1;
  std::function<double(Uv, const Vec3&)> size = {};    ///< one length, model units
  std::function<Metric(Uv, const Vec3&)> metric = {};  ///< M in (u,v)
  std::optional<double> precision = {};                ///< overrides that of the options
  std::function<Interval(const UvBox&, const Eigen::AlignedBox3d&)> size_bounds = {};
  std::function<MetricBounds(const UvBox&, const Eigen::AlignedBox3d&)> metric_bounds = {};
  bool uses_position = true;  ///< false: function and bounds do not read the position in space
  /// Where it is given (a file and JSON pointer), for messages; empty if in C++.
  std::string origin = {};

  bool has_bounds() const { return metric ? bool(metric_bounds) : bool(size_bounds); }
};

/// A point of a table: a size, or if `metric` is set, the metric in (u,v).
struct TableNode {
  Uv uv = {};
  Size size = {};
  Metric metric = {};
};

/// An area source: sizes given at points, between which they are interpolated.
struct TableSource {
  int patch = -1;
  std::vector<TableNode> nodes = {};
  std::optional<double> precision = {};  ///< overrides that of the options
  /// Where it is given (a file and JSON pointer), for messages; empty if in C++.
  std::string origin = {};
};

/// All user-requested sizes, apart from curvature.
struct Sources {
  std::vector<EverywhereSource> everywhere = {};
  std::vector<AtSource> at = {};
  std::vector<AlongSource> along = {};
  std::vector<InsideSource> inside = {};
  std::vector<NearSource> near = {};
  std::vector<BoxSource> boxes = {};
  std::vector<FieldSource> fields = {};
  std::vector<TableSource> tables = {};
};

}  // namespace surfmesh
