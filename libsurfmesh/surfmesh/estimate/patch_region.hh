// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
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
  struct Segment {
    Uv from;
    Uv to;
  };

  PatchRegion(const Model& model, int patch);

  /// True if the loops cut nothing off the domain.
  bool is_whole() const { return is_whole_; }

  /// True if a point is inside.
  /// Cost     the segments at the same v
  bool contains(Uv uv) const;

  /// The segments that may pass through a triangle, among all or among those of a list.
  std::vector<int> segments_at(const UvTriangle& triangle) const;
  std::vector<int> segments_at(const UvTriangle& triangle, const std::vector<int>& among) const;

 private:
  void add_loop(const Model& model, const PatchLoop& loop);
  void fill_rows(const Domain& domain);
  std::size_t row_of(double v) const;
  const Segment& segment(int i) const { return segments_[static_cast<std::size_t>(i)]; }

  bool is_whole_ = false;
  std::vector<Segment> segments_;
  /// Segments by intervals of v; one that is in several of them is in all their lists.
  std::vector<std::vector<int>> rows_;
  double first_v_ = 0;
  double rows_per_v_ = 0;
};

}  // namespace surfmesh
