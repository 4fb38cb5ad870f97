// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/node_discs.hh"

#include <algorithm>

#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/minimum.hh"

namespace surfmesh {
namespace {

using Box = Eigen::AlignedBox3d;

Box box_of(const ControlNode& node) {
  const Vec3 reach = Vec3::Constant(node.radius + node.outer_radius);
  return Box(node.point - reach, node.point + reach);
}

/// Collects the discs whose boxes contain a point.
struct DiscsAround {
  bool intersectVolume(const Box& box) const { return box.contains(point); }

  bool intersectObject(int node) {
    found.push_back(node);
    return false;  // go on
  }

  const Vec3& point;
  std::vector<int> found;
};

}  // namespace

std::optional<SizeTensor> extended_size(const ControlNode& node, const Vec3& point) {
  const double distance = (point - node.point).norm();
  if (distance <= node.radius) return node.inner;
  if (distance > node.radius + node.outer_radius) return std::nullopt;
  return lerp(node.inner, node.outer, (distance - node.radius) / node.outer_radius);
}

NodeDiscs::NodeDiscs(const std::vector<ControlNode>& nodes) {
  std::vector<int> indices;
  std::vector<Box> boxes;
  for (const ControlNode& node : nodes) {
    if (node.radius + node.outer_radius <= 0) continue;
    indices.push_back(static_cast<int>(nodes_.size()));
    boxes.push_back(box_of(node));
    nodes_.push_back(node);
  }
  tree_.init(indices.begin(), indices.end(), boxes.begin(), boxes.end());
}

std::optional<SizeTensor> NodeDiscs::size_at(const Vec3& point) const {
  if (nodes_.empty()) return std::nullopt;
  DiscsAround around{point, {}};
  Eigen::BVIntersect(tree_, around);
  std::sort(around.found.begin(), around.found.end());
  std::optional<SizeTensor> least;
  for (const int i : around.found) {
    const auto size = extended_size(nodes_[static_cast<std::size_t>(i)], point);
    if (size) least = least ? minimum(*least, *size) : *size;
  }
  return least;
}

}  // namespace surfmesh
