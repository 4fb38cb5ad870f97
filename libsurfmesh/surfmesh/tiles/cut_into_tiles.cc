// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/tiles/cut_into_tiles.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surfmesh/tiles/cut_line.hh"
#include "surfmesh/tiles/metric_lattice.hh"
#include "surfmesh/tiles/tile_polygon.hh"

namespace surfmesh {
namespace {

using detail::MetricLattice;
using detail::TileNode;
using detail::TilePolygon;

/// Lines that are tried on each side of the best one, and how far they lie apart, as a share of the
/// extent.
constexpr int kLines = 15;
constexpr double kLineStep = 0.01;

/// A part of the patch that is to become a number of tiles.
struct Part {
  TilePolygon polygon;
  int count = 1;
  double triangles = 0;
  std::vector<MetricCorner> required_points = {};
};

class Cutter {
 public:
  Cutter(const PatchBoundary& boundary, const TileTask& task)
      : boundary_(boundary),
        task_(task),
        rules_{task.surface, task.field, task.multiple, task.sag} {}

  Tiles run(int first_vertex) {
    const auto points = task_.field.required_points();
    cut({detail::polygon_of(boundary_, nodes_),
         wanted_count(),
         task_.triangles,
         {points.begin(), points.end()}});
    Tiles result;
    result.refused = refused_;
    result.queries = queries_;
    if (done_.size() == 1) {
      result.tiles.push_back({boundary_, task_.triangles, {}});
      return result;
    }
    result.shared_nodes = number_nodes(first_vertex);
    for (Part& part : done_) {
      result.tiles.push_back({detail::boundary_of(part.polygon, nodes_, boundary_), part.triangles,
                              std::move(part.required_points)});
    }
    return result;
  }

 private:
  int wanted_count() const { return static_cast<int>(std::ceil(task_.triangles / task_.most)); }

  void cut(Part part) {
    std::vector<Part> parts;
    if (part.count > 1) {
      parts = halves(part);
      if (parts.empty()) ++refused_;
    }
    if (parts.empty()) {
      done_.push_back(std::move(part));
      return;
    }
    part = {};
    for (Part& half : parts) cut(std::move(half));
  }

  std::vector<Part> halves(const Part& part) {
    const MetricLattice lattice(part.polygon, nodes_, task_.field);
    queries_ += lattice.queries();
    if (!lattice.has_area()) return {};
    const int across = lattice.extent(0) >= lattice.extent(1) ? 0 : 1;
    for (const int axis : {across, 1 - across}) {
      std::vector<TilePolygon> polygons = halves_along(part, lattice, axis);
      if (!polygons.empty()) return dealt_out(part, lattice, std::move(polygons));
    }
    return {};
  }

  std::vector<TilePolygon> halves_along(const Part& part, const MetricLattice& lattice, int axis) {
    const detail::UvBox& box = lattice.box();
    const double extent = axis == 0 ? box.upper.u - box.lower.u : box.upper.v - box.lower.v;
    const double best =
        lattice.coordinate_at(axis, std::floor(0.5 * part.count) / static_cast<double>(part.count));
    for (int line = 0; line <= 2 * kLines; ++line) {
      // 0, +1, −1, +2, −2, …
      const int steps = line % 2 == 1 ? (line + 1) / 2 : -line / 2;
      const double value = best + steps * kLineStep * extent;
      std::vector<TilePolygon> polygons =
          detail::divide_at(part.polygon, nodes_, axis, value, rules_, queries_);
      if (!polygons.empty()) return polygons;
    }
    return {};
  }

  /// Give each half its share of tiles, by its metric area, and of points.
  std::vector<Part> dealt_out(const Part& part, const MetricLattice& lattice,
                              std::vector<TilePolygon> polygons) const {
    std::vector<double> areas;
    double sum = 0;
    for (const TilePolygon& polygon : polygons) {
      areas.push_back(lattice.area_in(polygon, nodes_));
      sum += areas.back();
    }
    std::vector<Part> parts;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const double share = sum > 0 ? areas[i] / sum : 1 / static_cast<double>(polygons.size());
      Part& half = parts.emplace_back();
      half.count = std::max(1, static_cast<int>(std::lround(share * part.count)));
      half.triangles = share * part.triangles;
      const detail::UvBox box = detail::box_of(polygons[i], nodes_);
      std::copy_if(part.required_points.begin(), part.required_points.end(),
                   std::back_inserter(half.required_points),
                   [&box](const MetricCorner& point) { return box.contains(point.uv); });
      half.polygon = std::move(polygons[i]);
    }
    return parts;
  }

  /// Give numbers to the nodes that tiles share.
  /// Returns  how many there are
  int number_nodes(int first) {
    int next = first;
    for (TileNode& node : nodes_) {
      if (node.vertex < 0) node.vertex = next++;
    }
    return next - first;
  }

  const PatchBoundary& boundary_;
  const TileTask& task_;
  detail::CutRules rules_;
  std::vector<TileNode> nodes_;  ///< those of the boundary first
  std::vector<Part> done_;
  std::size_t refused_ = 0;
  QueryCounts queries_;
};

}  // namespace

Tiles cut_into_tiles(PatchBoundary boundary, const TileTask& task, int first_vertex) {
  if (task.most > 0 && task.triangles > task.most) return Cutter(boundary, task).run(first_vertex);
  Tiles whole;
  whole.tiles.push_back({std::move(boundary), task.triangles, {}});
  return whole;
}

void shift_shared_nodes(PatchBoundary& boundary, int first_vertex, int by) {
  for (BoundaryLoop& loop : boundary.loops) {
    for (BoundaryNode& node : loop) {
      if (node.vertex >= first_vertex) node.vertex += by;
    }
  }
}

}  // namespace surfmesh
