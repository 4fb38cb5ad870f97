// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/pole_room.hh"

#include <array>

#include "surfmesh/geometry/predicates.hh"

namespace surfmesh::detail {
namespace {

/// Distance from the pole that is to be clear, in those of the ring.
constexpr double kRoom = 1.5;

using Quad = std::array<Uv, 4>;  ///< counter-clockwise

bool is_inside(const Quad& quad, Uv p) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (orient2d(quad[i], quad[(i + 1) % 4], p) <= 0) return false;
  }
  return true;
}

bool do_cross(Uv a, Uv b, Uv c, Uv d) {
  return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

}  // namespace

bool is_in_the_way(const PoleSide& pole, Uv a, Uv b) {
  const Quad quad = {pole.from, pole.to, lerp(pole.to, pole.after, kRoom),
                     lerp(pole.from, pole.before, kRoom)};
  return is_inside(quad, a) || is_inside(quad, b) || do_cross(quad[2], quad[3], a, b);
}

}  // namespace surfmesh::detail
