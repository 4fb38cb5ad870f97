// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <TopoDS_Shape.hxx>

namespace surfmesh {

/// Whether a surface or an edge of splines has a corner inside, by which its direction changes by
/// more than 0.1°. Knots that would allow one often have none: those of a NURBS sphere.
bool has_corners(const TopoDS_Shape& shape);

}  // namespace surfmesh
