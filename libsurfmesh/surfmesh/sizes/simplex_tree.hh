// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh::detail {

/// Vertices of a tetrahedron, or of a triangle: then the last is -1.
using Simplex = std::array<int, 4>;

/// The point of a simplex that is nearest to another point, as weights of its vertices, which are
/// not negative and have the sum 1.
struct NearSimplex {
  std::size_t simplex = 0;
  std::array<double, 4> weights = {};
  double squared_distance = 0;
};

/// A bound from below of a function that is linear in a simplex, or at least not below its values
/// at the vertices as if it were.
struct LinearBound {
  double least = 0;  ///< of the values at the vertices
  Vec3 from;         ///< a vertex
  double value = 0;  ///< there
  Vec3 slope;        ///< in the plane of a triangle

  /// The bound in the part of the simplex that is in a box.
  double in(const Eigen::AlignedBox3d& box) const;
};

/// The bound from the values at the vertices, of which a triangle has three.
/// Pre      as for SimplexTree
LinearBound linear_bound(const std::vector<Vec3>& points, const Simplex& simplex,
                         const std::array<double, 4>& values);

/// Finds the nearest of many triangles and tetrahedra. Immutable; several threads may ask at once.
class SimplexTree {
 public:
  /// Pre      vertices in range; each triangle has an area, each tetrahedron a volume; there is one
  /// Cost     O(n log n)
  SimplexTree(std::vector<Vec3> points, std::vector<Simplex> simplices);

  /// The nearest simplex, with distance 0 inside of a tetrahedron.
  /// Cost     O(log n) near the simplices (tests/bench/background_bench.cc)
  NearSimplex nearest(const Vec3& point) const;

  /// The least values of the simplices below each node of the tree, for least_in.
  std::vector<double> least_by_node(std::span<const LinearBound> bounds) const;

  /// The least of the bounds of simplices whose boxes meet a box; infinity for none.
  /// Cost     O(k + log n) for the k boxes that its border meets
  double least_in(const Eigen::AlignedBox3d& box, std::span<const double> by_node,
                  std::span<const LinearBound> bounds) const;

  const std::vector<Vec3>& points() const { return points_; }
  const std::vector<Simplex>& simplices() const { return simplices_; }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::size_t first = 0;   ///< of its simplices in `order_`
    std::size_t count = 0;   ///< of its simplices; 0 for an inner node
    std::size_t second = 0;  ///< the second child; the first one follows its parent
  };

  std::size_t build(std::size_t first, std::size_t last);
  Eigen::AlignedBox3d box_of(const Simplex& simplex) const;
  void improve(std::size_t simplex, const Vec3& point, NearSimplex& best) const;

  std::vector<Vec3> points_;
  std::vector<Simplex> simplices_;
  std::vector<std::size_t> order_;  ///< indices of simplices, leaf by leaf
  std::vector<Node> nodes_;
};

}  // namespace surfmesh::detail
