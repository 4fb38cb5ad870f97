// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Geom_Surface.hxx>
#include <memory>

#include "surfmesh/geometry/surface.hh"
#include "surfmesh/geometry/uneven_cells.hh"

namespace surfmesh {

/// A plane, cylinder, cone, sphere, torus, or a surface of revolution or extrusion of a file.
///
/// It is evaluated by the object of the file itself, which keeps nothing between calls.
/// OpenCASCADE's adaptors do: from several threads their results are wrong.
std::shared_ptr<const Surface> stateless_surface(const Handle(Geom_Surface) & surface,
                                                 const Domain& domain, UnevenCells cells);

}  // namespace surfmesh
