// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/geometry/surface.hh"
#include "surfmesh/sizes/placed_size.hh"
#include "surfmesh/sizes/size_bounds.hh"
#include "surfmesh/sizes/sizing.hh"

/// The user's sources at points and along curves become placed sizes in space, clamped. Those
/// without any reach are left out. All functions throw InvalidInput for an invalid size or radius.
namespace surfmesh {

/// A point of the domain of a surface. A point that lies outside by rounding is moved to the
/// boundary.
/// Throws   InvalidInput for a point outside, naming it
Uv inside_domain(const Surface& surface, Uv uv);

/// Throws   InvalidInput for a point outside the domain
void add_at(const AtSource& source, const Surface& surface, const SizeBounds& bounds,
            std::vector<PlacedSize>& sizes);

/// Adds chords of the curves, which deviate from them by at most a tenth of the size.
/// Pre      the curves lie in the domain, up to rounding
void add_along(const AlongSource& source, const Surface& surface, const SizeBounds& bounds,
               std::vector<PlacedSize>& sizes);

/// Adds the border of the polygon.
/// Throws   InvalidInput for a polygon of fewer than three corners, or one outside the domain
void add_border(const InsideSource& source, const Surface& surface, const SizeBounds& bounds,
                std::vector<PlacedSize>& sizes);

/// Throws   InvalidInput for no points, or one that is not finite
void add_near(const NearSource& source, const SizeBounds& bounds, std::vector<PlacedSize>& sizes);

/// Throws   InvalidInput for a box that is empty or not finite
void add_box(const BoxSource& source, const SizeBounds& bounds, std::vector<PlacedSize>& sizes);

/// True if a point lies in a polygon; within rounding of its border, either result is possible.
bool contains(const std::vector<Uv>& polygon, Uv uv);

}  // namespace surfmesh
