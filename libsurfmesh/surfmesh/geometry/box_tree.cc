// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/box_tree.hh"

#include <algorithm>
#include <array>
#include <utility>

namespace surfmesh {
namespace {

/// Boxes in a leaf: comparing a few is cheaper than a level more.
constexpr std::size_t kLeafBoxes = 4;

/// Depth of the hierarchy: it is balanced, so 2^64 boxes fit.
constexpr std::size_t kMaxDepth = 64;

/// False for a box with NaN, too.
bool has_points(const BoxTree::Box& box) { return (box.min().array() <= box.max().array()).all(); }

}  // namespace

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (has_points(boxes_[i])) order_.push_back(i);
  }
  if (!order_.empty()) build(0, order_.size());
}

std::size_t BoxTree::build(std::size_t first, std::size_t last) {
  const std::size_t index = nodes_.size();
  Box all, starts;
  for (std::size_t i = first; i < last; ++i) {
    all.extend(boxes_[order_[i]]);
    starts.extend(boxes_[order_[i]].min());
  }
  nodes_.push_back({all, first, last - first, 0});
  if (last - first <= kLeafBoxes) return index;
  Eigen::Index axis = 0;
  starts.sizes().maxCoeff(&axis);
  const std::size_t half = first + (last - first) / 2;
  const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(half), at(last), [&](std::size_t a, std::size_t b) {
    return std::pair(boxes_[a].min()[axis], a) < std::pair(boxes_[b].min()[axis], b);
  });
  build(first, half);
  const std::size_t second = build(half, last);
  nodes_[index].count = 0;
  nodes_[index].second = second;
  return index;
}

std::size_t BoxTree::visit(const Box& box, const std::function<void(std::size_t)>& found) const {
  if (nodes_.empty()) return 0;
  std::size_t compared = 0, depth = 0;
  std::array<std::size_t, kMaxDepth> stack;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::size_t index = stack[--depth];
    const Node& node = nodes_[index];
    ++compared;
    if (!node.box.intersects(box)) continue;
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      ++compared;
      if (boxes_[order_[i]].intersects(box)) found(order_[i]);
    }
    if (node.count > 0) continue;
    stack[depth++] = node.second;
    stack[depth++] = index + 1;
  }
  return compared;
}

std::vector<std::size_t> BoxTree::meeting(const Box& box) const {
  std::vector<std::size_t> result;
  visit(box, [&](std::size_t i) { result.push_back(i); });
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace surfmesh
