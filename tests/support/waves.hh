// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <numbers>

#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/sizes/sizing.hh"

/// The wavy surfaces on which control spaces are judged, and sizes for them.
namespace surfmesh::testing {

inline Length units(double length) { return Length::units(length); }

inline Size size_of(double along, double across, double angle = 0) {
  return {units(along), units(across), angle};
}

inline Size size_of(double length) { return size_of(length, length); }

/// Sizing in model units without gradation.
inline Sizing sizing_of(double curvature, double hmin, double hmax, double stretch) {
  return {.curvature = curvature,
          .hmin = units(hmin),
          .hmax = units(hmax),
          .stretch = stretch,
          .grade = 0};
}

/// The surface of eq. (7) with its parameters multiplied by the scales: the same in space.
/// Source   paper, eq. (7)
inline std::shared_ptr<const Surface> paper_wave(double u_scale = 1, double v_scale = 1) {
  return make_callable_surface(
      Domain{-6 * u_scale, 6 * u_scale, -6 * v_scale, 6 * v_scale}, [=](auto u, auto v) {
        const auto x = u / u_scale;
        const auto y = v / v_scale;
        return std::array{x, y, 1.5 * sin(2 * x) * cos(y / 5) * exp(-(x * x + y * y) / 1000)};
      });
}

/// Sizes that ask for about 25,000 triangles on the surface of eq. (7).
inline Sizing paper_sizing() { return sizing_of(0.06858261876789555, 0.02, 1, 5); }

/// z = sin 2u over [0, 2π] × [0, 1]: a division of the domain by four has all its nodes where the
/// curvature is zero.
inline std::shared_ptr<const Surface> sine_wave() {
  return make_callable_surface(Domain{0, 2 * std::numbers::pi, 0, 1}, [](auto u, auto v) {
    return std::array{u, v, sin(2 * u)};
  });
}

/// Flat for u < 0, curved by 4 for u > 0: the curvature jumps.
inline std::shared_ptr<const Surface> half_bent_sheet() {
  return make_callable_surface(Domain{-1, 1, -1, 1}, [](auto u, auto v) {
    const auto twice = u + abs(u);
    return std::array{u, v, 0.5 * twice * twice};
  });
}

}  // namespace surfmesh::testing
