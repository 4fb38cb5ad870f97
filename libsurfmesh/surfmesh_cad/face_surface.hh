// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <memory>

#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// The surface of a face where the face is, not trimmed.
///
/// Throws   Geometry if it has none
Handle(Geom_Surface) surface_of(const TopoDS_Face& face);

/// The surface of a patch over a domain, in whatever way suits its kind. Its cells are the spans
/// between the knots of splines.
///
/// Throws   Geometry if the domain is more than kMostTurns away from the start of the surface, or
///          a spline would have to be repeated too often
std::shared_ptr<const Surface> face_surface(const Handle(Geom_Surface) & surface,
                                            const Domain& domain);

}  // namespace surfmesh
