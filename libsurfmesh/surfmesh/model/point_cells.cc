// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/point_cells.hh"

#include <cmath>

namespace surfmesh {

PointCells::Cell PointCells::cell_of(const Vec3& point) const {
  const double width = 2 * distance_;
  const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / width)); };
  return {index(point.x()), index(point.y()), index(point.z())};
}

void PointCells::add(const Vec3& point) {
  cells_[cell_of(point)].push_back(points_.size());
  points_.push_back(point);
}

std::vector<std::size_t> PointCells::near(const Vec3& point) const {
  const Cell home = cell_of(point);
  std::vector<std::size_t> result;
  for (int k = 0; k < 27; ++k) {
    const auto found =
        cells_.find({home[0] + k % 3 - 1, home[1] + k / 3 % 3 - 1, home[2] + k / 9 - 1});
    if (found == cells_.end()) continue;
    for (const std::size_t i : found->second) {
      if ((point - points_[i]).norm() <= distance_) result.push_back(i);
    }
  }
  return result;
}

}  // namespace surfmesh
