// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/tiles/tile_polygon.hh"

namespace surfmesh::detail {

/// Samples of a metric at the centres of the cells of a regular lattice over the box of a polygon:
/// how the metric area inside is spread.
class MetricLattice {
 public:
  /// Cost     64 × 64 queries at most, and O(sides + rows crossed)
  MetricLattice(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                const MetricField& field);

  const UvBox& box() const { return box_; }

  /// False if no sample lies inside.
  bool has_area() const { return area_ > 0; }

  /// The metric extent of the box along u (0) or v (1): the mean length of a step times the extent.
  double extent(int axis) const { return extents_[static_cast<std::size_t>(axis)]; }

  /// The coordinate below which a share of the area lies.
  double coordinate_at(int axis, double share) const;

  /// Metric area inside a part of the polygon, in units of its own.
  double area_in(const TilePolygon& part, const std::vector<TileNode>& nodes) const;

  const QueryCounts& queries() const { return queries_; }

 private:
  static constexpr std::size_t kSide = 64;

  template <class Visit>
  void for_each_inside(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                       Visit visit) const;
  std::array<std::vector<double>, kSide> ends_of_rows(const TilePolygon& polygon,
                                                      const std::vector<TileNode>& nodes) const;
  std::size_t cells_before(int axis, double coordinate) const;
  Uv centre(std::size_t column, std::size_t row) const;

  UvBox box_;
  std::vector<double> densities_;  ///< √det M by row, then by column; 0 outside
  std::array<double, 2> extents_ = {0, 0};
  double area_ = 0;
  QueryCounts queries_;
};

}  // namespace surfmesh::detail
