// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Find a point that has a tangent plane near one that has none (a pole). It lies a thousandth of
/// the way towards the middle of the domain: near enough to have the sizes of the pole, far enough
/// for full accuracy. Returns the point itself if there is none nearby.
///
/// Cost     one to three evaluations of first order
Uv beside_pole(const Surface& surface, Uv uv);

}  // namespace surfmesh
