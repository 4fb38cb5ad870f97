// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <queue>
#include <vector>

#include "surfmesh/quad/front_edge.hh"

namespace surfmesh {

/// The front edges in the order in which quads are made at them: by level, then those with more
/// good sides, then the shorter ones.
///
/// The level of the boundary is 0, that of the sides of a quad is one more than that of its base.
/// An edge is put in anew whenever something changes around it; older entries are passed over.
class FrontLevels {
 public:
  /// Put an edge in, or anew with what is measured now.
  /// Cost     O(log n)
  void put(const FrontEdge& edge, int level);

  /// The level with which an edge was put in last.
  int level(HalfedgeHandle heh) const {
    return index(heh) < levels_.size() ? levels_[index(heh)] : 0;
  }

  /// Take the first edge out; invalid if there is none.
  HalfedgeHandle pop();

 private:
  struct Entry {
    int level;
    int good_sides;
    double length;
    HalfedgeHandle heh;
    int stamp;

    /// True if the other one comes first.
    bool operator<(const Entry& other) const;
  };

  std::priority_queue<Entry> entries_;
  std::vector<int> levels_, stamps_;  ///< by halfedge
};

}  // namespace surfmesh
