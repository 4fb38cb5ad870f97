// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Points in cubes, with fast queries of those within a distance that is small as seen from the
/// distances of most.
class PointCells {
 public:
  /// Units    distance in model units, positive; coordinates below 1e18 times that
  explicit PointCells(double distance) : distance_(distance) {}

  /// Give a point the next number, from 0 on.
  void add(const Vec3& point);

  /// The numbers of the points within the distance.
  ///
  /// Cost     O(log n + k) for k points in the cubes around
  std::vector<std::size_t> near(const Vec3& point) const;

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const Vec3& point) const;

  double distance_;
  std::vector<Vec3> points_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace surfmesh
