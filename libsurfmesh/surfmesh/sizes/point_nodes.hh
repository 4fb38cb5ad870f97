// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/sizes/patch_sources.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// The nodes of `at` in their extended forms, from these sources alone: size is M′ where there is
/// an outer one, else M.
///
/// Throws   InvalidInput for a point outside the domain, or a size or radius that is none
/// Source   paper, section 3.1
std::vector<ControlNode> point_nodes(const std::vector<AtSource>& sources, const Surface& surface,
                                     const SizeBounds& bounds);

/// True if more than `at` has a say in the sizes of a patch.
bool has_other_sources(const PatchSources& sources, const SizeField& field);

/// The control nodes that sources with a place need besides the chosen ones: those of `at`, with
/// the minimum of the field where that has other sources; without gradation also those along curves
/// that have no radius, a size apart.
///
/// Throws   as point_nodes
std::vector<ControlNode> field_nodes(const PatchSources& sources, const SizeField& field,
                                     bool is_graded);

}  // namespace surfmesh
