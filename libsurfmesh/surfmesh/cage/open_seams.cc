// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/open_seams.hh"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "surfmesh/cage/cage_sides.hh"
#include "surfmesh/cage/weld_cage.hh"

namespace surfmesh {
namespace {

/// Farthest distance of vertices that may be meant to be one, as a share of the diagonal: as for
/// the sides of patches.
constexpr double kNearShare = 1e-4;

/// The same as a share of an edge: ends of the same edge are far from each other.
constexpr double kEdgeShare = 0.1;

/// An edge by its vertices, and by those that stand for them.
struct PlacedEdge {
  std::array<int, 2> stand_ins;
  std::array<int, 2> vertices;
  bool is_open = false;
};

class SeamFinder {
 public:
  explicit SeamFinder(const Cage& cage) : cage_(cage), sides_(sorted_sides(cage.faces)) {
    for_each_edge(sides_, [this](std::span<const CageSide> edge) {
      edges_.push_back({{}, {edge[0].low, edge[0].high}, edge.size() == 1});
    });
  }

  OpenSeams run(double least) {
    const double shortest = shortest_open_edge(least);
    if (shortest == std::numeric_limits<double>::infinity()) return {};
    const double near =
        std::max(least, std::min(kNearShare * diagonal(cage_), kEdgeShare * shortest));
    const std::vector<int> stand_ins = coincident_vertices(cage_, near);
    for (PlacedEdge& edge : edges_) place(edge, stand_ins);
    std::stable_sort(edges_.begin(), edges_.end(), [](const PlacedEdge& a, const PlacedEdge& b) {
      return a.stand_ins < b.stand_ins;
    });
    for (auto first = edges_.begin(); first != edges_.end();) {
      const auto end = std::find_if(first + 1, edges_.end(), [&](const PlacedEdge& edge) {
        return edge.stand_ins != first->stand_ins;
      });
      if (end - first > 1 && first->stand_ins[0] != first->stand_ins[1]) add({first, end});
      first = end;
    }
    return seams_;
  }

 private:
  const Vec3& point(int vertex) const { return cage_.points[static_cast<std::size_t>(vertex)]; }

  /// The shortest that is longer than `least`; infinity for none.
  double shortest_open_edge(double least) const {
    double shortest = std::numeric_limits<double>::infinity();
    for (const PlacedEdge& edge : edges_) {
      const double length = (point(edge.vertices[1]) - point(edge.vertices[0])).norm();
      if (edge.is_open && length > least) shortest = std::min(shortest, length);
    }
    return shortest;
  }

  static void place(PlacedEdge& edge, const std::vector<int>& stand_ins) {
    const int a = stand_ins[static_cast<std::size_t>(edge.vertices[0])];
    const int b = stand_ins[static_cast<std::size_t>(edge.vertices[1])];
    if (a > b) std::swap(edge.vertices[0], edge.vertices[1]);
    edge.stand_ins = {std::min(a, b), std::max(a, b)};
  }

  /// Edges in the same place.
  void add(std::span<const PlacedEdge> edges) {
    for (const PlacedEdge& edge : edges) {
      if (!edge.is_open) continue;
      if (seams_.edges++ == 0) seams_.first = edge.vertices;
      for (std::size_t end = 0; end < 2; ++end) {
        const double gap = (point(edge.vertices[end]) - point(edge.stand_ins[end])).norm();
        seams_.gap = std::max(seams_.gap, gap);
      }
    }
  }

  const Cage& cage_;
  std::vector<CageSide> sides_;
  std::vector<PlacedEdge> edges_;
  OpenSeams seams_;
};

}  // namespace

OpenSeams find_open_seams(const Cage& cage, double least) { return SeamFinder(cage).run(least); }

}  // namespace surfmesh
