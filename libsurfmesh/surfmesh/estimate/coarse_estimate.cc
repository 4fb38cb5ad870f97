// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/estimate/coarse_estimate.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/estimate/patch_region.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {
namespace {

/// Cells of the lattice along each side of a patch, and of all patches together.
constexpr int kLeastCells = 8, kMostCells = 32;
constexpr double kCellsInAll = 128;

/// How much larger the area may be than it looks between samples.
constexpr double kAreaMargin = 2;

int cells_per_side(const Model& model) {
  const double patches = static_cast<double>(model.patches.size());
  return std::clamp(static_cast<int>(kCellsInAll / std::sqrt(patches)), kLeastCells, kMostCells);
}

/// Call `visit(uv, corners)` for each cell of a lattice whose middle is inside the region of a
/// patch, with the indices of its corners in rows along u.
template <class Visit>
void for_each_cell(const Model& model, int patch, int cells, Visit visit) {
  const PatchRegion region(model, patch);
  const Domain domain = model.surface(patch).domain();
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const Uv middle = domain.at((i + 0.5) / cells, (j + 0.5) / cells);
      const bool is_beyond = domain.shape == Domain::Shape::Triangle && i + j + 1 > cells;
      if (is_beyond || !region.contains(middle)) continue;
      const auto corner = static_cast<std::size_t>(j * (cells + 1) + i);
      const auto above = corner + static_cast<std::size_t>(cells + 1);
      visit(std::array{corner, corner + 1, above, above + 1});
    }
  }
}

/// Area in space of one cell of a lattice, from the first form at a corner of it.
double cell_area(const Domain& domain, int cells, const FirstFormFactor& form) {
  const double width = (domain.u1 - domain.u0) / cells, height = (domain.v1 - domain.v0) / cells;
  return width * height * form.l11 * form.l22;
}

/// `value(uv)` at all corners of a lattice, in rows along u.
template <class Value>
auto at_corners(const Domain& domain, int cells, Value value) {
  std::vector<decltype(value(Uv{}))> values;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      values.push_back(value(domain.fold(domain.at(double(i) / cells, double(j) / cells))));
    }
  }
  return values;
}

}  // namespace

CoarseEstimate estimate_coarsely(const Model& model, const std::vector<PatchSources>& sources,
                                 const ResolvedSizing& sizing) {
  const int cells = cells_per_side(model);
  std::vector<SizedPatch> likely(sources.size()), least(sources.size());
  share_indices(sources.size(), [&](std::size_t p) {
    const Surface& surface = *model.patches[p].surface;
    const SizeField field(surface, sizing, sources[p]);
    const Domain domain = surface.domain();
    const auto pieces = at_corners(domain, cells, [&](Uv uv) {
      const SizeField::Sample sample = field.at(uv);
      const SizeRange range = size_range(sample.size);
      return SizedPiece{cell_area(domain, cells, sample.form), range.greatest, range.least};
    });
    for_each_cell(model, static_cast<int>(p), cells, [&](const auto& corners) {
      SizedPiece largest{};
      for (const std::size_t corner : corners) {
        SizedPiece piece = pieces[corner];
        if (piece.l_s * piece.l_t > largest.l_s * largest.l_t) largest = piece;
        piece.area /= 4;
        likely[p].pieces.push_back(piece);
      }
      least[p].pieces.push_back(largest);
    });
  });
  return {TriangleEstimate(std::move(likely)), TriangleEstimate(std::move(least))};
}

double most_triangles(const Model& model, double hmin) {
  const int cells = cells_per_side(model);
  std::vector<double> areas(model.patches.size(), 0);
  share_indices(model.patches.size(), [&](std::size_t p) {
    const Surface& surface = *model.patches[p].surface;
    const Domain domain = surface.domain();
    const auto pieces = at_corners(domain, cells, [&](Uv uv) {
      const Jet jet = surface.evaluate(uv, Order::First);
      return cell_area(domain, cells, first_form_factor(jet.du, jet.dv));
    });
    for (const double area : pieces) areas[p] += area;
  });
  double area = 0;
  for (const double of_patch : areas) area += of_patch;
  return kAreaMargin * area / (kUnitTriangleArea * hmin * hmin);
}

}  // namespace surfmesh
