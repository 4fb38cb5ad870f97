// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/thin_nodes.hh"

#include <cstddef>
#include <map>
#include <utility>

#include "surfmesh/control/node_interpolation.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/minimum.hh"

namespace surfmesh {
namespace {

/// Rounds that add one node a triangle. A smooth field is done by then; of noise, and of nodes that
/// a control space merges, each round would find a few more.
constexpr int kRoundsOfWorst = 20;

/// The nodes with those of exactly one point made one, with the minimum of their sizes.
std::vector<ControlNode> merge_coincident(const std::vector<ControlNode>& nodes) {
  std::map<std::pair<double, double>, std::size_t> index;
  std::vector<ControlNode> merged;
  for (const ControlNode& node : nodes) {
    const auto [known, is_new] = index.try_emplace({node.uv.u, node.uv.v}, merged.size());
    if (is_new) {
      merged.push_back(node);
    } else {
      SizeTensor& size = merged[known->second].size;
      size = minimum(size, node.size);
    }
  }
  return merged;
}

class Thinning {
 public:
  Thinning(const Surface& surface, const std::vector<ControlNode>& nodes, double precision)
      : surface_(surface), nodes_(nodes), precision_(precision), is_kept_(nodes.size(), 0) {}

  std::vector<ControlNode> run() {
    keep_corners();
    for (int round = 0;; ++round) {
      const std::vector<Miss> misses = find_misses();
      if (misses.empty()) return kept();
      if (round < kRoundsOfWorst) {
        keep_worst(misses);
      } else {
        for (const Miss& miss : misses) is_kept_[miss.node] = 1;
      }
    }
  }

 private:
  /// A node that the kept ones do not represent, and the triangle that it lies in.
  struct Miss {
    std::size_t node = 0;
    int triangle = -1;
    double error = 0;
  };

  void keep_corners() {
    const Domain domain = surface_.domain();
    for (const auto& [s, t] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
      const Uv corner = domain.at(s, t);
      const Vec3 point = surface_.evaluate(domain.fold(corner), Order::Position).point;
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < nodes_.size(); ++i) {
        const auto distance = [&](std::size_t k) {
          return (nodes_[k].point - point).squaredNorm();
        };
        if (distance(i) < distance(nearest)) nearest = i;
      }
      is_kept_[nearest] = 1;
    }
  }

  std::vector<ControlNode> kept() const {
    std::vector<ControlNode> result;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (is_kept_[i] != 0) result.push_back(nodes_[i]);
    }
    return result;
  }

  std::vector<Miss> find_misses() const {
    const NodeInterpolation interpolation(surface_, kept());
    std::vector<Miss> misses;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (is_kept_[i] != 0) continue;
      const auto answer = interpolation.at({nodes_[i].uv, nodes_[i].point, nodes_[i].form});
      const double error = log_conformity(nodes_[i].size, answer.size);
      if (error > precision_) misses.push_back({i, answer.triangle, error});
    }
    return misses;
  }

  /// Keep the worst node of each triangle.
  void keep_worst(const std::vector<Miss>& misses) {
    std::map<int, Miss> worst;
    for (const Miss& miss : misses) {
      Miss& here = worst[miss.triangle];
      if (miss.error > here.error) here = miss;
    }
    for (const auto& [triangle, miss] : worst) is_kept_[miss.node] = 1;
  }

  const Surface& surface_;
  const std::vector<ControlNode>& nodes_;
  double precision_;
  std::vector<char> is_kept_;
};

}  // namespace

std::vector<ControlNode> thin_nodes(const Surface& surface, const std::vector<ControlNode>& nodes,
                                    double precision) {
  if (nodes.empty()) return {};
  const std::vector<ControlNode> merged = merge_coincident(nodes);
  return Thinning(surface, merged, precision).run();
}

}  // namespace surfmesh
