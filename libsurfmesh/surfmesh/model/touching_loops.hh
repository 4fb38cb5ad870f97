// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Bring loops that touch themselves or each other in a corner into the form that meshing expects:
/// each loop runs along the inside of its patch, and turns at such a corner into the same sector
/// from which it came.
///
/// A hole whose corner lies on the outer loop becomes a part of it. Two holes with a common corner
/// become one loop. Where a patch hangs together in a corner only, each of its pieces gets an outer
/// loop of its own. Corners touch if they have the same vertex and exactly the same (u,v), see
/// pin_ends. Loops that do not touch stay as they are; so do those that cross at a corner, which
/// are refused later.
///
/// Cost     O(n log n) for n contour uses; some tens of evaluations for each that touches
void separate_touching_loops(Model& model);

/// Of the loops of a patch, how many run counter-clockwise in (u,v), less those that run clockwise:
/// the Euler number of its inside without its boundary.
/// Cost     64 evaluations a contour use; none if there is one loop
long outer_less_inner_loops(const Model& model, const Patch& patch);

}  // namespace surfmesh
