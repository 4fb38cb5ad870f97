// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/geometry/curve.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// Metric arc length along a curve in the parameters of a patch, as a table.
///
/// The curve is bisected until each piece is at most half a unit long and its length agrees with
/// the sum over its parts. The length of a piece follows from the metrics at both of its ends, as
/// in eq. (3) of the paper.
///
/// Error    about 1e-3 of the length, 1e-2 for a curve with waves within a unit (test MetricArc.*)
/// Cost     four to eight metric queries per unit of length, at least 17
/// Throws   Cancelled; Limit for more than a million units; Geometry where a metric is not finite
class MetricArc {
 public:
  MetricArc(const Curve& curve, const MetricField& field, const RunContext& context = RunContext());

  /// Metric length of the whole curve, which is the number of segments wanted.
  double length() const { return arcs_.back(); }

  /// Queries of the metric field that this table took.
  const QueryCounts& queries() const { return queries_; }

  /// Metric length from t = 0 to t.
  double arc(double t) const;

  /// The t at which the metric length from t = 0 is `arc`.
  double parameter(double arc) const;

 private:
  std::vector<double> parameters_;
  std::vector<double> arcs_;
  QueryCounts queries_;
};

}  // namespace surfmesh
