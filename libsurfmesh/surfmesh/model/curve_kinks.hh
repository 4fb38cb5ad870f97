// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/geometry/curve.hh"

namespace surfmesh {

/// The places inside a curve where its direction jumps by 5° or more, in growing order.
///
/// The curve is compared at 33 unevenly spaced places. Where it turns at one of them, ever shorter
/// stretches around it are looked at. Parts between kinks are searched in their turn.
///
/// Returns  t in (0,1), to 1e-12 or as near as the rounding of coordinates allows
/// Error    kinks of 2.5° to 5° may be among them. A bend of a radius below 1e-5 of the curve may
///          be taken for a kink where coordinates are large. Kinks that undo each other between two
///          of the places are not seen
/// Throws   Geometry for more than 2,000 kinks
/// Cost     33 evaluations, as many for each kink, and about 80 for each kink
std::vector<double> curve_kinks(const SpaceCurve& curve);

}  // namespace surfmesh
