// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/model/loop_segments.hh"

namespace surfmesh {

/// The part of the parameter plane within a loop, which must outlive it.
class LoopRegion {
 public:
  /// Cost     64 evaluations a curve, and O(n log n) for n curves
  explicit LoopRegion(const LoopCurves& loop);

  /// True if a point lies inside of the loop, however near to it.
  ///
  /// Cost     O(log n), for each segment that lies beside the point in the direction of u, and some
  ///          evaluations for each that is near the point
  bool contains(Uv point) const;

  /// A box around the loop: no point outside is inside of the loop.
  const BoxTree::Box& box() const { return box_; }

 private:
  std::vector<BoxTree::Box> boxes() const;
  bool meets_ray(const LoopSegment& segment, Uv point, int divisions) const;

  std::vector<LoopSegment> segments_;
  LoopScale scale_;
  BoxTree tree_;  ///< of the segments in units of the scale, as large as their curves may bulge
  BoxTree::Box box_;
};

/// The parts of the parameter plane within the loops of a patch, which must outlive them.
class LoopRegions {
 public:
  explicit LoopRegions(const std::vector<LoopCurves>& loops);

  /// A box around a loop.
  const BoxTree::Box& box(std::size_t loop) const { return regions_[loop].box(); }

  /// The loops that a point lies inside of, in growing order.
  ///
  /// Cost     O(log n + k) for n loops, of which k have boxes around the point
  std::vector<std::size_t> around(Uv point) const;

  /// True if a point lies in the material: inside of the outer loop, and of no hole.
  bool is_in_material(Uv point) const { return around(point).size() % 2 == 1; }

 private:
  std::vector<LoopRegion> regions_;
  BoxTree tree_;  ///< of the regions
};

}  // namespace surfmesh
