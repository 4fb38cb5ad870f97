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
/// Rows at a pole that are given by a metric are left out, because the metric belongs to a first
/// form elsewhere (in a mesh, to that of the surrounding points). If there are no other rows, they
/// are used with the first form beside the pole.
/// Throws   InvalidInput for a node outside the domain, an invalid size or a metric that is not
///          positive definite, naming its (u,v)
std::vector<ControlNode> table_nodes(const TableSource& source, const Surface& surface,
                                     const SizeBounds& bounds);

/// The number of rows whose sizes lie outside the bounds, without rows that are left out.
///
/// Throws   InvalidInput as table_nodes
std::size_t count_clamped(const TableSource& source, const Surface& surface,
                          const SizeBounds& bounds);

/// The sizes of a table everywhere in a patch: the table is thinned to the precision and
/// interpolated.
///
/// Throws   InvalidInput as table_nodes, and for an empty table
/// Cost     about 5 µs per node
NodeInterpolation interpolate_table(const TableSource& source, const Surface& surface,
                                    const SizeBounds& bounds, double precision);

/// The size tensor that a metric in (u,v) asks for at a point of a surface.
///
/// Throws   InvalidInput for a metric that is not finite and positive definite, naming the point
SizeTensor size_from_metric_at(const Surface& surface, Uv uv, const FirstFormFactor& form,
                               const Metric& metric);

}  // namespace surfmesh
