// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Where a surface may be evaluated: a rectangle, or the triangle below its falling diagonal.
///
/// The corners of a rectangle are, counter-clockwise, (u0,v0), (u1,v0), (u1,v1), (u0,v1); those of
/// a triangle (u0,v0), (u1,v0), (u0,v1).
struct Domain {
  enum class Shape { Rectangle, Triangle };

  double u0 = 0;
  double u1 = 1;
  double v0 = 0;
  double v1 = 1;
  Shape shape = Shape::Rectangle;

  int corner_count() const { return shape == Shape::Triangle ? 3 : 4; }

  Uv corner(int i) const {
    if (shape == Shape::Triangle) return i == 0 ? Uv{u0, v0} : i == 1 ? Uv{u1, v0} : Uv{u0, v1};
    return {i == 0 || i == 3 ? u0 : u1, i < 2 ? v0 : v1};
  }

  /// The point at relative coordinates (s,t) of the bounding rectangle, each in [0,1].
  Uv at(double s, double t) const { return {(1 - s) * u0 + s * u1, (1 - t) * v0 + t * v1}; }

  /// The point of the bounding rectangle nearest to p, which may lie outside, by rounding for
  /// instance.
  Uv clamp(Uv p) const { return {std::clamp(p.u, u0, u1), std::clamp(p.v, v0, v1)}; }

  /// Bring a point of the bounding rectangle into the domain: for a triangle, points beyond the
  /// diagonal are mirrored through its middle, which continues every function continuously.
  Uv fold(Uv p) const {
    if (shape == Shape::Rectangle) return p;
    const double s = (p.u - u0) / (u1 - u0);
    const double t = (p.v - v0) / (v1 - v0);
    return s + t <= 1 ? p : at(1 - t, 1 - s);
  }
};

}  // namespace surfmesh
