// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// From a unit square to another one that lies rotated in it, with its corner `rotation` at (0,0)
/// of the first.
inline Uv into_turned_square(Uv uv, int rotation) {
  switch (rotation) {
    case 1:
      return {1 - uv.v, uv.u};
    case 2:
      return {1 - uv.u, 1 - uv.v};
    case 3:
      return {uv.v, 1 - uv.u};
    default:
      return uv;
  }
}

/// The way back.
inline Uv out_of_turned_square(Uv uv, int rotation) {
  return into_turned_square(uv, (4 - rotation) % 4);
}

}  // namespace surfmesh
