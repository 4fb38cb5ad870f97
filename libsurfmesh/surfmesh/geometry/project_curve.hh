// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Express a curve in space in the parameters of the surface on which it lies.
///
/// The curve is followed from its start. If several points of the domain are its start (on a seam),
/// the first one is taken from which the curve can be followed inside the domain. Every evaluation
/// of the result projects the point again, so the result is as smooth as the curve and the surface.
///
/// `reach` is the distance from the surface that counts as too far; `range` is for messages.
/// Error    a few roundings of the parameters, if the curve lies on the surface (test
///          ProjectCurve.*)
/// Cost     a few thousand evaluations of the surface to set up; 2 to 4 of them for each
///          evaluation, below 2 µs for formulas
/// Pre      the domain is a rectangle
/// Throws   Geometry if the curve is not on the surface, with t and the greatest gap, or if it
///          crosses a side of the domain, with t
std::shared_ptr<const Curve> project_curve(std::shared_ptr<const Surface> surface,
                                           std::shared_ptr<const SpaceCurve> curve, double reach,
                                           const CurveRange& range = {});

}  // namespace surfmesh
