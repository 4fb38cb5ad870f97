// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/geometry/surface.hh"
#include "surfmesh/sizes/placed_size.hh"
#include "surfmesh/sizes/size_bounds.hh"
#include "surfmesh/sizes/sizing.hh"

/// The user's sources with a place become placed sizes in space, clamped; those that reach nowhere
/// become nothing. All throw InvalidInput for a size or a radius that is none.
namespace surfmesh {

/// A point in the domain of a surface; one that lies outside by rounding is moved to the boundary.
/// Throws   InvalidInput for a point outside, naming it
Uv inside_domain(const Surface& surface, Uv uv);

/// Throws   InvalidInput for a point outside the domain
void add_at(const AtSource& source, const Surface& surface, const SizeBounds& bounds,
            std::vector<PlacedSize>& sizes);

/// Chords of the curves, which deviate by a tenth of the size at most.
/// Pre      the curves lie in the domain, up to rounding
void add_along(const AlongSource& source, const Surface& surface, const SizeBounds& bounds,
               std::vector<PlacedSize>& sizes);

/// The border of the polygon.
/// Throws   InvalidInput for a polygon of less than three corners, or one outside the domain
void add_border(const InsideSource& source, const Surface& surface, const SizeBounds& bounds,
                std::vector<PlacedSize>& sizes);

/// Throws   InvalidInput for no points, or one that is not finite
void add_near(const NearSource& source, const SizeBounds& bounds, std::vector<PlacedSize>& sizes);

/// True if a point lies in a polygon; undecided within rounding of its border.
bool contains(const std::vector<Uv>& polygon, Uv uv);

}  // namespace surfmesh
