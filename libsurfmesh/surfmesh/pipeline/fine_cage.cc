// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/fine_cage.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "surfmesh/core/option_range.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh::detail {
namespace {

/// Fewer contours are no mesh: somebody made them by hand, and elements beside them are few.
constexpr std::size_t kFewContours = 1500;

/// Median length of contours, in elements, below which the cage counts as as fine as its sizes: of
/// shorter ones most have one segment. The meshes of spot, a knob and a cube have 1.06, 1.14 and
/// 0.34; cages that people made have 1.2 and more where each face is a patch.
constexpr double kFineLength = std::numbers::sqrt2;

/// Shares of a contour at which its metric is asked for.
constexpr std::array kStations = {1.0 / 6, 0.5, 5.0 / 6};

bool is_of_cage(const Model& model, const ContourUse& use) {
  return !model.patch(use).cage_faces.empty();
}

double metric_length(const ContourUse& use, const MetricField& field, QueryHint& hint) {
  constexpr double kWidth = 1.0 / 6;  // half of what a station stands for
  double length = 0;
  for (const double t : kStations) {
    const Uv step = use.curve->evaluate(t + kWidth) - use.curve->evaluate(t - kWidth);
    length += std::sqrt(squared_length(field.at(use.curve->evaluate(t), hint), step));
  }
  return length;
}

/// The metric lengths of contours that merely divide a smooth surface.
std::vector<double> inner_lengths(const Model& model,
                                  const std::vector<const MetricField*>& fields) {
  std::vector<double> lengths;
  for (const Contour& contour : model.contours) {
    if (contour.uses.size() != 2 || !contour.is_smooth || contour.is_degenerate) continue;
    const ContourUse& use = contour.uses[0];
    if (!is_of_cage(model, use)) continue;
    QueryHint hint;
    lengths.push_back(metric_length(use, *fields[static_cast<std::size_t>(use.patch)], hint));
  }
  return lengths;
}

/// What helps where the cage is a mesh.
std::string advice(const Model& model) {
  const bool is_of_meshes = std::all_of(
      model.patches.begin(), model.patches.end(),
      [](const Patch& patch) { return patch.cage == nullptr || patch.is_interpolating; });
  if (!is_of_meshes) {
    return fmt::format("if it is a mesh of a surface, {} = interpolate keeps that surface",
                       ranges::kSurface.name);
  }
  return fmt::format("{} = regions may make fewer patches", ranges::kPatches.name);
}

}  // namespace

std::optional<Notice> notice_of_fine_cage(const Model& model,
                                          const std::vector<const MetricField*>& fields) {
  if (model.contours.size() < kFewContours) return std::nullopt;
  std::vector<double> lengths = inner_lengths(model, fields);
  if (lengths.size() < kFewContours) return std::nullopt;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  if (*middle >= kFineLength) return std::nullopt;
  return warning(
      NoticeKind::FineCage,
      fmt::format("the cage is as fine as its sizes: half of the {} edges between its {} patches "
                  "are shorter than {:.2g} elements, and each patch keeps one element at least; "
                  "{}",
                  lengths.size(), model.patches.size(), *middle, advice(model)));
}

}  // namespace surfmesh::detail
