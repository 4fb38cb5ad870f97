// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/thin_nodes.hh"

#include <cstddef>
#include <map>
#include <utility>

#include "surfmesh/control/node_interpolation.hh"
#include "surfmesh/metric/conformity.hh"

namespace surfmesh {
namespace {

class Thinning {
 public:
  Thinning(const Surface& surface, const std::vector<ControlNode>& nodes, double precision)
      : surface_(surface), nodes_(nodes), precision_(precision), is_kept_(nodes.size(), 0) {}

  std::vector<ControlNode> run() {
    keep_corners();
    while (add_worst()) {
    }
    return kept();
  }

 private:
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

  /// Keep the worst node of each triangle; false if all conform.
  bool add_worst() {
    const NodeInterpolation interpolation(surface_, kept());
    struct Worst {
      double error = 0;
      std::size_t node = 0;
    };
    std::map<int, Worst> worst;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (is_kept_[i] != 0) continue;
      const auto answer = interpolation.at({nodes_[i].uv, nodes_[i].point, nodes_[i].form});
      const double error = log_conformity(nodes_[i].size, answer.size);
      if (error <= precision_) continue;
      Worst& here = worst[answer.triangle];
      if (error > here.error) here = {error, i};
    }
    for (const auto& [triangle, found] : worst) is_kept_[found.node] = 1;
    return !worst.empty();
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
  return Thinning(surface, nodes, precision).run();
}

}  // namespace surfmesh
