// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// A point as OpenSubdiv's interpolation wants it.
struct Primvar {
  Vec3 point = Vec3::Zero();

  void Clear() { point.setZero(); }
  void AddWithWeight(const Primvar& other, double weight) { point += weight * other.point; }
};

}  // namespace surfmesh
