// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/piece_points.hh"

#include <fmt/format.h>

#include "surfmesh/core/error.hh"

namespace surfmesh {

void check_points(const MeshPiece& piece) {
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const Vec3& p = piece.points[i];
    if (p.allFinite()) continue;
    throw Error(ErrorCode::Geometry, fmt::format("the position of vertex {} is ({}, {}, {})",
                                                 piece.ids[i], p.x(), p.y(), p.z()));
  }
}

}  // namespace surfmesh
