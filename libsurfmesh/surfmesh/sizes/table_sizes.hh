// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/control/node_interpolation.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/sizes/size_bounds.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// The nodes of a table with their positions, first forms and sizes, clamped.
///
/// Rows at a pole that are given by a metric are left out, as it belongs to a first form elsewhere:
/// in a mesh that of the points around. If there are no other rows, they are taken with the first
/// form beside the pole.
/// Throws   InvalidInput for a node outside the domain, a size that is none or a metric that is not
///          positive definite, naming its (u,v)
std::vector<ControlNode> table_nodes(const TableSource& source, const Surface& surface,
                                     const SizeBounds& bounds);

/// Number of rows whose sizes lie beyond the bounds, not counting those left out.
///
/// Throws   InvalidInput as table_nodes
std::size_t count_clamped(const TableSource& source, const Surface& surface,
                          const SizeBounds& bounds);

/// The sizes of a table everywhere in a patch: it is thinned to the precision, and interpolated.
///
/// Throws   InvalidInput as table_nodes, and for an empty table
/// Cost     about 5 µs a node
NodeInterpolation interpolate_table(const TableSource& source, const Surface& surface,
                                    const SizeBounds& bounds, double precision);

/// The size tensor that a metric in (u,v) asks for at a point of a surface.
///
/// Throws   InvalidInput for a metric that is not finite and positive definite, naming the point
SizeTensor size_from_metric_at(const Surface& surface, Uv uv, const FirstFormFactor& form,
                               const Metric& metric);

}  // namespace surfmesh
