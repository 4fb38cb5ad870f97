// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Geom_Surface.hxx>

#include "surfmesh/geometry/domain.hh"

namespace surfmesh {

/// A face that goes so often around a periodic surface, or lies so many turns from its start, is
/// damaged: OpenCASCADE goes from turn to turn.
inline constexpr double kMostTurns = 1e4;

/// How often a domain goes around a surface, or how many turns it is away from its start, whichever
/// is more; 0 if the surface is not periodic.
double turns(const Geom_Surface& surface, const Domain& domain);

}  // namespace surfmesh
