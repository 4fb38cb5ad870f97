// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/model_box.hh"

#include <algorithm>
#include <vector>

#include "surfmesh/geometry/parts.hh"

namespace surfmesh {
namespace {

/// Intervals of each cell of a surface, and of a patch along each side at most.
constexpr int kCellIntervals = 8;
constexpr int kMostIntervals = 100;

/// Intervals of each part of a contour.
constexpr int kPartIntervals = 32;

/// Polylines of the loops of a patch, as segments in its parameters.
using Segments = std::vector<std::pair<Uv, Uv>>;

Segments add_contours(Model& model, const Patch& patch) {
  Segments segments;
  for (const PatchLoop& loop : patch.loops) {
    for (const LoopEntry& entry : loop) {
      const ContourUse& use = model.use(entry);
      Uv before;
      for (const double t : divided_parts(model.contour(entry).breaks, kPartIntervals)) {
        const Uv uv = use.curve->evaluate(t);
        model.box.extend(patch.surface->evaluate(uv, Order::Position).point);
        if (t > 0) segments.push_back({before, uv});
        before = uv;
      }
    }
  }
  return segments;
}

/// The u at which a line of constant v crosses the loops, ascending: inside lies between the first
/// and the second, and so on.
std::vector<double> crossings(const Segments& segments, double v) {
  std::vector<double> at;
  for (const auto& [a, b] : segments) {
    if ((a.v > v) != (b.v > v)) at.push_back(a.u + (v - a.v) / (b.v - a.v) * (b.u - a.u));
  }
  std::sort(at.begin(), at.end());
  return at;
}

bool is_inside(const std::vector<double>& at, double u) {
  return (std::upper_bound(at.begin(), at.end(), u) - at.begin()) % 2 == 1;
}

void add_inside(Model& model, const Patch& patch, const Segments& segments) {
  const CellCount cells = patch.surface->cells();
  const int columns = std::min(kCellIntervals * cells.u, kMostIntervals);
  const int rows = std::min(kCellIntervals * cells.v, kMostIntervals);
  for (int j = 1; j < rows; ++j) {
    const double t = static_cast<double>(j) / rows * cells.v;
    const std::vector<double> at = crossings(segments, patch.surface->from_cells({0, t}).v);
    for (int i = 1; i < columns; ++i) {
      const Uv uv = patch.surface->from_cells({static_cast<double>(i) / columns * cells.u, t});
      if (!is_inside(at, uv.u)) continue;
      model.box.extend(patch.surface->evaluate(uv, Order::Position).point);
    }
  }
}

}  // namespace

void set_box(Model& model) {
  for (const Patch& patch : model.patches) add_inside(model, patch, add_contours(model, patch));
}

}  // namespace surfmesh
