// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_nodes.hh"
#include "surfmesh/control/control_space.hh"
#include "surfmesh/control/patch_sources.hh"
#include "surfmesh/control/sizing.hh"

namespace surfmesh {

/// Make the control space of one patch from all sources of sizes.
///
/// Nodes are chosen so that the control space represents the sources; where it does not hold
/// their ∫√det M to 1.5 % on an independent sample, it is made again with a finer precision, six
/// times at most; what is reached then is taken. A precision that a source names wins over that of
/// the options. Nodes of `at` take the minimum with the other sources; without any of these the only
/// other nodes are the corners, with the size of the nearest `at`. Where gradation is off, a curve of
/// sizes without a radius becomes nodes along it. Gradation comes last.
///
/// Cost     about 5 µs a node
/// Throws   InvalidOption for sizing out of range; InvalidInput for a source that is, or that lies
///          outside the domain, naming its (u,v)
/// Source   paper, section 3.2
ControlSpace make_control(const Surface& surface, const Sizing& sizing,
                          const PatchSources& sources, double diagonal,
                          const ControlNodeOptions& options);

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

}  // namespace surfmesh
