// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage_copies.hh"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

#include "surfmesh/cage/cage_sides.hh"
#include "surfmesh/core/disjoint_sets.hh"

namespace surfmesh {
namespace {

using Faces = std::vector<std::vector<int>>;

/// A face from its least vertex on, in the direction of the lesser of that one's neighbours.
struct Cycle {
  std::vector<int> vertices;
  bool is_reversed = false;
};

Cycle canonical_cycle(const std::vector<int>& face) {
  Cycle cycle{without_repeats(face), false};
  std::vector<int>& v = cycle.vertices;
  if (v.size() < 3) return cycle;
  std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
  if (v.back() < v[1]) {
    std::reverse(v.begin() + 1, v.end());
    cycle.is_reversed = true;
  }
  return cycle;
}

class CopyFinder {
 public:
  explicit CopyFinder(const Cage& cage)
      : faces_(cage.faces), kept_(faces_.size()), is_hole_(faces_.size(), 0) {
    std::iota(kept_.begin(), kept_.end(), 0);
    for (const std::vector<int>& face : faces_) cycles_.push_back(canonical_cycle(face));
    for (const int f : cage.holes) {
      if (f >= 0 && index(f) < is_hole_.size()) is_hole_[index(f)] = 1;
    }
  }

  std::vector<int> run() {
    std::vector<int> order = kept_;
    const auto vertices = [this](int f) -> const std::vector<int>& { return cycle(f).vertices; };
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return vertices(a) < vertices(b); });
    for (auto first = order.begin(); first != order.end();) {
      const auto end = std::find_if(first + 1, order.end(),
                                    [&](int f) { return vertices(f) != vertices(*first); });
      if (end - first > 1 && vertices(*first).size() >= 3) merge_same({first, end});
      first = end;
    }
    if (!pairs_.empty()) merge_pairs();
    return std::move(kept_);
  }

 private:
  /// Two faces of the same vertices in opposite directions.
  struct Pair {
    int first = -1;
    int second = -1;
  };

  /// What the edges of a pair, or of a set of pairs, tell.
  struct PairUses {
    bool have_odd_edge = false;  ///< of three faces or more
    bool meet = false;           ///< two pairs or more are at an edge
    bool end_at_others = false;  ///< an edge has one pair, and faces that are not pairs

    void add(const PairUses& other) {
      have_odd_edge |= other.have_odd_edge;
      meet |= other.meet;
      end_at_others |= other.end_at_others;
    }
    bool are_doubled() const { return have_odd_edge || (meet && !end_at_others); }
  };

  static std::size_t index(int f) { return static_cast<std::size_t>(f); }
  const Cycle& cycle(int f) const { return cycles_[index(f)]; }
  bool is_hole(int f) const { return is_hole_[index(f)] != 0; }

  /// In each direction the first surface is kept, or the first hole if there is none.
  void merge_same(std::span<const int> same) {
    std::array<int, 2> kept = {-1, -1};  // by direction
    for (const int f : same) {
      int& best = kept[cycle(f).is_reversed ? 1 : 0];
      if (best < 0 || (is_hole(best) && !is_hole(f))) best = f;
    }
    for (const int f : same) kept_[index(f)] = kept[cycle(f).is_reversed ? 1 : 0];
    if (kept[0] >= 0 && kept[1] >= 0)
      pairs_.push_back({std::min(kept[0], kept[1]), std::max(kept[0], kept[1])});
  }

  void merge_pairs() {
    pair_of_.assign(faces_.size(), -1);
    turned_.assign(faces_.size(), 0);
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      for (const int f : {pairs_[p].first, pairs_[p].second}) {
        pair_of_[index(f)] = static_cast<int>(p);
      }
    }
    const std::vector<char> is_doubled = find_doubled_pairs();
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      if (!is_doubled[p]) continue;
      const int better = better_of(pairs_[p]);
      kept_[index(better == pairs_[p].first ? pairs_[p].second : pairs_[p].first)] = better;
    }
    for (int& face : kept_) face = kept_[index(face)];  // those that a copy was kept for
  }

  std::vector<char> find_doubled_pairs() {
    std::vector<PairUses> uses(pairs_.size());
    DisjointSets sets(pairs_.size());
    const std::vector<CageSide> sides = sorted_sides(faces_that_are_kept());
    for_each_edge(sides, [&](std::span<const CageSide> edge) { count_uses(edge, uses, sets); });
    for (std::size_t p = 0; p < uses.size(); ++p) uses[sets.find(p)].add(uses[p]);
    std::vector<char> is_doubled;
    for (std::size_t p = 0; p < uses.size(); ++p) {
      is_doubled.push_back(uses[sets.find(p)].are_doubled());
    }
    return is_doubled;
  }

  Faces faces_that_are_kept() const {
    Faces result(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (kept_[f] == static_cast<int>(f)) result[f] = faces_[f];
    }
    return result;
  }

  /// Note what an edge tells of its pairs, and for each face how many others pass it as it does.
  void count_uses(std::span<const CageSide> edge, std::vector<PairUses>& uses, DisjointSets& sets) {
    const auto rising = std::count_if(edge.begin(), edge.end(),
                                      [](const CageSide& side) { return side.is_rising; });
    const auto count = static_cast<std::ptrdiff_t>(edge.size());
    std::vector<std::size_t> pairs;
    for (const CageSide& side : edge) {
      turned_[index(side.face)] += (side.is_rising ? rising : count - rising) - 1;
      const int pair = pair_of_[index(side.face)];
      if (pair >= 0 && pairs_[index(pair)].first == side.face) pairs.push_back(index(pair));
    }
    for (const std::size_t pair : pairs) {
      sets.unite(pair, pairs[0]);
      uses[pair].add({.have_odd_edge = count >= 3 && count % 2 == 1,
                      .meet = pairs.size() > 1,
                      .end_at_others = pairs.size() == 1 && count > 2});
    }
  }

  int better_of(const Pair& pair) const {
    if (is_hole(pair.first) != is_hole(pair.second)) {
      return is_hole(pair.first) ? pair.second : pair.first;
    }
    return turned_[index(pair.first)] <= turned_[index(pair.second)] ? pair.first : pair.second;
  }

  const Faces& faces_;
  std::vector<int> kept_;
  std::vector<char> is_hole_;
  std::vector<Cycle> cycles_;
  std::vector<Pair> pairs_;
  std::vector<int> pair_of_;            ///< by face, -1 for none
  std::vector<std::ptrdiff_t> turned_;  ///< by face: others that pass one of its edges as it does
};

}  // namespace

std::vector<int> find_copies(const Cage& cage) { return CopyFinder(cage).run(); }

}  // namespace surfmesh
