// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

struct FaceEdge;

/// A box in the parameters of a surface.
struct LoopBox {
  double u0 = std::numeric_limits<double>::infinity();
  double u1 = -std::numeric_limits<double>::infinity();
  double v0 = std::numeric_limits<double>::infinity();
  double v1 = -std::numeric_limits<double>::infinity();

  double width() const { return u1 - u0; }
  double height() const { return v1 - v0; }

  void extend(Uv uv);
  void extend(const LoopBox& other);

  /// The whole periods by which another box comes inside this one, or nearest to it. A period of 0
  /// is none.
  Uv shift_inside(const LoopBox& other, double period_u, double period_v) const;
};

/// The box of a loop.
///
/// Error    the extremes of curves are found to about 1e-9 of the box (samples, then a search)
LoopBox box_of(const std::vector<FaceEdge>& loop);

}  // namespace surfmesh
