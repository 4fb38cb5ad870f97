// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/sizes/patch_sources.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// The nodes of `at` in their extended forms, from these sources alone: the size is M′ if there is
/// an outer one, otherwise M.
///
/// Throws   InvalidInput for a point outside the domain, or an invalid size or radius
/// Source   paper, section 3.1
std::vector<ControlNode> point_nodes(const std::vector<AtSource>& sources, const Surface& surface,
                                     const SizeBounds& bounds);

/// True if a patch has sources of sizes other than `at`.
bool has_other_sources(const PatchSources& sources, const SizeField& field);

/// The control nodes that sources at points and along curves need in addition to the chosen ones:
/// those of `at`, with the minimum of the field if it has other sources. Without gradation also
/// nodes along curves that have no radius, one size apart.
///
/// Throws   as point_nodes
std::vector<ControlNode> field_nodes(const PatchSources& sources, const SizeField& field,
                                     bool is_graded);

}  // namespace surfmesh
