// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/cage/face_neighbours.hh"
#include "surfmesh/cage/face_shapes.hh"
#include "surfmesh/cage/gather_regions.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Lays planes under connected faces, with a margin around them. What it is made from must outlive
/// it.
class RegionChartMaker {
 public:
  RegionChartMaker(const FaceNeighbours& neighbours, const std::vector<FaceShape>& shapes,
                   const std::vector<std::shared_ptr<const Surface>>& surfaces)
      : neighbours_(neighbours), shapes_(shapes), surfaces_(surfaces), marks_(shapes.size(), 0) {}

  /// The region of the faces, which are ascending; nothing if they turn too far, or their chart
  /// would cover or touch itself.
  std::optional<FaceRegion> make(const std::vector<int>& faces, const Vec3& axis);

  /// Two connected halves of connected faces: those nearer to one of two ends.
  std::vector<std::vector<int>> halves(const std::vector<int>& faces);

 private:
  int& mark(int face) { return marks_[static_cast<std::size_t>(face)]; }
  const FaceShape& shape(int face) const { return shapes_[static_cast<std::size_t>(face)]; }

  ChartFrame frame_of(const std::vector<int>& faces, const Vec3& axis) const;
  int last_reached(const std::vector<int>& faces, const std::vector<int>& starts);
  std::vector<int> margin_of(const FaceRegion& region, int rings);
  bool may_be_in_margin(int face, const Vec3& axis) const;
  bool lies_side_by_side(const std::vector<int>& faces, const ChartFrame& frame) const;

  const FaceNeighbours& neighbours_;
  const std::vector<FaceShape>& shapes_;
  const std::vector<std::shared_ptr<const Surface>>& surfaces_;
  std::vector<int> marks_;  ///< by face
  int mark_ = 0;            ///< of the region at hand
};

}  // namespace surfmesh
