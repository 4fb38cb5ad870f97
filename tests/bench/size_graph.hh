// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/sizes/placed_size.hh"

/// A judge of meshes that shares nothing with the control space.
namespace surfmesh::judge {

/// A point of a surface with its wanted size, in the tangent frame there.
struct SizedPoint {
  TangentFrame frame;
  SizeTensor size;
};

/// The direction of a contour in the tangent frame of a point on it, and the side of its patch.
struct ContourSide {
  std::size_t point = 0;  ///< of the graph
  double cos = 1;         ///< of the angle from the first tangent axis to the contour's direction
  double sin = 0;
  bool is_forward = true;  ///< as ContourUse
};

/// An orthogonal matrix that takes vectors from the tangent frame of one patch to that of another.
struct Turn {
  double q11 = 1, q12 = 0, q21 = 0, q22 = 1;

  SizeTensor operator()(const SizeTensor& h) const;
};

/// Points with sizes, and ways between them along which sizes grow by the grade.
///
/// Sizes are carried from points to points only, and always grown by the distance. They are never
/// interpolated in between, so that they cannot fall step by step on a way there and back.
class SizeGraph {
 public:
  /// Add a regular grid of points, row by row. Each is linked to all those up to three columns and
  /// rows away that no other hides: 32 directions. Returns the index of its first point.
  ///
  /// Error    distances are up to 1.3 % too long, where 32 directions are equally spaced
  ///          (test SizeGraph.GrowsWithTheDistanceInAllDirections)
  /// Pre      no other points have been added yet
  std::size_t add_grid(int columns, int rows, const std::vector<SizedPoint>& points);

  std::size_t add_point(const SizedPoint& point);

  /// Link two points of one patch that are near each other, both ways.
  void link(std::size_t a, std::size_t b);

  /// Link two patches at one point of a contour, both ways: as if their tangent planes were
  /// unfolded around it.
  void link_across(const ContourSide& a, const ContourSide& b);

  /// Lower the sizes so that along each link they grow by ln(grade) at most per unit of length,
  /// the least ones first.
  ///
  /// Within a patch, tensors are compared in the frames along p_u, as everywhere in the library:
  /// one keeps its angle from p_u on its way. The length is that of the chord. Does nothing if the
  /// grade is 0 (off).
  ///
  /// Differs: no length falls below the least length of both sizes of a link, as that of their
  ///          minimum may. The least lengths thus obey the law for isotropic sizes, whatever the
  ///          number of links (test SizeGraph.KeepsTheLeastSize*)
  /// Cost     10 to 20 µs per point of a grid
  void grade(double grade);

  const SizeTensor& size(std::size_t point) const { return points_[point].size; }
  std::size_t count() const { return points_.size(); }

 private:
  using Index = std::uint32_t;

  struct Grid {
    std::size_t first;
    int columns;
    int rows;
  };

  struct Across {
    Index to;
    Turn turn;
  };

  /// A point whose size has been lowered, by its lesser length.
  using Entry = std::pair<double, Index>;

  void sort_links();
  void push(std::size_t point);
  void spread(std::size_t from);
  void spread_in_grid(std::size_t from);
  void relax(std::size_t from, std::size_t to);
  void lower(std::size_t point, const SizeTensor& size, double least_fall);
  double length_m(std::size_t from, const Vec3& step, double distance) const;

  std::vector<SizedPoint> points_;
  std::vector<Grid> grids_;
  std::vector<std::pair<Index, Index>> links_;    ///< sorted by their first point
  std::vector<std::pair<Index, Across>> across_;  ///< likewise
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::vector<char> is_queued_;
  double growth_ = 0;
};

}  // namespace surfmesh::judge
