// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/coincident_points.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "surfmesh/core/buckets.hh"

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
    int nearest = -1;
    for_each_cell_near(point, [&](const Cell& cell) { look_into(cell, point, nearest); });
    return nearest;
  }

  void add(int index) { indices_.emplace(key_of(index), index); }

  /// A number for the cell of a point, evenly spread.
  std::uint64_t key_of(int index) const { return key(cell_of(at(index))); }

  /// True if a point may be within the tolerance of another one. `count_of` tells how many points
  /// have a key.
  template <class CountOf>
  bool may_have_another(int index, const CountOf& count_of) const {
    std::size_t count = 0;
    for_each_cell_near(at(index), [&](const Cell& cell) { count += count_of(key(cell)); });
    return count > 1;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  /// Call `visit` for the cells that come within the tolerance of a point, and are next to it.
  template <class Visit>
  void for_each_cell_near(const Vec3& point, Visit visit) const {
    const Cell first = cell_of(point - Vec3::Constant(tolerance_));
    const Cell last = cell_of(point + Vec3::Constant(tolerance_));
    for (std::int64_t i = first[0]; i <= last[0]; ++i) {
      for (std::int64_t j = first[1]; j <= last[1]; ++j) {
        for (std::int64_t k = first[2]; k <= last[2]; ++k) visit(Cell{i, j, k});
      }
    }
  }

  const Vec3& at(int index) const { return points_[static_cast<std::size_t>(index)]; }

  /// All points are in one cell where they are too far from each other for numbers of cells.
  Cell cell_of(const Vec3& point) const {
    if (!(width_ > 0) || !std::isfinite(width_) || !std::isfinite(tolerance_)) return {};
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

/// How often keys come up.
class KeyCounts {
 public:
  explicit KeyCounts(const std::vector<std::uint64_t>& keys) : sorted_(Buckets::kCount) {
    const Buckets buckets(keys);
    share_indices(sorted_.size(), [&](std::size_t bucket) {
      sorted_[bucket].reserve(buckets[bucket].size());
      for (const std::uint32_t i : buckets[bucket]) sorted_[bucket].push_back(keys[i]);
      std::sort(sorted_[bucket].begin(), sorted_[bucket].end());
    });
  }

  std::size_t operator()(std::uint64_t key) const {
    const std::vector<std::uint64_t>& keys = sorted_[Buckets::bucket_of(key)];
    const auto [begin, end] = std::equal_range(keys.begin(), keys.end(), key);
    return static_cast<std::size_t>(end - begin);
  }

 private:
  std::vector<std::vector<std::uint64_t>> sorted_;  ///< by bucket
};

/// By point: 0 where no other one is within the tolerance, as of nearly all of them.
std::vector<char> may_coincide(const PointGrid& grid, std::size_t count) {
  std::vector<std::uint64_t> keys(count);
  share_ranges(count, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) keys[i] = grid.key_of(static_cast<int>(i));
  });
  const KeyCounts counts(keys);
  std::vector<char> may_coincide(count, 0);
  share_ranges(count, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      may_coincide[i] = grid.may_have_another(static_cast<int>(i), counts) ? 1 : 0;
    }
  });
  return may_coincide;
}

}  // namespace

std::vector<int> coincident_points(const std::vector<Vec3>& points, double tolerance) {
  PointGrid grid(points, tolerance);
  const std::vector<char> is_in_doubt = may_coincide(grid, points.size());
  std::vector<int> result(points.size());
  std::iota(result.begin(), result.end(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_in_doubt[i] == 0) continue;
    const int found = grid.find(points[i]);
    if (found < 0) {
      grid.add(static_cast<int>(i));
    } else {
      result[i] = found;
    }
  }
  return result;
}

}  // namespace surfmesh
