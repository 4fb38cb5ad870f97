// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/nurbs/knot_spans.hh"
#include "surfmesh/nurbs/nurbs_net.hh"

namespace surfmesh {

/// A B-spline or NURBS curve in the parameters of a patch.
///
/// Both ends are exact where they are control points, and a coordinate that all points have is that
/// of the whole curve, so that one on a side of a domain never leaves it.
/// Error    as for NurbsSurface
/// Cost     an evaluation is O(degree + log spans)
class NurbsCurve : public Curve {
 public:
  /// The whole curve over t in [0,1]: from the first inner knot to the last, or one period.
  /// Throws   InvalidInput as check(polygon)
  explicit NurbsCurve(const NurbsPolygon& polygon);

  /// The part between two values of the knots' parameter.
  /// Throws   InvalidInput as check(polygon), or for a range that does not lie within the knots or
  ///          is longer than their period
  NurbsCurve(const NurbsPolygon& polygon, const CurveRange& range);

  Uv evaluate(double t) const override;

  /// The knots inside, as t. Each part between them may hold as much detail as a whole curve.
  const std::vector<double>& breaks() const { return breaks_; }

  const CurveRange& range() const { return range_; }

 private:
  Uv evaluate_at(double parameter) const;

  CurveRange range_;
  KnotSpans spans_;
  int degree_ = 1;
  Uv centre_;
  std::vector<Eigen::Vector3d> factors_;  ///< of (wu, wv, w), span by span
  std::vector<double> breaks_;
  std::optional<Uv> start_;  ///< control points at its ends
  std::optional<Uv> end_;
};

}  // namespace surfmesh
