// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// A metric in space, symmetric: xx, yy, zz, xy, yz, xz. A step e has the metric length √(eᵀMe), 1
/// is wanted.
using SpaceMetric = std::array<double, 6>;

}  // namespace surfmesh
