// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Geom_Surface.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

inline Vec3 to_vec3(const gp_Pnt& point) { return {point.X(), point.Y(), point.Z()}; }
inline Vec3 to_vec3(const gp_Vec& vector) { return {vector.X(), vector.Y(), vector.Z()}; }

/// A point of a surface of the file, with derivatives up to `order`.
Jet file_jet(const Geom_Surface& surface, Uv uv, Order order);

/// The jet again. Throws   Geometry if it is not finite, naming (u,v)
const Jet& finite(const Jet& jet, Uv uv, Order order);

/// Throws   Geometry, naming (u,v)
[[noreturn]] void fail_evaluation(Uv uv);

}  // namespace surfmesh
