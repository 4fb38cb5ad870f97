// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/sampling/control_nodes.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// ∫√det M, the number of unit squares that sizes ask for, of the exact field and of a control
/// space, on the same quasi-random points.
struct MetricArea {
  double exact = 0;
  double control = 0;
};

/// Estimate both integrals over the domain.
///
/// Error    about 1 % of either, much less of their ratio (the points are the same)
/// Cost     `samples` evaluations of the field and queries of the control space
MetricArea metric_area(const SizeField& field, const ControlSpace& control, int samples);

/// Choose control nodes by precision (choose_control_nodes), finer until a triangulation of them
/// holds ∫√det M of the field to 1.5 % on an independent sample; after six rounds, and
/// where elements cannot follow, what is reached is taken.
///
/// Error    on a smooth field 1 % of all points miss the precision at most, on one with kinks 2 %,
///          by less than three times (test AccurateNodes.*)
/// Cost     about 5 µs a node
ChosenNodes choose_accurate_nodes(const SizeField& field, const ControlNodeOptions& options);

/// Regular nodes, rows along u: as many as asked for, or twice as many along each side until
/// bilinear interpolation holds the field to the precision on an independent sample or cells are
/// small against the elements; a million at most.
///
/// Cost     about 1 µs a node
ChosenNodes choose_grid_nodes(const SizeField& field, const ControlNodeOptions& options);

}  // namespace surfmesh
