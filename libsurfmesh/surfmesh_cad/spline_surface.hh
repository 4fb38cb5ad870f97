// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <memory>

#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// A B-spline surface, rational or not, over a part of its domain, or more of it if it is periodic.
/// Its cells are its knot spans.
std::shared_ptr<const Surface> spline_surface(const Handle(Geom_BSplineSurface) & surface,
                                              const Domain& domain);

}  // namespace surfmesh
