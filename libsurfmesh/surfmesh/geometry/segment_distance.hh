// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// The distance of a point from a segment, which may be a point.
double segment_distance(const Vec3& point, const Vec3& a, const Vec3& b);

}  // namespace surfmesh
