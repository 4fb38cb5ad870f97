// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/triangle_tree.hh"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace surfmesh {
namespace {

/// Triangles of a leaf: with fewer, boxes take more time than they save.
constexpr std::size_t kLeaf = 4;

/// Depth of the hierarchy, which is halved at each step: 2^62 triangles are enough.
constexpr std::size_t kDeepest = 64;

/// Below this square of the sine of its angle a triangle counts as flat: its height is 1e-10 of its
/// sides, which is what the distance of a point in it is wrong by.
constexpr double kFlatTriangle = 1e-20;

/// The square of the distance from a segment that begins at a, d long.
double from_segment(const Vec3& from_a, const Vec3& d) {
  const double whole = d.squaredNorm();
  const double t = whole > 0 ? std::clamp(d.dot(from_a) / whole, 0.0, 1.0) : 0;
  return (from_a - t * d).squaredNorm();
}

/// The square of the distance from a line a + t d, at the t of this share of its length.
double from_line(const Vec3& from_a, const Vec3& d, double part, double whole) {
  return (from_a - part / whole * d).squaredNorm();
}

}  // namespace

TriangleTree::TriangleTree(const Facets& facets) {
  std::vector<Vec3> middles;
  triangles_.reserve(facets.triangles.size());
  middles.reserve(facets.triangles.size());
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    const Triangle& triangle = triangles_.emplace_back(triangle_of(facets, t));
    middles.push_back(triangle.a + (triangle.ab + triangle.ac) / 3);
  }
  order_.resize(triangles_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  nodes_.reserve(triangles_.size());
  build(0, order_.size(), middles);
}

TriangleTree::Triangle TriangleTree::triangle_of(const Facets& facets, std::size_t index) {
  const auto& [a, b, c] = facets.triangles[index];
  Triangle triangle;
  triangle.a = facets.points[static_cast<std::size_t>(a)];
  triangle.ab = facets.points[static_cast<std::size_t>(b)] - triangle.a;
  triangle.ac = facets.points[static_cast<std::size_t>(c)] - triangle.a;
  triangle.is_flat = triangle.ab.cross(triangle.ac).squaredNorm() <=
                     kFlatTriangle * triangle.ab.squaredNorm() * triangle.ac.squaredNorm();
  return triangle;
}

std::size_t TriangleTree::build(std::size_t first, std::size_t last,
                                const std::vector<Vec3>& middles) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({box_of(first, last), first, last - first, 0});
  if (last - first <= kLeaf) return node;
  Box spread;
  for (std::size_t i = first; i < last; ++i) spread.extend(middles[order_[i]]);
  Eigen::Index axis = 0;
  spread.sizes().maxCoeff(&axis);
  const std::size_t half = first + (last - first) / 2;
  const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(half), at(last), [&](std::size_t a, std::size_t b) {
    return middles[a][axis] < middles[b][axis];
  });
  nodes_[node].count = 0;
  build(first, half, middles);
  const std::size_t second = build(half, last, middles);
  nodes_[node].second = second;
  return node;
}

TriangleTree::Box TriangleTree::box_of(std::size_t first, std::size_t last) const {
  Box box;
  for (std::size_t i = first; i < last; ++i) {
    const Triangle& t = triangles_[order_[i]];
    box.extend(t.a).extend(t.a + t.ab).extend(t.a + t.ac);
  }
  return box;
}

TriangleTree::Nearest TriangleTree::nearest(const Vec3& point, std::size_t guess) const {
  std::size_t best = guess < triangles_.size() ? guess : 0;
  double least = squared_distance(point, triangles_[best]);
  std::array<std::pair<double, std::size_t>, kDeepest> waiting;
  std::size_t count = 0;
  const auto wait = [&](std::size_t node) {
    const double distance = nodes_[node].box.squaredExteriorDistance(point);
    if (distance < least) waiting[count++] = {distance, node};
  };
  wait(0);
  while (count > 0) {
    const auto [distance, index] = waiting[--count];
    if (distance >= least) continue;
    const Node& node = nodes_[index];
    if (node.count == 0) {
      // The nearer child comes first, which is the last one that waits.
      const double to_first = nodes_[index + 1].box.squaredExteriorDistance(point);
      const double to_second = nodes_[node.second].box.squaredExteriorDistance(point);
      const bool is_second_nearer = to_second < to_first;
      wait(is_second_nearer ? index + 1 : node.second);
      wait(is_second_nearer ? node.second : index + 1);
      continue;
    }
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      const double square = squared_distance(point, triangles_[order_[i]]);
      if (square >= least) continue;
      least = square;
      best = order_[i];
    }
  }
  return {std::sqrt(least), best};
}

/// Source   Ericson, Real-time collision detection (2005), section 5.1.5
double TriangleTree::squared_distance(const Vec3& point, const Triangle& triangle) {
  const Vec3 &ab = triangle.ab, &ac = triangle.ac, from_a = point - triangle.a;
  if (triangle.is_flat) {
    return std::min(
        {from_segment(from_a, ab), from_segment(from_a, ac), from_segment(from_a - ab, ac - ab)});
  }
  const double d1 = ab.dot(from_a), d2 = ac.dot(from_a);
  if (d1 <= 0 && d2 <= 0) return from_a.squaredNorm();
  const Vec3 from_b = from_a - ab;
  const double d3 = ab.dot(from_b), d4 = ac.dot(from_b);
  if (d3 >= 0 && d4 <= d3) return from_b.squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return from_line(from_a, ab, d1, d1 - d3);
  const Vec3 from_c = from_a - ac;
  const double d5 = ab.dot(from_c), d6 = ac.dot(from_c);
  if (d6 >= 0 && d5 <= d6) return from_c.squaredNorm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return from_line(from_a, ac, d2, d2 - d6);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    return from_line(from_b, ac - ab, d4 - d3, (d4 - d3) + (d5 - d6));
  }
  const double sum = va + vb + vc;
  return (from_a - vb / sum * ab - vc / sum * ac).squaredNorm();
}

}  // namespace surfmesh
