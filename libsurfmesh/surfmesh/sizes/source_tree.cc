// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/source_tree.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Sizes in a leaf: a box costs about as much as a size.
constexpr int kLeafSizes = 2;

/// Depth of the hierarchy: it is balanced, so 2^64 sizes fit.
constexpr std::size_t kMaxDepth = 64;

Vec3 middle(const PlacedSize& placed) { return 0.5 * (placed.from + placed.to); }

}  // namespace

SourceTree::SourceTree(std::vector<PlacedSize> sizes, double grade)
    : growth_(growth_of_grade(grade)) {
  if (sizes.empty()) return;
  std::vector<int> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(2 * sizes.size());
  build(order, 0, static_cast<int>(order.size()), sizes);
  sizes_.reserve(sizes.size());
  for (const int i : order) sizes_.push_back(std::move(sizes[static_cast<std::size_t>(i)]));
}

SourceTree::Node SourceTree::leaf_over(const std::vector<int>& order, int first, int last,
                                       const std::vector<PlacedSize>& sizes) const {
  Node node;
  node.least = node.rate = std::numeric_limits<double>::infinity();
  for (int i = first; i < last; ++i) {
    const auto index = static_cast<std::size_t>(order[static_cast<std::size_t>(i)]);
    const PlacedSize& placed = sizes[index];
    node.box.extend(placed.from).extend(placed.to);
    node.least = std::min(node.least, least_length(placed));
    node.rate = std::min(node.rate, growth_ * least_ratio(placed));
    node.reach = std::max(node.reach, reach(placed));
  }
  node.first = first;
  node.count = last - first;
  return node;
}

int SourceTree::build(std::vector<int>& order, int first, int last,
                      const std::vector<PlacedSize>& sizes) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back(leaf_over(order, first, last, sizes));
  if (last - first <= kLeafSizes) return index;
  Eigen::Index axis = 0;
  nodes_.back().box.sizes().maxCoeff(&axis);
  const int half = first + (last - first) / 2;
  std::nth_element(order.begin() + first, order.begin() + half, order.begin() + last,
                   [&](int a, int b) {
                     const double x = middle(sizes[static_cast<std::size_t>(a)])[axis];
                     const double y = middle(sizes[static_cast<std::size_t>(b)])[axis];
                     return x != y ? x < y : a < b;
                   });
  build(order, first, half, sizes);
  const int second = build(order, half, last, sizes);
  nodes_[static_cast<std::size_t>(index)].count = 0;
  nodes_[static_cast<std::size_t>(index)].second = second;
  return index;
}

double SourceTree::bound(const Node& node, const Vec3& point) const {
  const double rest = node.box.exteriorDistance(point) - node.reach;
  return rest <= 0 ? node.least : node.least + node.rate * rest;
}

SizeTensor SourceTree::minimum_at(const TangentFrame& frame, const SizeTensor& size) const {
  if (nodes_.empty()) return size;
  SizeTensor result = size;
  double largest = size_range(size).greatest;
  std::array<std::pair<double, int>, kMaxDepth> stack;
  std::size_t depth = 0;
  stack[depth++] = {bound(nodes_[0], frame.point), 0};
  while (depth > 0) {
    const auto [least, index] = stack[--depth];
    if (least >= largest) continue;
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    for (int i = node.first; i < node.first + node.count; ++i) {
      const auto wanted = size_around(sizes_[static_cast<std::size_t>(i)], frame, growth_);
      if (!wanted) continue;
      result = minimum(result, *wanted);
      largest = size_range(result).greatest;
    }
    if (node.count > 0) continue;
    std::pair<double, int> near{bound(nodes_[static_cast<std::size_t>(index + 1)], frame.point),
                                index + 1};
    std::pair<double, int> far{bound(nodes_[static_cast<std::size_t>(node.second)], frame.point),
                               node.second};
    if (far.first < near.first) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return result;
}

}  // namespace surfmesh
