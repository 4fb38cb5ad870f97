// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/nurbs/nurbs_surface.hh"

namespace surfmesh {

/// One of the rectangles that the creases of a surface divide it into.
struct NurbsPiece {
  std::shared_ptr<const NurbsSurface> surface;
  int column = 0;  ///< along u, from 0
  int row = 0;     ///< along v, from 0
};

/// Divide a surface along the knots where it is creased, so that no piece has a crease inside.
///
/// Only knots that are there `degree` times can be creases. They are none if the directions of the
/// derivative across them are the same on both sides, up to 0.1°. Pieces that are beside each other
/// share a side, row by row.
///
/// Returns  one piece if there is no crease
/// Error    directions are compared at 5 points of each span along the knot
/// Throws   InvalidInput as NurbsSurface
std::vector<NurbsPiece> split_at_creases(const NurbsNet& net, const Domain& domain);

}  // namespace surfmesh
