// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// A point near one without a tangent plane (a pole) that has one, a thousandth of the way towards
/// the middle of the domain: near enough to have the sizes of the pole, far enough for full
/// accuracy. The point itself if there is none around.
///
/// Cost     one to three evaluations of first order
Uv beside_pole(const Surface& surface, Uv uv);

}  // namespace surfmesh
