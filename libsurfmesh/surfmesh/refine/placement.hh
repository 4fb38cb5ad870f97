// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/control/metric_field.hh"
#include "surfmesh/delaunay/metric_swaps.hh"

namespace surfmesh {

/// A point to be inserted, with its metric.
using Candidate = MetricCorner;

/// A base edge from a to b and the corner of its triangle on the left.
struct BaseTriangle {
  MetricCorner a, b, apex;
};

/// The metric circumcentre of a triangle, in the mean metric of its corners; not finite for a
/// triangle without area.
Uv circumcentre(const BaseTriangle& triangle);

/// A point for a new node, and what it cost.
struct Place {
  Uv uv;
  std::size_t queries = 0;  ///< of the metric field
};

/// The point that makes a unit triangle with the base, or the circumcentre where that is nearer.
///
/// With M the mean of the base's ends and q the height of the circumcentre over the base: height
/// d = √(1 − l²/4), the circumcentre where q ≤ d; then one Newton step, at most half a unit, that
/// makes both legs of unit length, with the metric of the first place. A second step gains nothing.
///
/// Error    legs are within 2 % of 1 where sizes grow by 0.3 per unit of length (test
///          FrontalPoint.MakesNearlyUnitLegsWhereSizesGrow)
/// Cost     one metric query, for the step; none for a circumcentre
Place frontal_point(const BaseTriangle& triangle, const MetricField& field,
                    MetricField::Hint& hint);

}  // namespace surfmesh
