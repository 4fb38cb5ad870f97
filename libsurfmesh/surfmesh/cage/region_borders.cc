// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/region_borders.hh"

#include <opensubdiv/sdc/crease.h>

#include <algorithm>
#include <cstddef>

namespace surfmesh {
namespace {

using Side = FaceNeighbours::Side;

class BorderFinder {
 public:
  BorderFinder(const FaceNeighbours& neighbours, const std::vector<FaceRegion>& regions)
      : neighbours_(neighbours),
        regions_(regions),
        region_of_(static_cast<std::size_t>(neighbours.face_count()), -1),
        vertices_(static_cast<std::size_t>(neighbours.level().GetNumVertices())),
        chain_of_(static_cast<std::size_t>(neighbours.level().GetNumEdges()), -1) {
    for (std::size_t r = 0; r < regions.size(); ++r) {
      for (const int face : regions[r].faces) region_of_[index(face)] = static_cast<int>(r);
    }
  }

  RegionBorders run() {
    std::vector<std::vector<FaceLoop>> loops;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      loops.push_back(face_loops(neighbours_, regions_[r].faces, region_of_, static_cast<int>(r)));
      for (const FaceLoop& loop : loops.back()) meet(loop, regions_[r].is_chart);
    }
    for (const auto& of_region : loops) {
      for (const FaceLoop& loop : of_region) add_ends(loop);
    }
    RegionBorders borders;
    borders.loops.resize(regions_.size());
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      for (const FaceLoop& loop : loops[r]) {
        borders.loops[r].push_back(chains_of(loop, static_cast<int>(r), borders.chains));
      }
    }
    return borders;
  }

 private:
  struct Vertex {
    int edges = 0;         ///< of borders
    float sharpness = -1;  ///< of the first of them
    bool is_end = false;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const OpenSubdiv::Far::TopologyLevel& level() const { return neighbours_.level(); }
  Vertex& vertex(int v) { return vertices_[index(v)]; }

  /// Count the edges of a loop at their vertices. chain_of_ marks those that were counted.
  void meet(const FaceLoop& loop, bool is_chart) {
    constexpr int kCounted = -2;
    for (const Side side : loop) {
      const int edge = neighbours_.edge(side);
      const int ends[] = {neighbours_.vertex(side), neighbours_.end_vertex(side)};
      for (const int end : ends) {
        Vertex& v = vertex(end);
        if (!is_chart || level().GetVertexSharpness(end) > 0 || ends[0] == ends[1]) v.is_end = true;
      }
      if (chain_of_[index(edge)] == kCounted) continue;
      chain_of_[index(edge)] = kCounted;
      for (const int end : ends) {
        Vertex& v = vertex(end);
        if (++v.edges == 1) v.sharpness = level().GetEdgeSharpness(edge);
        v.is_end |= v.edges > 2 || v.sharpness != level().GetEdgeSharpness(edge);
        v.is_end |= is_corner_of_hole(edge, end);
      }
    }
  }

  /// Beside faces that are left out a true boundary runs along edges that have faces on both sides.
  /// It is smooth on creases and through regular vertices; at others it has a corner.
  bool is_corner_of_hole(int edge, int end) const {
    const auto faces = level().GetEdgeFaces(edge);
    if (faces.size() != 2 || OpenSubdiv::Sdc::Crease::IsInfinite(level().GetEdgeSharpness(edge)) ||
        (region_of_[index(faces[0])] >= 0 && region_of_[index(faces[1])] >= 0)) {
      return false;
    }
    const int regular = neighbours_.corner_count() == 3 ? 6 : 4;
    return level().GetVertexFaces(end).size() != regular ||
           level().GetVertexEdges(end).size() != regular;
  }

  bool is_end(int v) const {
    const Vertex& at = vertices_[index(v)];
    return at.is_end || at.edges != 2;
  }

  /// Add ends, so that a loop has three at least and no chain is closed: with large elements a
  /// chain may become one segment.
  void add_ends(const FaceLoop& loop) {
    const auto is_end_at = [&](std::size_t i) {
      return is_end(neighbours_.vertex(loop[i % loop.size()]));
    };
    const auto end_at = [&](std::size_t i) {
      vertex(neighbours_.vertex(loop[i % loop.size()])).is_end = true;
    };
    std::size_t first = 0;
    while (first < loop.size() && !is_end_at(first)) ++first;
    if (first == loop.size()) end_at(first = 0);
    std::size_t ends = 0;
    for (std::size_t from = first; from < first + loop.size();) {
      std::size_t to = from + 1;
      while (!is_end_at(to)) ++to;
      const bool is_closed = neighbours_.vertex(loop[from % loop.size()]) ==
                             neighbours_.vertex(loop[to % loop.size()]);
      if (is_closed && to - from >= 3) {
        end_at(from + (to - from) / 3);
        end_at(from + 2 * (to - from) / 3);
      }
      from = to;
    }
    for (std::size_t i = 0; i < loop.size(); ++i) ends += is_end_at(i) ? 1 : 0;
    if (ends == 2) end_at(middle_of_longest_run(loop));
  }

  /// The place in a loop, in the middle of the longest run between two ends.
  std::size_t middle_of_longest_run(const FaceLoop& loop) const {
    std::size_t last_end = 0, longest = 0, middle = 0;
    bool has_end = false;
    for (std::size_t i = 0; i < 2 * loop.size(); ++i) {
      if (!is_end(neighbours_.vertex(loop[i % loop.size()]))) continue;
      if (has_end && i - last_end > longest) {
        longest = i - last_end;
        middle = last_end + longest / 2;
      }
      last_end = i;
      has_end = true;
    }
    return middle;
  }

  std::vector<ChainUse> chains_of(FaceLoop loop, int region, std::vector<BorderChain>& chains) {
    const auto first = std::find_if(loop.begin(), loop.end(),
                                    [this](Side side) { return is_end(neighbours_.vertex(side)); });
    std::rotate(loop.begin(), first, loop.end());
    std::vector<ChainUse> uses;
    for (auto from = loop.begin(); from != loop.end();) {
      const auto last = std::find_if(
          from, loop.end(), [this](Side side) { return is_end(neighbours_.end_vertex(side)); });
      uses.push_back(add_use({from, last + 1}, region, chains));
      from = last + 1;
    }
    return uses;
  }

  ChainUse add_use(FaceLoop sides, int region, std::vector<BorderChain>& chains) {
    const int first_edge = neighbours_.edge(sides.front());
    int chain = chain_of_[index(first_edge)];
    if (chain < 0) {
      chain = static_cast<int>(chains.size());
      chains.push_back(chain_of(sides));
      for (const Side side : sides) chain_of_[index(neighbours_.edge(side))] = chain;
    }
    BorderChain& known = chains[index(chain)];
    // Around a closed chain its first edge tells the direction.
    const bool is_forward =
        known.start == neighbours_.vertex(sides.front()) &&
        (known.uses.empty() || neighbours_.edge(known.uses[0].sides.front()) == first_edge);
    if (!is_forward) std::reverse(sides.begin(), sides.end());
    known.uses.push_back({region, is_forward, std::move(sides)});
    return {chain, static_cast<int>(known.uses.size()) - 1};
  }

  BorderChain chain_of(const FaceLoop& sides) const {
    BorderChain chain;
    chain.start = neighbours_.vertex(sides.front());
    chain.second = neighbours_.end_vertex(sides.front());
    chain.end = neighbours_.end_vertex(sides.back());
    chain.is_smooth = !OpenSubdiv::Sdc::Crease::IsInfinite(
        level().GetEdgeSharpness(neighbours_.edge(sides.front())));
    chain.is_free = std::all_of(sides.begin(), sides.end(), [this](Side side) {
      const Side other = neighbours_.across(side);
      return other.face >= 0 && is_chart(side.face) && is_chart(other.face);
    });
    return chain;
  }

  bool is_chart(int face) const {
    const int region = region_of_[index(face)];
    return region >= 0 && regions_[index(region)].is_chart;
  }

  const FaceNeighbours& neighbours_;
  const std::vector<FaceRegion>& regions_;
  std::vector<int> region_of_;  ///< by face
  std::vector<Vertex> vertices_;
  std::vector<int> chain_of_;  ///< by edge
};

}  // namespace

RegionBorders find_borders(const FaceNeighbours& neighbours,
                           const std::vector<FaceRegion>& regions) {
  return BorderFinder(neighbours, regions).run();
}

}  // namespace surfmesh
