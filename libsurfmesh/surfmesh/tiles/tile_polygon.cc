// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/tiles/tile_polygon.hh"

#include <algorithm>
#include <limits>
#include <numeric>

namespace surfmesh::detail {
namespace {

double coordinate(Uv uv, int axis) { return axis == 0 ? uv.u : uv.v; }

Uv uv_of(const std::vector<TileNode>& nodes, int node) {
  return nodes[static_cast<std::size_t>(node)].uv;
}

/// Twice the area inside a loop; below 0 for a hole.
double double_area(const TileLoop& loop, const std::vector<TileNode>& nodes) {
  const Uv origin = uv_of(nodes, loop.front().node);
  double sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += cross(uv_of(nodes, loop[i].node) - origin, uv_of(nodes, loop[i + 1].node) - origin);
  }
  return sum;
}

/// True if a point that is on no side lies inside a loop.
bool is_inside(const TileLoop& loop, const std::vector<TileNode>& nodes, Uv point) {
  bool is_in = false;
  Uv a = uv_of(nodes, loop.back().node);
  for (const TileSide& side : loop) {
    const Uv b = uv_of(nodes, side.node);
    if ((a.v < point.v) != (b.v < point.v)) {
      const double u = a.u + (point.v - a.v) / (b.v - a.v) * (b.u - a.u);
      if (u > point.u) is_in = !is_in;
    }
    a = b;
  }
  return is_in;
}

/// The loops of the parts of a polygon, found by turning into every cut that is met.
class LoopTrace {
 public:
  LoopTrace(const TilePolygon& polygon, const std::vector<TileCut>& cuts)
      : polygon_(polygon), cuts_(cuts) {
    for (const TileLoop& loop : polygon.loops) {
      is_taken_.emplace_back(loop.size(), 0);
      leaving_.emplace_back(loop.size(), -1);
    }
    for (std::size_t c = 0; c < cuts.size(); ++c) {
      leaving(cuts[c].from) = static_cast<int>(2 * c);
      leaving(cuts[c].to) = static_cast<int>(2 * c + 1);
    }
    loop_of_.resize(2 * cuts.size());
  }

  void run() {
    for_each_side(polygon_, [this](SidePlace place) {
      if (is_taken_[place.loop][place.side] == 0) trace(place);
    });
  }

  const std::vector<TileLoop>& loops() const { return loops_; }

  /// The loop on the left of a cut, seen from its start (direction 0) or from its end (1).
  std::size_t loop_of(std::size_t cut, std::size_t direction) const {
    return loop_of_[2 * cut + direction];
  }

 private:
  int& leaving(SidePlace place) { return leaving_[place.loop][place.side]; }

  void trace(SidePlace start) {
    TileLoop& loop = loops_.emplace_back();
    SidePlace place = start;
    do {
      is_taken_[place.loop][place.side] = 1;
      loop.push_back(at(polygon_, place));
      place = next(polygon_, place);
      if (const int cut = leaving(place); cut >= 0) place = follow(static_cast<std::size_t>(cut));
    } while (place != start);
  }

  /// Go along a cut, as seen from the end that is told by its last bit.
  /// Returns  the side behind it
  SidePlace follow(std::size_t directed) {
    const TileCut& cut = cuts_[directed / 2];
    const bool is_back = directed % 2 == 1;
    TileLoop& loop = loops_.back();
    loop_of_[directed] = loops_.size() - 1;
    loop.push_back({at(polygon_, is_back ? cut.to : cut.from).node});
    if (is_back) {
      for (auto it = cut.inner.rbegin(); it != cut.inner.rend(); ++it) loop.push_back({*it});
    } else {
      for (const int node : cut.inner) loop.push_back({node});
    }
    return is_back ? cut.from : cut.to;
  }

  const TilePolygon& polygon_;
  const std::vector<TileCut>& cuts_;
  std::vector<std::vector<char>> is_taken_;
  std::vector<std::vector<int>> leaving_;  ///< the directed cut that begins at a side's node; or -1
  std::vector<TileLoop> loops_;
  std::vector<std::size_t> loop_of_;  ///< by directed cut
};

/// A run of sides along the ring of a pole.
struct RingRun {
  int fan;
  int first_step;
  std::vector<int> nodes;  ///< of the tile's list, both ends included
};

/// Sides of a loop from one that does not go on with the ring of the one before it.
TileLoop begun_at_ring(const TileLoop& loop) {
  TileLoop result = loop;
  const auto start =
      std::adjacent_find(loop.begin(), loop.end(), [](const TileSide& a, const TileSide& b) {
        return a.fan != b.fan || (a.fan >= 0 && b.step != a.step + 1);
      });
  if (start != loop.end())
    std::rotate(result.begin(), result.begin() + (start + 1 - loop.begin()), result.end());
  return result;
}

std::vector<RingRun> ring_runs(const TileLoop& loop, int offset) {
  std::vector<RingRun> runs;
  const int count = static_cast<int>(loop.size());
  for (int i = 0; i < count; ++i) {
    const TileSide& side = loop[static_cast<std::size_t>(i)];
    if (side.fan < 0) continue;
    const bool goes_on = i > 0 && loop[static_cast<std::size_t>(i - 1)].fan == side.fan &&
                         loop[static_cast<std::size_t>(i - 1)].step + 1 == side.step;
    if (!goes_on) runs.push_back({side.fan, side.step, {offset + i}});
    runs.back().nodes.push_back(offset + (i + 1 == count ? 0 : i + 1));
  }
  return runs;
}

/// The part of a fan along a part of its ring.
PoleFan part_of(const PoleFan& fan, const RingRun& run) {
  PoleFan part = fan;
  const auto whole = static_cast<int>(fan.ring.size()) - 1;
  const int last_step = run.first_step + static_cast<int>(run.nodes.size()) - 1;
  part.ring = run.nodes;
  part.first_share = static_cast<double>(run.first_step) / whole;
  part.last_share = static_cast<double>(last_step) / whole;
  if (run.first_step > 0) part.contour_to = -1;
  if (last_step < whole) part.contour_from = -1;
  return part;
}

}  // namespace

std::size_t TilePolygon::side_count() const {
  return std::accumulate(loops.begin(), loops.end(), std::size_t{0},
                         [](std::size_t sum, const TileLoop& loop) { return sum + loop.size(); });
}

TilePolygon polygon_of(const PatchBoundary& boundary, std::vector<TileNode>& nodes) {
  TilePolygon polygon;
  std::vector<TileSide*> sides;
  for (const BoundaryLoop& loop : boundary.loops) {
    TileLoop& copy = polygon.loops.emplace_back();
    for (const BoundaryNode& node : loop) {
      copy.push_back({static_cast<int>(nodes.size()), node.contour});
      nodes.push_back({node.uv, node.vertex});
    }
  }
  for (TileLoop& loop : polygon.loops) {
    for (TileSide& side : loop) sides.push_back(&side);
  }
  for (std::size_t f = 0; f < boundary.fans.size(); ++f) {
    const PoleFan& fan = boundary.fans[f];
    for (std::size_t k = 0; k + 1 < fan.ring.size(); ++k) {
      const auto node = static_cast<std::size_t>(fan.ring[k]);
      sides[node]->fan = static_cast<int>(f);
      sides[node]->step = static_cast<int>(k);
      nodes[node].can_end_cut = k % static_cast<std::size_t>(fan.segments_per_face) == 0;
    }
  }
  return polygon;
}

UvBox box_of(const TilePolygon& polygon, const std::vector<TileNode>& nodes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  UvBox box{{infinity, infinity}, {-infinity, -infinity}};
  for (const TileLoop& loop : polygon.loops) {
    for (const TileSide& side : loop) {
      const Uv uv = uv_of(nodes, side.node);
      box.lower = {std::min(box.lower.u, uv.u), std::min(box.lower.v, uv.v)};
      box.upper = {std::max(box.upper.u, uv.u), std::max(box.upper.v, uv.v)};
    }
  }
  return box;
}

std::vector<LineCrossing> crossings(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                                    int axis, double value) {
  std::vector<LineCrossing> found;
  for_each_side(polygon, [&](SidePlace place) {
    const Uv a = uv_of(nodes, at(polygon, place).node);
    const Uv b = uv_of(nodes, at(polygon, next(polygon, place)).node);
    const double from = coordinate(a, axis), to = coordinate(b, axis);
    if ((from < value) == (to < value)) return;
    const double share = (value - from) / (to - from);
    found.push_back({coordinate(lerp(a, b, share), 1 - axis), place, share});
  });
  std::sort(found.begin(), found.end(),
            [](const LineCrossing& a, const LineCrossing& b) { return a.along < b.along; });
  return found;
}

CutPolygons divide(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                   const std::vector<TileCut>& cuts) {
  LoopTrace trace(polygon, cuts);
  trace.run();
  const std::vector<TileLoop>& loops = trace.loops();
  CutPolygons result;
  std::vector<std::size_t> part_of(loops.size());
  std::vector<std::size_t> holes;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (double_area(loops[i], nodes) > 0) {
      part_of[i] = result.parts.size();
      result.parts.push_back({{loops[i]}});
    } else {
      holes.push_back(i);
    }
  }
  for (const std::size_t hole : holes) {
    const TileLoop& loop = loops[hole];
    // Loops may touch in nodes, but not along sides.
    const Uv middle = lerp(uv_of(nodes, loop[0].node), uv_of(nodes, loop[1].node), 0.5);
    const auto around = std::find_if(
        result.parts.begin(), result.parts.end(),
        [&](const TilePolygon& part) { return is_inside(part.loops.front(), nodes, middle); });
    if (around == result.parts.end()) return {};
    part_of[hole] = static_cast<std::size_t>(around - result.parts.begin());
    around->loops.push_back(loop);
  }
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    result.beside.push_back({part_of[trace.loop_of(c, 0)], part_of[trace.loop_of(c, 1)]});
  }
  return result;
}

PatchBoundary boundary_of(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                          const PatchBoundary& of_patch) {
  PatchBoundary boundary;
  boundary.patch = of_patch.patch;
  int offset = 0;
  for (const TileLoop& loop : polygon.loops) {
    const TileLoop sides = begun_at_ring(loop);
    for (const RingRun& run : ring_runs(sides, offset)) {
      boundary.fans.push_back(part_of(of_patch.fans[static_cast<std::size_t>(run.fan)], run));
    }
    BoundaryLoop& copy = boundary.loops.emplace_back();
    for (const TileSide& side : sides) {
      const TileNode& node = nodes[static_cast<std::size_t>(side.node)];
      copy.push_back({node.uv, node.vertex, side.contour});
    }
    offset += static_cast<int>(sides.size());
  }
  return boundary;
}

}  // namespace surfmesh::detail
