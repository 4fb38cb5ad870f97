// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Check that every entity of a STEP file is defined once and has a number that OpenCASCADE can
/// hold, that every reference leads to one, that no entity leads back to itself, that vertices have
/// a point, and loops, shells, curves, surfaces and shapes have members, and that no number is too
/// large.
///
/// OpenCASCADE goes on with what is there. It falls over what is not, and follows circles and
/// numbers that overflow without end.
///
/// Cost     O(n log n) for n references
/// Throws   InvalidInput, naming an entity and what it lacks
void check_step_text(std::string_view text);

}  // namespace surfmesh
