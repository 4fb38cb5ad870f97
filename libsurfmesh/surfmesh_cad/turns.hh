// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Geom_Surface.hxx>

#include "surfmesh/geometry/domain.hh"

namespace surfmesh {

/// A face that lies so many turns around a periodic surface away from its start is damaged:
/// OpenCASCADE goes from turn to turn.
inline constexpr double kMostTurns = 1e4;

/// Check that no side of a domain is more than kMostTurns away from the start of its surface, which
/// can be of any kind.
///
/// Throws   Geometry, with the number of turns
void check_turns(const Geom_Surface& surface, const Domain& domain);

}  // namespace surfmesh
