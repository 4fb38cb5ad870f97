// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/segment_distance.hh"

#include <algorithm>

namespace surfmesh {

double segment_distance(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length2 = way.squaredNorm();
  const double share = length2 > 0 ? std::clamp((point - a).dot(way) / length2, 0.0, 1.0) : 0;
  return (point - a - share * way).norm();
}

}  // namespace surfmesh
