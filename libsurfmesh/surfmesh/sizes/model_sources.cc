// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/model_sources.hh"

#include <fmt/format.h>

#include <cstddef>
#include <set>

#include "surfmesh/core/at_location.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/sizes/contour_curvature.hh"
#include "surfmesh/sizes/features.hh"
#include "surfmesh/sizes/proximity.hh"
#include "surfmesh/sizes/source_place.hh"
#include "surfmesh/sizes/table_sizes.hh"

namespace surfmesh {
namespace {

void append(std::vector<PlacedSize>& all, const std::vector<PlacedSize>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Sizes that a contour wants on the patches that share it.
std::vector<PlacedSize> sizes_of_contour(const Model& model, const Contour& contour,
                                         const ResolvedSizing& sizing) {
  const ContourUse& use = contour.uses.front();
  const CurveOnSurface curve(model.patch(use).surface, use.curve, contour.breaks);
  std::vector<PlacedSize> sizes;
  if (sizing.contour_curvature && sizing.follows_curvature()) {
    append(sizes, contour_curvature_sizes(curve, sizing));
  }
  if (sizing.features) append(sizes, feature_sizes(curve, sizing));
  return sizes;
}

/// By contour.
std::vector<std::vector<PlacedSize>> contour_sizes(const Model& model,
                                                   const ResolvedSizing& sizing) {
  std::vector<std::vector<PlacedSize>> sizes(model.contours.size());
  share_indices(model.contours.size(), [&](std::size_t c) {
    const Contour& contour = model.contours[c];
    if (contour.is_smooth || contour.is_degenerate || contour.uses.empty()) return;
    const int first = contour.uses.front().patch;
    sizes[c] =
        at_location(fmt::format("contour {} on patch {}", contour.name, model.patch(first).name),
                    [&] { return sizes_of_contour(model, contour, sizing); });
  });
  return sizes;
}

/// By patch.
std::vector<std::vector<PlacedSize>> boundary_sizes(const Model& model,
                                                    const ResolvedSizing& sizing) {
  std::vector<std::vector<PlacedSize>> sizes(model.patches.size());
  const auto of_contours = contour_sizes(model, sizing);
  for (std::size_t c = 0; c < of_contours.size(); ++c) {
    std::set<int> patches;
    for (const ContourUse& use : model.contours[c].uses) patches.insert(use.patch);
    for (const int patch : patches) append(sizes[static_cast<std::size_t>(patch)], of_contours[c]);
  }
  const auto of_gaps = proximity_sizes(model, sizing);
  for (std::size_t p = 0; p < of_gaps.size(); ++p) append(sizes[p], of_gaps[p]);
  return sizes;
}

}  // namespace

std::vector<PatchSources> model_sources(const Model& model, const Sources& sources,
                                        const ResolvedSizing& sizing) {
  auto boundary = boundary_sizes(model, sizing);
  auto fans = wide_fans(model);
  std::vector<PatchSources> result = sources_by_patch(sources, sizing, model.patches.size());
  for (std::size_t p = 0; p < result.size(); ++p) {
    PatchSources& patch = result[p];
    if (!sizing.part_bounds.empty()) patch.bounds = sizing.part_bounds[p];
    patch.fans = std::move(fans[p]);
    patch.rings = short_rings(model, static_cast<int>(p), greatest_ring(sizing));
    if (boundary[p].empty()) continue;
    patch.trees.push_back(std::make_shared<SourceTree>(std::move(boundary[p]), sizing.grade));
  }
  return result;
}

std::optional<Notice> clamp_notice(const Model& model, const Sources& sources,
                                   const SizeBounds& bounds) {
  std::size_t count = count_clamped(sources, bounds);
  for (std::size_t i = 0; i < sources.tables.size(); ++i) {
    const TableSource& table = sources.tables[i];
    const Patch& patch = model.patch(table.patch);
    count += at_location(fmt::format("{}: patch {}", place_of(table, "tables", i), patch.name),
                         [&] { return count_clamped(table, *patch.surface, bounds); });
  }
  if (count == 0) return std::nullopt;
  const std::string into = bounds.hmin == bounds.hmax
                               ? fmt::format("to the one length there is, {:.6g}", bounds.hmax)
                               : fmt::format("into the bounds hmin = {:.6g} and hmax = {:.6g}",
                                             bounds.hmin, bounds.hmax);
  return warning(NoticeKind::ClampedSizes,
                 fmt::format("{} of sources {} brought {}",
                             count == 1 ? "1 size" : fmt::format("{} sizes", count),
                             count == 1 ? "is" : "are", into));
}

}  // namespace surfmesh
