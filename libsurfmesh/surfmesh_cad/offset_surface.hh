// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Geom_OffsetSurface.hxx>
#include <memory>

#include "surfmesh/geometry/surface.hh"
#include "surfmesh/geometry/uneven_cells.hh"

namespace surfmesh {

/// A surface at a distance from another, along its normal.
///
/// OpenCASCADE's own evaluation of second derivatives takes ten times as long.
std::shared_ptr<const Surface> offset_surface(const Handle(Geom_OffsetSurface) & surface,
                                              const Domain& domain, UnevenCells cells);

}  // namespace surfmesh
