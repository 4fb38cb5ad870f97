// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/model.hh"

/// How a segment of a contour lies in space, between two of its nodes.
namespace surfmesh {

/// The greatest distance of a curve on a surface from the segment between two t, model units.
///
/// Error    measured at three places
/// Cost     five evaluations
double segment_sag(const Surface& surface, const Curve& curve, double from, double to);

/// True if the straight line in the parameters between two t of a use leads far away from both the
/// contour and the segment, as it does around a pole where the contour passes near to it.
///
/// Error    measured at the middle
/// Cost     four evaluations
bool makes_detour(const Model& model, const ContourUse& use, double from, double to);

}  // namespace surfmesh
