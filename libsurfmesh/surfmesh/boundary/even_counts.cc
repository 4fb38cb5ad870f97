// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/even_counts.hh"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// Metric length that stands for less: ratios to it are finite.
constexpr double kShortest = 0.01;

/// A contour as an edge between two patches, or a patch and the outside.
struct ParityEdge {
  std::size_t contour;
  std::size_t a, b;  ///< patches; their number stands for the outside
  int change = 1;    ///< of the number of segments
  double cost = 0;
};

/// How far a number of segments is from a length, as a ratio.
double misfit(double count, double length) { return std::abs(std::log(count / length)); }

/// The cheaper of one segment more and one less.
void choose_change(const ContourDivision& division, int least, bool may_shrink, ParityEdge& edge) {
  const double length = std::max(division.longest_sum(), kShortest);
  const auto count = static_cast<double>(division.segment_count());
  const double now = misfit(count, length);
  edge.cost = misfit(count + 1, length) - now;
  const bool can_shrink = may_shrink && count - 1 >= least && length <= kLongestUnit * (count - 1);
  if (!can_shrink) return;
  const double fewer = misfit(count - 1, length) - now;
  if (fewer >= edge.cost) return;
  edge.cost = fewer;
  edge.change = -1;
}

std::vector<ParityEdge> parity_edges(const Model& model, const LeastSegments& least,
                                     bool may_shrink, const ContourDivisions& divisions) {
  std::vector<ParityEdge> edges;
  for (std::size_t c = 0; c < divisions.size(); ++c) {
    const Contour& contour = model.contours[c];
    if (!divisions[c] || contour.uses.size() > 2) continue;
    const auto a = static_cast<std::size_t>(contour.uses.front().patch);
    const auto b = contour.uses.size() == 1 ? model.patches.size()
                                            : static_cast<std::size_t>(contour.uses[1].patch);
    if (a == b) continue;
    edges.push_back({c, a, b});
    choose_change(*divisions[c], least(contour), may_shrink, edges.back());
  }
  return edges;
}

/// Finds edges that change the parity of exactly the odd nodes, a T-join: in a minimum spanning
/// tree first, then cheaper around the cycles that the other edges close.
class ParityJoin {
 public:
  ParityJoin(std::size_t node_count, std::vector<ParityEdge> edges)
      : edges_(std::move(edges)), is_taken_(edges_.size(), 0), up_(node_count) {
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const ParityEdge& x, const ParityEdge& y) { return x.cost < y.cost; });
    std::vector<std::vector<std::size_t>> at(node_count);  // by node: its edges in the tree
    DisjointSets joined(node_count);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!joined.unite(edges_[e].a, edges_[e].b)) {
        chords_.push_back(e);
        continue;
      }
      at[edges_[e].a].push_back(e);
      at[edges_[e].b].push_back(e);
    }
    for (std::size_t root = 0; root < node_count; ++root) {
      if (up_[root].depth < 0) hang(root, at);
    }
  }

  /// Pre      each tree has an even number of odd nodes
  std::vector<ParityEdge> join(std::vector<char> is_odd) {
    take_from_tree(is_odd);
    for (int pass = 0; pass < kMostPasses && turn_cycles(); ++pass) {
    }
    std::vector<ParityEdge> result;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (is_taken_[e] != 0) result.push_back(edges_[e]);
    }
    return result;
  }

 private:
  static constexpr int kMostPasses = 8;

  /// Cycles of more edges are not looked at: in a large model there are many of them.
  static constexpr std::size_t kLongestCycle = 64;

  /// The way from a node to the root of its tree.
  struct Up {
    std::size_t node = 0, edge = 0;
    int depth = -1;
  };

  /// Hang a tree up by its root.
  void hang(std::size_t root, const std::vector<std::vector<std::size_t>>& at) {
    up_[root].depth = 0;
    order_.push_back(root);
    for (std::size_t i = order_.size() - 1; i < order_.size(); ++i) {
      const std::size_t node = order_[i];
      for (const std::size_t e : at[node]) {
        const std::size_t other = edges_[e].a == node ? edges_[e].b : edges_[e].a;
        if (up_[other].depth >= 0) continue;
        up_[other] = {node, e, up_[node].depth + 1};
        order_.push_back(other);
      }
    }
  }

  /// From the leaves up to the roots: an odd node hands its oddness on.
  void take_from_tree(std::vector<char>& is_odd) {
    for (auto node = order_.rbegin(); node != order_.rend(); ++node) {
      if (is_odd[*node] == 0 || up_[*node].depth == 0) continue;
      is_taken_[up_[*node].edge] = 1;
      is_odd[up_[*node].node] ^= 1;
    }
  }

  /// Along a cycle, take the edges that are not taken in place of those that are, where that is
  /// cheaper.
  /// Returns  true if it was anywhere
  bool turn_cycles() {
    bool is_any = false;
    for (const std::size_t chord : chords_) {
      if (!collect_cycle(chord)) continue;
      double change = 0;
      for (const std::size_t e : cycle_)
        change += is_taken_[e] != 0 ? -edges_[e].cost : edges_[e].cost;
      if (change >= 0) continue;
      for (const std::size_t e : cycle_) is_taken_[e] ^= 1;
      is_any = true;
    }
    return is_any;
  }

  /// The cycle that an edge closes with the tree.
  /// Returns  false if it is too long
  bool collect_cycle(std::size_t chord) {
    cycle_.assign(1, chord);
    std::size_t a = edges_[chord].a, b = edges_[chord].b;
    while (a != b) {
      if (cycle_.size() == kLongestCycle) return false;
      std::size_t& deeper = up_[a].depth > up_[b].depth ? a : b;
      cycle_.push_back(up_[deeper].edge);
      deeper = up_[deeper].node;
    }
    return true;
  }

  std::vector<ParityEdge> edges_;    ///< the cheapest first
  std::vector<char> is_taken_;       ///< by edge
  std::vector<std::size_t> chords_;  ///< edges outside the trees
  std::vector<Up> up_;               ///< by node
  std::vector<std::size_t> order_;   ///< nodes, each behind the one above it
  std::vector<std::size_t> cycle_;   ///< edges
};

}  // namespace

std::vector<char> odd_patches(const Model& model, const ContourDivisions& divisions) {
  std::vector<char> is_odd(model.patches.size(), 0);
  for (std::size_t c = 0; c < divisions.size(); ++c) {
    if (!divisions[c] || divisions[c]->segment_count() % 2 == 0) continue;
    for (const ContourUse& use : model.contours[c].uses) {
      is_odd[static_cast<std::size_t>(use.patch)] ^= 1;
    }
  }
  return is_odd;
}

void make_patches_even(const Model& model, const LeastSegments& least, bool may_shrink,
                       ContourDivisions& divisions) {
  for (std::size_t c = 0; c < divisions.size(); ++c) {
    if (divisions[c] && model.contours[c].uses.size() > 2) divisions[c]->round_up_to(2);
  }
  std::vector<char> is_odd = odd_patches(model, divisions);
  is_odd.push_back(std::count(is_odd.begin(), is_odd.end(), 1) % 2 == 0 ? 0 : 1);
  ParityJoin graph(is_odd.size(), parity_edges(model, least, may_shrink, divisions));
  for (const ParityEdge& edge : graph.join(std::move(is_odd))) {
    divisions[edge.contour]->change_count(edge.change);
  }
}

}  // namespace surfmesh
