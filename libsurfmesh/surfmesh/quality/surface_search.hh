// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// A point of a patch and how far it is from the point that was asked for.
struct NearPoint {
  int patch = -1;
  Uv uv;
  double distance = std::numeric_limits<double>::infinity();
  bool is_on_border = false;  ///< of the domain: beyond it there might be nearer points
};

/// Where a search may end before it is at the nearest point.
struct SearchEnd {
  double enough = 0;    ///< at a point that is no farther than this
  double accuracy = 0;  ///< where the distance is too great by about this share of it
};

/// Search downhill from a guess for the point of a surface that is nearest to a point in space.
///
/// The distance decreases with every step. The search stays in the domain, follows its border where
/// that is in the way, and ends at a local minimum.
/// Error    at distance d of a surface of curvature k each step leaves d k of the way to the
///          minimum, until it is below 1e-12 of the domain; 40 steps at most
/// Cost     2 to 5 evaluations of first order for a guess nearby
NearPoint find_near_point(const Surface& surface, const Vec3& point, Uv guess,
                          const SearchEnd& end = {});

/// Finds the nearest points on all patches of a model; samples of the patches provide the guess.
class SurfaceSearch {
 public:
  /// The model must outlive the search.
  /// Cost     at least 64 evaluations per cell of a patch, 100,000 in all for a few cells
  explicit SurfaceSearch(const Model& model);

  /// The nearest point on `patches`, or on all patches if that is empty.
  ///
  /// The search begins inside of trimmed patches, but may end beyond their border.
  /// Error    may be only a local minimum, where two points of a patch are nearly equally far from
  ///          the point, compared with the distance of the samples
  NearPoint nearest(const Vec3& point, const std::vector<int>& patches = {}) const;

  /// The nearest point, sought in `patches`, which are known to be nearby, and in the patches
  /// beside them too, and from the nearest one on, until it is near enough: the samples that are
  /// nearest to a point may all be of other patches than its own, if these are narrow, or close
  /// together.
  /// Cost     as nearest(), and once more for each of those patches
  NearPoint nearest_around(const Vec3& point, std::span<const int> patches, double enough) const;

  /// The points found downhill from the samples that are nearest to a point, the nearest first:
  /// where the surface has several sheets in one place, one on each.
  ///
  /// Error    as for nearest(); at most 8 samples are tried
  std::vector<NearPoint> feet(const Vec3& point) const;

  /// The samples of all patches, none of them where a patch is cut off; those of neighbours in
  /// space mostly follow each other.
  std::vector<Vec3> sample_points() const;

 private:
  struct Sample {
    Vec3 point;
    Uv uv;
    int patch;
  };
  struct Candidates;

  void add_border(int patch);
  void add_samples(int patch, int count);
  NearPoint descend(const Sample& from, const Vec3& point) const;
  void sort_tree(std::size_t first, std::size_t end, int axis);
  /// True if both lead to the same point of a patch.
  bool are_beside(const Sample& a, const Sample& b) const;
  void search(std::size_t first, std::size_t end, int axis, Candidates& candidates) const;

  const Model& model_;
  std::vector<std::vector<int>> beside_;  ///< by patch: those that share a contour with it
  std::vector<Sample> samples_;           ///< a k-d tree: the middle of each range parts it
};

}  // namespace surfmesh
