// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "surfmesh/tiles/tile_polygon.hh"

/// Polygons of a plane, by hand.
namespace surfmesh::testing {

/// Loops of points as a polygon with its nodes. The outer loop comes first.
struct FlatPolygon {
  FlatPolygon(const std::vector<Uv>& outer) : FlatPolygon(std::vector<std::vector<Uv>>{outer}) {}

  FlatPolygon(const std::vector<std::vector<Uv>>& loops) {
    for (const std::vector<Uv>& loop : loops) {
      detail::TileLoop& copy = sides.loops.emplace_back();
      for (const Uv uv : loop) {
        copy.push_back({static_cast<int>(nodes.size()), static_cast<int>(sides.loops.size()) - 1});
        nodes.push_back({uv, static_cast<int>(nodes.size())});
      }
    }
  }

  detail::TilePolygon sides;
  std::vector<detail::TileNode> nodes;
};

/// A polygon with nodes on its sides, as many as there are units between their ends.
inline std::vector<Uv> with_unit_sides(const std::vector<Uv>& corners) {
  std::vector<Uv> nodes;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Uv a = corners[i], b = corners[(i + 1) % corners.size()];
    const int count = std::max(1, static_cast<int>(std::lround(std::hypot(b.u - a.u, b.v - a.v))));
    for (int k = 0; k < count; ++k) nodes.push_back(lerp(a, b, static_cast<double>(k) / count));
  }
  return nodes;
}

/// The area of a part in the parameters.
inline double area_of(const detail::TilePolygon& polygon,
                      const std::vector<detail::TileNode>& nodes) {
  const auto uv_of = [&nodes](const detail::TileSide& side) {
    return nodes[static_cast<std::size_t>(side.node)].uv;
  };
  double sum = 0;
  for (const detail::TileLoop& loop : polygon.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      sum += 0.5 * cross(uv_of(loop[i]), uv_of(loop[(i + 1) % loop.size()]));
    }
  }
  return sum;
}

}  // namespace surfmesh::testing
