// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/boundary_corners.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surfmesh {
namespace {

BoundaryCorner corner_between(const RootFrame& frame, Uv ahead, Uv back) {
  const Uv x = frame.in_frame(ahead), y = frame.in_frame(back);
  const double length = std::sqrt(x.u * x.u + x.v * x.v);
  double angle = std::atan2(cross(x, y), x.u * y.u + x.v * y.v);
  if (!(angle > 0)) angle += 2 * std::numbers::pi;
  const long quarters = std::lround(angle / (0.5 * std::numbers::pi));
  return {{x.u / length, x.v / length}, angle, std::max(1, static_cast<int>(quarters))};
}

}  // namespace

std::vector<BoundaryCorner> boundary_corners(const PolyMesh& mesh,
                                             std::span<const std::size_t> loop_sizes) {
  const auto uv = require(mesh, keys::vertex_uv);
  const auto metric = require(mesh, keys::vertex_metric);
  std::vector<BoundaryCorner> corners;
  std::size_t first = 0;
  for (const std::size_t size : loop_sizes) {
    const auto point = [&](std::size_t i) {
      return mesh.property(uv, VertexHandle(static_cast<int>(first + i % size)));
    };
    for (std::size_t i = 0; i < size; ++i) {
      const RootFrame frame(mesh.property(metric, VertexHandle(static_cast<int>(first + i))));
      const Uv at = point(i);
      corners.push_back(corner_between(frame, point(i + 1) - at, point(i + size - 1) - at));
    }
    first += size;
  }
  return corners;
}

}  // namespace surfmesh
