// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>

#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Make the bicubic polynomial over the unit square that has the given point, du, dv and duv at
/// the corners (0,0), (1,0), (1,1), (0,1).
///
/// These sixteen vectors determine it, whatever basis they were evaluated in.
/// Error    rounding (test BicubicPatchTest.*)
/// Throws   Geometry if a vector is not finite
std::shared_ptr<const Surface> make_bicubic_patch(const std::array<Jet, 4>& corners);

}  // namespace surfmesh
