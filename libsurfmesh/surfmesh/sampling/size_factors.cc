// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/size_factors.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

/// Each sweep brings a node halfway to the mean of its neighbours.
constexpr int kSmoothingSweeps = 2;

/// The sum and number of the values that were added.
struct Mean {
  double sum = 0;
  double weight = 0;

  void add(double value, double share = 1) {
    sum += share * value;
    weight += share;
  }
  double value() const { return sum / weight; }
};

}  // namespace

SizeFactors::SizeFactors(const LatticeSpace& lattice)
    : lattice_(lattice), logs_(static_cast<std::size_t>(lattice.node_count()), 0) {}

void SizeFactors::multiply(const std::vector<Wanted>& wanted) {
  if (wanted.empty()) return;
  ++changes_;
  std::vector<double> logs = mean_of(wanted);
  spread(logs);
  for (int sweep = 0; sweep < kSmoothingSweeps; ++sweep) smooth(logs);
  for (std::size_t node = 0; node < logs_.size(); ++node) logs_[node] += logs[node];
}

void SizeFactors::lower(const std::vector<Wanted>& wanted, double greatest) {
  if (wanted.empty()) return;
  ++changes_;
  std::vector<double> least(logs_.size(), 0);
  int near = -1;
  for (const Wanted& w : wanted) {
    const LatticeSpace::Support around = lattice_.support(w.uv, near);
    near = around.cell;
    for (const int node : around.nodes) {
      if (node < 0) continue;
      double& log_factor = least[static_cast<std::size_t>(node)];
      log_factor = std::min(log_factor, w.log_factor);
    }
  }
  for (std::size_t node = 0; node < logs_.size(); ++node) {
    if (least[node] == 0) continue;
    const double own = size_range(lattice_.size(static_cast<int>(node))).least;
    logs_[node] = std::min(logs_[node], std::log(greatest / own)) + least[node];
  }
}

double SizeFactors::at(Uv uv, int& near) const {
  const LatticeSpace::Support around = lattice_.support(uv, near);
  near = around.cell;
  double sum = 0;
  for (std::size_t k = 0; k < around.nodes.size(); ++k) {
    if (around.nodes[k] < 0) continue;
    sum += around.weights[k] * logs_[static_cast<std::size_t>(around.nodes[k])];
  }
  return std::exp(sum);
}

/// The mean of what is wanted around each node; NaN where nothing is.
std::vector<double> SizeFactors::mean_of(const std::vector<Wanted>& wanted) const {
  std::vector<Mean> means(logs_.size());
  int near = -1;
  for (const Wanted& w : wanted) {
    const LatticeSpace::Support around = lattice_.support(w.uv, near);
    near = around.cell;
    for (std::size_t k = 0; k < around.nodes.size(); ++k) {
      if (around.nodes[k] < 0) continue;
      means[static_cast<std::size_t>(around.nodes[k])].add(w.log_factor, around.weights[k]);
    }
  }
  std::vector<double> logs(means.size());
  for (std::size_t node = 0; node < means.size(); ++node) logs[node] = means[node].value();
  return logs;
}

/// Give nodes without a value the mean of their neighbours, from those with one outwards.
void SizeFactors::spread(std::vector<double>& logs) const {
  std::vector<int> empty;
  for (int node = 0; node < lattice_.node_count(); ++node) {
    if (std::isnan(logs[static_cast<std::size_t>(node)])) empty.push_back(node);
  }
  while (!empty.empty()) {
    std::vector<int> left;
    std::vector<std::pair<int, double>> found;
    for (const int node : empty) {
      Mean mean;
      lattice_.for_each_neighbour(node, [&](int other) {
        const double there = logs[static_cast<std::size_t>(other)];
        if (!std::isnan(there)) mean.add(there);
      });
      if (mean.weight > 0) {
        found.emplace_back(node, mean.value());
      } else {
        left.push_back(node);
      }
    }
    // Nodes that no neighbour joins to the others keep their sizes.
    if (found.empty()) {
      for (const int node : left) logs[static_cast<std::size_t>(node)] = 0;
      return;
    }
    for (const auto& [node, value] : found) logs[static_cast<std::size_t>(node)] = value;
    empty = std::move(left);
  }
}

void SizeFactors::smooth(std::vector<double>& logs) const {
  const std::vector<double> before = logs;
  for (int node = 0; node < lattice_.node_count(); ++node) {
    Mean mean;
    lattice_.for_each_neighbour(
        node, [&](int other) { mean.add(before[static_cast<std::size_t>(other)]); });
    double& log_factor = logs[static_cast<std::size_t>(node)];
    if (mean.weight > 0) log_factor = 0.5 * (log_factor + mean.value());
  }
}

}  // namespace surfmesh
