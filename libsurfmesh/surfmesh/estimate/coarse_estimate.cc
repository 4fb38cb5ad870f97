// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/estimate/coarse_estimate.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "surfmesh/core/at_location.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/estimate/patch_region.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {
namespace {

/// Cells of a lattice along each side of a patch, and of all patches together.
struct LatticeCells {
  int least;
  int most;
  double in_all;
};

constexpr LatticeCells kOfSizes{8, 32, 128};
constexpr LatticeCells kOfFirstLook{2, 8, 16};
constexpr LatticeCells kOfAreas{4, 32, 64};

/// How much larger the area may be than it looks between samples.
constexpr double kAreaMargin = 2;

int cells_per_side(const Model& model, const LatticeCells& cells) {
  const double patches = static_cast<double>(model.patches.size());
  return std::clamp(static_cast<int>(cells.in_all / std::sqrt(patches)), cells.least, cells.most);
}

/// Call `visit(column, row)` for each cell of a lattice whose middle is inside the region of a
/// patch.
template <class Visit>
void for_each_cell(const Model& model, int patch, int cells, Visit visit) {
  const PatchRegion region(model, patch);
  const Domain domain = model.surface(patch).domain();
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const bool is_beyond = domain.shape == Domain::Shape::Triangle && column + row + 1 > cells;
      const Uv middle = domain.at((column + 0.5) / cells, (row + 0.5) / cells);
      if (!is_beyond && region.contains(middle)) visit(column, row);
    }
  }
}

/// Area in space of one cell of a lattice, from the first form in it.
double cell_area(const Domain& domain, int cells, const FirstFormFactor& form) {
  const double width = (domain.u1 - domain.u0) / cells, height = (domain.v1 - domain.v0) / cells;
  return width * height * form.l11 * form.l22;
}

double area_of(const Surface& surface, int cells) {
  const Domain domain = surface.domain();
  double area = 0;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const Uv uv = domain.fold(domain.at(double(i) / cells, double(j) / cells));
      const Jet jet = surface.evaluate(uv, Order::First);
      area += cell_area(domain, cells, first_form_factor(jet.du, jet.dv));
    }
  }
  return area;
}

/// Samples a field in the cells of a lattice.
class PatchSampler {
 public:
  PatchSampler(const SizeField& field, int cells)
      : field_(field), domain_(field.surface().domain()), cells_(cells) {}

  /// Equal parts of a cell, with the sizes at a corner and at points inside: corners alone may all
  /// be in step with a periodic field.
  std::array<SizedPiece, 3> pieces_of(int column, int row) const {
    return {piece_at(column, row), piece_at(column + 0.2817, row + 0.6473),
            piece_at(column + 0.7236, row + 0.3191)};
  }

 private:
  SizedPiece piece_at(double x, double y) const {
    const SizeField::Sample sample = field_.at(domain_.fold(domain_.at(x / cells_, y / cells_)));
    const SizeRange range = size_range(sample.size);
    return {cell_area(domain_, cells_, sample.form) / 3, range.greatest, range.least};
  }

  const SizeField& field_;
  Domain domain_;
  int cells_;
};

}  // namespace

CoarseEstimate estimate_coarsely(const Model& model, const std::vector<PatchSources>& sources,
                                 const ResolvedSizing& sizing, CoarseLook look) {
  const int cells = cells_per_side(model, look == CoarseLook::First ? kOfFirstLook : kOfSizes);
  std::vector<SizedPatch> likely(sources.size()), least(sources.size());
  share_indices(sources.size(), [&](std::size_t p) {
    at_location(label(model.patches[p]), [&] {
      const SizeField field(*model.patches[p].surface, sizing, sources[p]);
      PatchSampler sampler(field, cells);
      for_each_cell(model, static_cast<int>(p), cells, [&](int column, int row) {
        const auto pieces = sampler.pieces_of(column, row);
        likely[p].pieces.insert(likely[p].pieces.end(), pieces.begin(), pieces.end());
        SizedPiece largest = *std::max_element(
            pieces.begin(), pieces.end(),
            [](const SizedPiece& a, const SizedPiece& b) { return a.l_s * a.l_t < b.l_s * b.l_t; });
        largest.area *= static_cast<double>(pieces.size());
        least[p].pieces.push_back(largest);
      });
    });
  });
  return {TriangleEstimate(std::move(likely)), TriangleEstimate(std::move(least))};
}

double most_triangles(const Model& model, double hmin) {
  const int cells = cells_per_side(model, kOfAreas);
  std::vector<double> areas(model.patches.size(), 0);
  share_indices(model.patches.size(), [&](std::size_t p) {
    at_location(label(model.patches[p]),
                [&] { areas[p] = area_of(*model.patches[p].surface, cells); });
  });
  double area = 0;
  for (const double of_patch : areas) area += of_patch;
  return kAreaMargin * area / (kUnitTriangleArea * hmin * hmin);
}

}  // namespace surfmesh
