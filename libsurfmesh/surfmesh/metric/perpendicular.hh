// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "surfmesh/core/values.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {

/// The step of unit length in a metric that is perpendicular to an edge in it, to the left of the
/// edge.
///
/// Pre      `length` is the metric length of the edge, above 0
inline Uv unit_left_of(Uv edge, double length, const Metric& m) {
  const Uv image{m.m11 * edge.u + m.m12 * edge.v, m.m12 * edge.u + m.m22 * edge.v};
  const double scale = 1 / (std::sqrt(determinant(m)) * length);
  return {-scale * image.v, scale * image.u};
}

}  // namespace surfmesh
