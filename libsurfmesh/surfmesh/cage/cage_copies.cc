// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage_copies.hh"

#include <algorithm>
#include <numeric>
#include <span>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/cage/cage_sides.hh"

namespace surfmesh {
namespace {

using Faces = std::vector<std::vector<int>>;

/// A face from its least vertex on, in the direction of the lesser of that one's neighbours.
struct Circle {
  std::vector<int> vertices;
  bool is_reversed = false;
};

Circle circle_of(const std::vector<int>& face) {
  Circle circle{without_repeats(face), false};
  std::vector<int>& v = circle.vertices;
  if (v.size() < 3) return circle;
  std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
  if (v.back() < v[1]) {
    std::reverse(v.begin() + 1, v.end());
    circle.is_reversed = true;
  }
  return circle;
}

class CopyFinder {
 public:
  explicit CopyFinder(const Faces& faces) : faces_(faces), kept_(faces.size()) {
    std::iota(kept_.begin(), kept_.end(), 0);
    for (const std::vector<int>& face : faces) circles_.push_back(circle_of(face));
  }

  std::vector<int> run() {
    std::vector<int> order = kept_;
    const auto vertices = [this](int f) -> const std::vector<int>& { return circle(f).vertices; };
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return vertices(a) < vertices(b); });
    for (auto first = order.begin(); first != order.end();) {
      const auto end = std::find_if(first + 1, order.end(),
                                    [&](int f) { return vertices(f) != vertices(*first); });
      if (end - first > 1 && vertices(*first).size() >= 3) merge_same(first, end);
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

  const Circle& circle(int f) const { return circles_[static_cast<std::size_t>(f)]; }
  int& kept(int f) { return kept_[static_cast<std::size_t>(f)]; }

  template <class Iterator>
  void merge_same(Iterator first, Iterator end) {
    int other = -1;  // the first that runs in the other direction
    for (auto f = first + 1; f != end; ++f) {
      if (circle(*f).is_reversed == circle(*first).is_reversed) {
        kept(*f) = *first;
      } else if (other < 0) {
        other = *f;
      } else {
        kept(*f) = other;
      }
    }
    if (other >= 0) pairs_.push_back({*first, other});
  }

  void merge_pairs() {
    Faces left;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      left.push_back(kept_[f] == static_cast<int>(f) ? faces_[f] : std::vector<int>());
    }
    const std::vector<CageSide> sides = sorted_sides(left);
    odd_.assign(faces_.size(), 0);
    turned_.assign(faces_.size(), 0);
    for_each_edge(sides, [this](std::span<const CageSide> edge) { look_at(edge); });
    for (const Pair& pair : pairs_) {
      if (odd_[static_cast<std::size_t>(pair.first)] == 0) continue;
      const bool is_first_better = turned_[static_cast<std::size_t>(pair.first)] <=
                                   turned_[static_cast<std::size_t>(pair.second)];
      const int copy = is_first_better ? pair.second : pair.first;
      const int better = is_first_better ? pair.first : pair.second;
      for (int& face : kept_) {
        if (face == copy) face = better;
      }
    }
  }

  /// Count for the faces of an edge whether it is odd, and the others that pass it as they do.
  void look_at(std::span<const CageSide> edge) {
    const auto rising = std::count_if(edge.begin(), edge.end(),
                                      [](const CageSide& side) { return side.is_rising; });
    const auto count = static_cast<std::ptrdiff_t>(edge.size());
    for (const CageSide& side : edge) {
      const auto f = static_cast<std::size_t>(side.face);
      if (count >= 3 && count % 2 == 1) odd_[f] = 1;
      turned_[f] += (side.is_rising ? rising : count - rising) - 1;
    }
  }

  const Faces& faces_;
  std::vector<Circle> circles_;
  std::vector<int> kept_;
  std::vector<Pair> pairs_;
  std::vector<char> odd_;  ///< by face: it has an edge of an odd number of faces, three or more
  std::vector<std::ptrdiff_t> turned_;  ///< by face: faces that pass one of its edges as it does
};

}  // namespace

std::vector<int> find_copies(const Faces& faces) { return CopyFinder(faces).run(); }

}  // namespace surfmesh
