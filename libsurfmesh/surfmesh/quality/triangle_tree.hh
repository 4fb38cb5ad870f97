// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Triangles in space, each as a face or a part of one.
struct Facets {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;  ///< indices of points
  std::vector<int> faces;                     ///< by triangle, the face that it is a part of
};

/// Finds the nearest one of many triangles.
///
/// A hierarchy of boxes. Immutable; several threads may query it at once.
class TriangleTree {
 public:
  /// A triangle, and how far it is from the point asked about.
  struct Nearest {
    double distance = 0;
    std::size_t triangle = 0;
  };

  /// Pre      at least one triangle; indices in range
  /// Cost     O(n log n), 0.3 µs a triangle
  explicit TriangleTree(const Facets& facets);

  /// The triangle that is nearest to a point; of several one of them. `guess` is a triangle nearby,
  /// which makes it faster, as that of a point beside this one.
  ///
  /// Error    rounding; also for triangles without area
  /// Cost     O(log n) for points near the triangles
  Nearest nearest(const Vec3& point, std::size_t guess = 0) const;

 private:
  using Box = Eigen::AlignedBox3d;

  struct Node {
    Box box;
    std::size_t first = 0;   ///< of its triangles in `order_`
    std::size_t count = 0;   ///< 0 for an inner node
    std::size_t second = 0;  ///< the second child; the first one follows its parent
  };

  struct Triangle {
    Vec3 a;
    Vec3 ab;
    Vec3 ac;
    bool is_flat = false;  ///< without area
  };

  std::size_t build(std::size_t first, std::size_t last, const std::vector<Vec3>& middles);
  Box box_of(std::size_t first, std::size_t last) const;
  static Triangle triangle_of(const Facets& facets, std::size_t index);
  static double squared_distance(const Vec3& point, const Triangle& triangle);

  std::vector<Triangle> triangles_;  ///< in the order of the facets
  std::vector<std::size_t> order_;   ///< of triangles, leaf by leaf
  std::vector<Node> nodes_;
};

}  // namespace surfmesh
