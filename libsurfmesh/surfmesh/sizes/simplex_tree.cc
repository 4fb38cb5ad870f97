// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/simplex_tree.hh"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace surfmesh::detail {
namespace {

/// Simplices in a leaf: asking a few is cheaper than a level more.
constexpr std::size_t kLeafSimplices = 4;

/// Depth of the tree: it is balanced, so 2^64 simplices fit.
constexpr std::size_t kMaxDepth = 64;

/// Share of the numbers of a bound that it is lowered by: more than their rounding.
constexpr double kTreeRounding = 1e-13;

using Weights = std::array<double, 3>;

/// The weight of b for the point of a segment that is nearest to p.
double along(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  return std::clamp(ab.dot(p - a) / ab.squaredNorm(), 0.0, 1.0);
}

/// The nearest point of a triangle, by the region of its plane that p is above.
/// Source   Ericson, Real-Time Collision Detection, section 5.1.5
Weights nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double of_c = d1 * d4 - d3 * d2;
  if (of_c <= 0 && d1 >= 0 && d3 <= 0) {
    const double t = along(p, a, b);
    return {1 - t, t, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double of_b = d5 * d2 - d1 * d6;
  if (of_b <= 0 && d2 >= 0 && d6 <= 0) {
    const double t = along(p, a, c);
    return {1 - t, 0, t};
  }
  const double of_a = d3 * d6 - d5 * d4;
  if (of_a <= 0 && d4 >= d3 && d5 >= d6) {
    const double t = along(p, b, c);
    return {0, 1 - t, t};
  }
  const double scale = 1 / (of_a + of_b + of_c);
  return {1 - scale * (of_b + of_c), scale * of_b, scale * of_c};
}

/// The weights of the corners of a tetrahedron for a point, of which some are negative outside.
std::array<double, 4> weights_in(const Vec3& p, const std::array<Vec3, 4>& corners) {
  const Vec3 a = corners[0] - corners[3], b = corners[1] - corners[3], c = corners[2] - corners[3];
  const Vec3 q = p - corners[3];
  const Vec3 bc = b.cross(c);
  const double scale = 1 / a.dot(bc);
  const double wa = scale * q.dot(bc), wb = scale * a.dot(q.cross(c)),
               wc = scale * a.dot(b.cross(q));
  return {wa, wb, wc, 1 - wa - wb - wc};
}

}  // namespace

SimplexTree::SimplexTree(std::vector<Vec3> points, std::vector<Simplex> simplices)
    : points_(std::move(points)), simplices_(std::move(simplices)), order_(simplices_.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  build(0, order_.size());
}

Eigen::AlignedBox3d SimplexTree::box_of(const Simplex& simplex) const {
  Eigen::AlignedBox3d box;
  for (const int vertex : simplex) {
    if (vertex >= 0) box.extend(points_[static_cast<std::size_t>(vertex)]);
  }
  return box;
}

std::size_t SimplexTree::build(std::size_t first, std::size_t last) {
  const std::size_t index = nodes_.size();
  Eigen::AlignedBox3d all, middles;
  for (std::size_t i = first; i < last; ++i) {
    const Eigen::AlignedBox3d box = box_of(simplices_[order_[i]]);
    all.extend(box);
    middles.extend(box.center());
  }
  nodes_.push_back({all, first, last - first, 0});
  if (last - first <= kLeafSimplices) return index;
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::size_t half = first + (last - first) / 2;
  const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(half), at(last), [&](std::size_t a, std::size_t b) {
    return std::pair(box_of(simplices_[a]).center()[axis], a) <
           std::pair(box_of(simplices_[b]).center()[axis], b);
  });
  build(first, half);
  const std::size_t second = build(half, last);
  nodes_[index].count = 0;
  nodes_[index].second = second;
  return index;
}

/// Take a simplex if it is nearer than the best so far.
void SimplexTree::improve(std::size_t simplex, const Vec3& point, NearSimplex& best) const {
  const Simplex& vertices = simplices_[simplex];
  const auto corner = [&](std::size_t k) -> const Vec3& {
    return points_[static_cast<std::size_t>(vertices[k])];
  };
  const auto try_side = [&](std::size_t i, std::size_t j, std::size_t k) {
    const Weights w = nearest_on_triangle(point, corner(i), corner(j), corner(k));
    const Vec3 nearest = w[0] * corner(i) + w[1] * corner(j) + w[2] * corner(k);
    const double squared = (nearest - point).squaredNorm();
    if (!(squared < best.squared_distance)) return;
    best = {simplex, {}, squared};
    best.weights[i] = w[0];
    best.weights[j] = w[1];
    best.weights[k] = w[2];
  };
  if (vertices[3] < 0) return try_side(0, 1, 2);
  const std::array<double, 4> inner =
      weights_in(point, {corner(0), corner(1), corner(2), corner(3)});
  if (*std::min_element(inner.begin(), inner.end()) >= 0) {
    best = {simplex, inner, 0};
    return;
  }
  // Only a side that the point lies beyond can be the nearest.
  if (inner[3] < 0) try_side(0, 1, 2);
  if (inner[2] < 0) try_side(0, 1, 3);
  if (inner[1] < 0) try_side(0, 2, 3);
  if (inner[0] < 0) try_side(1, 2, 3);
}

NearSimplex SimplexTree::nearest(const Vec3& point) const {
  NearSimplex best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  struct Entry {
    std::size_t node;
    double squared;
  };
  std::array<Entry, kMaxDepth> stack;
  std::size_t depth = 0;
  const auto entry_of = [&](std::size_t node) {
    return Entry{node, nodes_[node].box.squaredExteriorDistance(point)};
  };
  stack[depth++] = entry_of(0);
  while (depth > 0 && best.squared_distance > 0) {
    const Entry entry = stack[--depth];
    if (entry.squared >= best.squared_distance) continue;
    const Node& node = nodes_[entry.node];
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      improve(order_[i], point, best);
    }
    if (node.count > 0) continue;
    const Entry one = entry_of(entry.node + 1), other = entry_of(node.second);
    const bool is_first_nearer = one.squared <= other.squared;
    stack[depth++] = is_first_nearer ? other : one;
    stack[depth++] = is_first_nearer ? one : other;
  }
  return best;
}

double LinearBound::in(const Eigen::AlignedBox3d& box) const {
  const double middle = value + slope.dot(box.center() - from);
  const double change = 0.5 * slope.cwiseAbs().dot(box.sizes());
  const double rounding = kTreeRounding * (std::abs(value) + std::abs(middle) + change);
  return std::max(least, middle - change - rounding);
}

LinearBound linear_bound(const std::vector<Vec3>& points, const Simplex& simplex,
                         const std::array<double, 4>& values) {
  const auto side = [&](std::size_t k) -> Vec3 {
    return points[static_cast<std::size_t>(simplex[k])] -
           points[static_cast<std::size_t>(simplex[0])];
  };
  // The slope has the products with the sides that are the differences of values.
  Eigen::Matrix3d sides;
  Vec3 differences(values[1] - values[0], values[2] - values[0], 0);
  sides.row(0) = side(1);
  sides.row(1) = side(2);
  if (simplex[3] < 0) {
    sides.row(2) = side(1).cross(side(2)).normalized() * side(1).norm();
  } else {
    sides.row(2) = side(3);
    differences.z() = values[3] - values[0];
  }
  LinearBound bound;
  const std::size_t count = simplex[3] < 0 ? 3 : 4;
  bound.least = *std::min_element(values.begin(), values.begin() + count);
  bound.from = points[static_cast<std::size_t>(simplex[0])];
  bound.value = values[0];
  bound.slope = sides.inverse() * differences;
  return bound;
}

std::vector<double> SimplexTree::least_by_node(std::span<const LinearBound> bounds) const {
  std::vector<double> least(nodes_.size(), std::numeric_limits<double>::infinity());
  // Children come after their parents.
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      least[n] = std::min(least[n], bounds[order_[i]].least);
    }
    if (node.count == 0) least[n] = std::min(least[n + 1], least[node.second]);
  }
  return least;
}

double SimplexTree::least_in(const Eigen::AlignedBox3d& box, std::span<const double> by_node,
                             std::span<const LinearBound> bounds) const {
  double least = std::numeric_limits<double>::infinity();
  std::array<std::size_t, kMaxDepth> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::size_t index = stack[--depth];
    const Node& node = nodes_[index];
    if (by_node[index] >= least || !node.box.intersects(box)) continue;
    if (box.contains(node.box)) {
      least = by_node[index];
      continue;
    }
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      const std::size_t simplex = order_[i];
      if (box_of(simplices_[simplex]).intersects(box)) {
        least = std::min(least, bounds[simplex].in(box));
      }
    }
    if (node.count > 0) continue;
    stack[depth++] = node.second;
    stack[depth++] = index + 1;
  }
  return least;
}

}  // namespace surfmesh::detail
