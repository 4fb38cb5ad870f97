// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/resolved_sizing.hh"

#include <fmt/format.h>

#include <algorithm>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/length.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/sizes/model_parts.hh"

namespace surfmesh {
namespace {

/// The least sag, in gaps between surfaces that meet.
constexpr double kSagsOfGap = 2;

SizeBounds resolve_bounds(const Sizing& sizing, double diagonal) {
  if (sizing.size) {
    const double size = sizing.size->in_units(diagonal);
    return {size, size, diagonal};
  }
  const Length hmin = sizing.least_size();
  const SizeBounds bounds{hmin.in_units(diagonal), sizing.hmax.in_units(diagonal), diagonal};
  if (bounds.hmin <= bounds.hmax) return bounds;
  // Only the size of the model may tell.
  throw Error(
      ErrorCode::InvalidOption,
      fmt::format("hmin = {} must not be above hmax = {}, set both: they are lengths of {:.6g} and "
                  "{:.6g}",
                  to_text(hmin), to_text(sizing.hmax), bounds.hmin, bounds.hmax));
}

void check(const Sizing& sizing) {
  check_option(ranges::kCurvature, sizing.curvature_factor());
  check_option(ranges::kSag, sizing.sag);
  check_option(ranges::kSize, sizing.size);
  check_option(ranges::kSegmentsPerCircle, sizing.segments_per_circle);
  check_option(ranges::kSharesOf, sizing.shares_of);
  check_option(ranges::kHmin, sizing.least_size());
  check_option(ranges::kHmax, sizing.hmax);
  check_option(ranges::kStretch, sizing.stretch);
  check_option(ranges::kGrade, sizing.grade);
  check_option(ranges::kProximity, sizing.proximity);
  check_option(ranges::kCurvatureFrom, sizing.curvature_from);
}

}  // namespace

ResolvedSizing resolve(const Sizing& sizing, double diagonal) {
  check(sizing);
  const bool is_uniform = sizing.size.has_value();
  return {.bounds = resolve_bounds(sizing, diagonal),
          .curvature = is_uniform ? 0 : sizing.curvature_factor(),
          .sag = sizing.sag && !is_uniform ? sizing.sag->in_units(diagonal) : 0,
          .stretch = sizing.isotropic ? 1 : sizing.stretch,
          .grade = sizing.grade,
          .contour_curvature = sizing.contour_curvature && !is_uniform,
          .proximity = is_uniform ? 0 : sizing.proximity,
          .features = sizing.features && !is_uniform,
          .curvature_from = sizing.curvature_from,
          .isotropic = sizing.isotropic,
          .part_bounds = {}};
}

double least_sag(const Model& model) { return kSagsOfGap * greatest_tolerance(model); }

ResolvedSizing resolve(const Sizing& sizing, const Model& model) {
  ResolvedSizing resolved = resolve(sizing, model.diagonal);
  if (resolved.sag > 0) resolved.sag = std::max(resolved.sag, least_sag(model));
  if (sizing.shares_of == SharesOf::Model || sizing.size) return resolved;
  SizeBounds& all = resolved.bounds;
  for (const double diagonal : part_diagonals(model)) {
    SizeBounds own = resolve_bounds(sizing, diagonal);
    own.diagonal = model.diagonal;
    own.hmax = std::min(own.hmax, all.hmax);  // parts are sampled untrimmed
    own.hmin = std::min(own.hmin, own.hmax);
    all.hmin = std::min(all.hmin, own.hmin);
    resolved.part_bounds.push_back(own);
  }
  return resolved;
}

}  // namespace surfmesh
