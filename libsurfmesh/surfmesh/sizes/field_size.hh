// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// The size that a field asks for at a point of a surface, not clamped.
///
/// Throws   InvalidInput for a size or metric that is not finite and positive (definite), naming
///          (u,v)
SizeTensor size_of_field(const FieldSource& field, const Surface& surface, const SurfacePoint& at);

/// The least length that a field asks for at a point of the domain, not clamped.
///
/// Cost     one evaluation of the field, and of the surface if the field needs one
/// Throws   as size_of_field
double least_length(const FieldSource& field, const Surface& surface, Uv uv);

/// Ranges of the entries of the first form, E = p_u·p_u, F = p_u·p_v, G = p_v·p_v, in a box of the
/// domain: those of the samples of least_length_in, with their margin.
struct FirstFormBounds {
  Interval e;
  Interval f;
  Interval g;
};
/// Bound the first form in a box of the domain.
FirstFormBounds first_form_in(const Surface& surface, const UvBox& box);

/// Bound the least length of a field with bounds from below, in a box of the domain.
///
/// Without positions and metrics the bound holds. Positions and first forms are those of 3 × 3
/// samples, or of more if the box spans several cells of the surface, with a margin of a quarter of
/// their range on each side: twice what a quadratic surface needs, but no proof for others. In a
/// box at a pole, where metrics have no limit, the bound is 0; if it is smaller than 1/64 of the
/// domain, the least of the samples.
///
/// Cost     one evaluation of the bounds; those samples of the surface, if the field needs them
/// Pre      the field has bounds
double least_length_in(const FieldSource& field, const Surface& surface, const UvBox& box);

}  // namespace surfmesh
