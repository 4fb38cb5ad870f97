// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/coincident_points.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace surfmesh {
namespace {

/// Least width of a cell as a share of the diagonal, for tolerances of almost nothing: numbers of
/// cells are then exact as doubles, and points in the same cell differ by rounding only.
constexpr double kLeastCell = 1e-15;

/// A cell is so many tolerances wide: most points then look into one cell only.
constexpr double kCellWidth = 8;

/// Finds points by the cell of a regular grid that they lie in.
class PointGrid {
 public:
  PointGrid(const std::vector<Vec3>& points, double tolerance)
      : points_(points), tolerance_(tolerance) {
    for (const Vec3& point : points) box_.extend(point);
    width_ = std::max(kCellWidth * tolerance, kLeastCell * box_.diagonal().norm());
  }

  /// The nearest of the points added that is within the tolerance, -1 for none.
  int find(const Vec3& point) const {
    const Cell first = cell_of(point - Vec3::Constant(tolerance_));
    const Cell last = cell_of(point + Vec3::Constant(tolerance_));
    int nearest = -1;
    for (std::int64_t i = first[0]; i <= last[0]; ++i) {
      for (std::int64_t j = first[1]; j <= last[1]; ++j) {
        for (std::int64_t k = first[2]; k <= last[2]; ++k) look_into({i, j, k}, point, nearest);
      }
    }
    return nearest;
  }

  void add(int index) { indices_.emplace(key(cell_of(at(index))), index); }

 private:
  using Cell = std::array<std::int64_t, 3>;

  const Vec3& at(int index) const { return points_[static_cast<std::size_t>(index)]; }

  Cell cell_of(const Vec3& point) const {
    if (!(width_ > 0)) return {};
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
      cell[static_cast<std::size_t>(axis)] =
          static_cast<std::int64_t>(std::floor((point[axis] - box_.min()[axis]) / width_));
    }
    return cell;
  }

  /// Of all bits of the numbers. Cells that share a key do no harm, for distances are compared.
  static std::uint64_t key(const Cell& cell) {
    std::uint64_t key = 0;
    for (const std::int64_t number : cell) key = mix(key ^ static_cast<std::uint64_t>(number));
    return key;
  }

  /// Source   Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014
  static std::uint64_t mix(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
  }

  /// Of points at the same distance the first one counts, whatever the order in the table.
  void look_into(const Cell& cell, const Vec3& point, int& nearest) const {
    const auto [begin, end] = indices_.equal_range(key(cell));
    for (auto entry = begin; entry != end; ++entry) {
      const int index = entry->second;
      const double distance = (at(index) - point).norm();
      if (distance > tolerance_) continue;
      const double best = nearest < 0 ? tolerance_ : (at(nearest) - point).norm();
      if (nearest < 0 || distance < best || (distance == best && index < nearest)) nearest = index;
    }
  }

  const std::vector<Vec3>& points_;
  double tolerance_;
  double width_ = 0;
  Eigen::AlignedBox3d box_;
  std::unordered_multimap<std::uint64_t, int> indices_;
};

}  // namespace

std::vector<int> coincident_points(const std::vector<Vec3>& points, double tolerance) {
  PointGrid grid(points, tolerance);
  std::vector<int> result;
  result.reserve(points.size());
  for (const Vec3& point : points) {
    const int own = static_cast<int>(result.size());
    const int found = grid.find(point);
    if (found < 0) grid.add(own);
    result.push_back(found < 0 ? own : found);
  }
  return result;
}

}  // namespace surfmesh
