// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// A triangle in the parameters of a patch.
struct UvTriangle {
  Uv a;
  Uv b;
  Uv c;
};

/// The part of a patch's domain inside its loops, bounded by polylines.
///
/// Error    64 chords per part of a contour
class PatchRegion {
 public:
  /// A chord of the boundary.
  struct Segment {
    Uv from;
    Uv to;
  };

  PatchRegion(const Model& model, int patch);

  /// True if the loops cut nothing off the domain.
  bool is_whole() const { return is_whole_; }

  /// The area inside, in parameters.
  double area() const { return area_; }

  /// True if a point is inside.
  /// Cost     O(1) away from segments; else those beside it in the direction of u: O(√n) for n
  ///          segments spread evenly
  bool contains(Uv uv) const;

  /// The segments that may pass through a triangle, among all or among those of a list.
  std::vector<int> segments_at(const UvTriangle& triangle) const;
  std::vector<int> segments_at(const UvTriangle& triangle, const std::vector<int>& among) const;

 private:
  void add_loop(const Model& model, const PatchLoop& loop);
  /// The cells of a grid that a box covers.
  struct CellRange {
    std::size_t first_column, last_column, first_row, last_row;
  };

  void fill_cells();
  void judge_empty_cells();
  bool is_left_of_odd(const CellRange& own, Uv uv) const;
  CellRange cells_of(std::initializer_list<Uv> points) const;
  const std::vector<int>& cell(std::size_t column, std::size_t row) const {
    return cells_[row * side_ + column];
  }
  const Segment& segment(int i) const { return segments_[static_cast<std::size_t>(i)]; }

  bool is_whole_ = false;
  double area_ = 0;
  std::vector<Segment> segments_;
  Domain domain_;
  std::size_t side_ = 1;  ///< cells along each side of a grid over the domain
  /// Segments by cells, rows along u; one that is in several of them is in all their lists.
  std::vector<std::vector<int>> cells_;
  std::vector<char> is_inside_;  ///< by cell; of those without segments
};

}  // namespace surfmesh
