// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/sampling/control_nodes.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// ∫√det M, the number of unit squares that the sizes ask for: of the exact field and of a control
/// space, at the same quasi-random points.
struct MetricArea {
  double exact = 0;
  double control = 0;
};

/// Estimate both integrals over the domain.
///
/// Error    about 1 % for each, much less for their ratio (the points are the same)
/// Cost     `samples` evaluations of the field and queries of the control space
MetricArea metric_area(const SizeField& field, const ControlSpace& control, int samples);

/// Choose control nodes by precision (choose_control_nodes), with a finer precision until a
/// triangulation of them has ∫√det M of the field to 1.5 % on an independent sample. After six
/// rounds, or where elements cannot follow, the nodes are accepted as they are.
///
/// Error    at most 1 % of all points miss the precision on a smooth field, 2 % on one with kinks,
///          and by less than three times (test AccurateNodes.*)
/// Cost     about 5 µs per node
ChosenNodes choose_accurate_nodes(const SizeField& field, const ControlNodeOptions& options);

/// Regular nodes in rows along u. Either a given number, or doubled along each side until bilinear
/// interpolation represents the field to the precision at 99 % of an independent sample and at
/// the places of sources, or cells are small compared with elements; but no more than 20,000 nodes
/// and 16 per unit of metric area, a million at most.
///
/// Cost     about 1 µs per node
/// Throws   Cancelled
ChosenNodes choose_grid_nodes(const SizeField& field, const ControlNodeOptions& options,
                              const RunContext& context = RunContext());

}  // namespace surfmesh
