// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/control_spaces.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/estimate/coarse_estimate.hh"
#include "surfmesh/estimate/element_limit.hh"
#include "surfmesh/pipeline/for_each_patch.hh"
#include "surfmesh/pipeline/patch_names.hh"
#include "surfmesh/sampling/contour_gradation.hh"
#include "surfmesh/sampling/make_control.hh"
#include "surfmesh/sizes/field_search.hh"
#include "surfmesh/sizes/model_sources.hh"
#include "surfmesh/sizes/source_place.hh"

namespace surfmesh {
namespace {

/// Share of the sample of a patch, in cells too short for elements, that misses the precision from
/// which on it is told. Around small sources there are always some.
constexpr double kShareUnfollowed = 0.5;

/// Share of the triangles allowed below which a first look at the sizes is enough.
constexpr double kClearlyBelow = 0.01;

/// The patches that a source names: one, or in space any number.
template <class Source>
std::vector<int> patches_of(const Source& source) {
  if constexpr (requires { source.patches; }) {
    return source.patches;
  } else {
    return {source.patch};
  }
}

template <class Source>
void check_patches(const std::vector<Source>& sources, std::string_view list, std::size_t count) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (const int patch : patches_of(sources[i])) {
      if (patch >= 0 && static_cast<std::size_t>(patch) < count) continue;
      throw Error(
          ErrorCode::InvalidInput,
          fmt::format("{}: it names patch {}, but the model has {}, counted from 0",
                      place_of(sources[i], list, i), patch, counted(count, "patch", "patches")));
    }
  }
}

void check_patches(const Model& model, const Sources& sources) {
  const std::size_t count = model.patches.size();
  check_patches(sources.everywhere, "everywhere", count);
  check_patches(sources.at, "at", count);
  check_patches(sources.along, "along", count);
  check_patches(sources.inside, "inside", count);
  check_patches(sources.near, "near", count);
  check_patches(sources.boxes, "boxes", count);
  check_patches(sources.fields, "fields", count);
  check_patches(sources.tables, "tables", count);
}

/// What the work for the control space of a patch goes by, roughly.
std::vector<std::size_t> cells_of_patches(const Model& model) {
  std::vector<std::size_t> cells;
  for (const Patch& patch : model.patches) {
    const CellCount count = patch.surface->cells();
    cells.push_back(static_cast<std::size_t>(count.u) * static_cast<std::size_t>(count.v));
  }
  return cells;
}

void tell_coarse(const Model& model, const std::vector<ControlInput>& inputs, Notices& notices) {
  std::vector<char> is_coarse;
  for (const ControlInput& input : inputs) is_coarse.push_back(input.sampling.is_coarse);
  auto notice = detail::shortfall_of_patches(
      NoticeKind::CoarseControl, model, is_coarse,
      "the control space does not hold its precision, for sizes change faster than elements can "
      "follow; a larger hmin or precision helps");
  if (notice) notices.push_back(std::move(*notice));
}

/// Tell where the sizes of a field jump about within elements nearly everywhere: a wave that no
/// sample resolves. Sizes from curvature do so on small faces of cages, where nobody asked for
/// them.
void tell_unfollowed(const Model& model, const Sources& sources,
                     const std::vector<ControlInput>& inputs, Notices& notices) {
  std::vector<char> is_unfollowed(inputs.size(), 0);
  double greatest = 0;
  for (const FieldSource& source : sources.fields) {
    const auto p = static_cast<std::size_t>(source.patch);
    const PrecisionSample& sample = inputs[p].sampling.precision;
    const double most = kShareUnfollowed * static_cast<double>(sample.points);
    if (!(static_cast<double>(sample.over_in_short_cells) > most)) continue;
    is_unfollowed[p] = 1;
    greatest = std::max(greatest, sample.greatest_in_short_cells);
  }
  auto notice = detail::shortfall_of_patches(
      NoticeKind::MissedPrecision, model, is_unfollowed,
      fmt::format("sizes go up and down within two elements, by a factor of up to {:.3g}, nearly "
                  "everywhere: elements get some of them by chance; sizes that change over several "
                  "elements are followed",
                  std::exp(greatest)));
  if (notice) notices.push_back(std::move(*notice));
}

void tell_missed(const PrecisionSample& sample, Notices& notices) {
  if (sample.is_held()) return;
  notices.push_back(warning(
      NoticeKind::MissedPrecision,
      fmt::format("the control space misses its precision ({:.3g}) at {:.2g} % of a sample of "
                  "points, by up to {:.3g}; a lower precision makes more control nodes there",
                  sample.asked, 100 * sample.share_over(), sample.greatest)));
}

void tell_unsearched(const Model& model, const std::vector<ControlInput>& inputs,
                     Notices& notices) {
  for (std::size_t p = 0; p < inputs.size(); ++p) {
    if (!inputs[p].sampling.is_search_incomplete) continue;
    Notice notice = warning_at(
        label(model.patches[p]), NoticeKind::UnsearchedSizes,
        fmt::format("the search for small sizes in its fields ended at {} evaluations: small ones "
                    "may be missed; formulas that use each variable fewer times take fewer, as do "
                    "background meshes that lie on the surface",
                    kSearchBudget));
    notice.patch = static_cast<int>(p);
    notices.push_back(std::move(notice));
  }
}

/// Sizes that would surely need too many triangles are refused before any work is done for them:
/// boundaries would be searched for gaps down to hmin, and control spaces would have millions of
/// nodes.
void refuse_hopeless_sizes(const Model& model, const Sources& sources, const ResolvedSizing& sizing,
                           const RunContext& context) {
  const auto most = static_cast<double>(context.max_elements());
  if (most_triangles(model, sizing.bounds.hmin) <= most) return;
  const auto of_patches = sources_by_patch(sources, sizing, model.patches.size());
  const CoarseEstimate first = estimate_coarsely(model, of_patches, sizing, CoarseLook::First);
  if (first.likely.triangles() <= kClearlyBelow * most) return;
  const CoarseEstimate estimate = estimate_coarsely(model, of_patches, sizing);
  if (is_surely_above(estimate.least, context)) {
    throw_too_many(estimate.likely, sizing.bounds.hmax, context);
  }
}

}  // namespace

ControlSpaces make_control_spaces(const Model& model, const Sources& sources,
                                  const ResolvedSizing& sizing, const ControlOptions& options,
                                  const RunContext& context) {
  detail::ControlBases bases = detail::make_control_bases(model, sources, sizing, options, context);
  detail::finish_control_spaces(model, bases.inputs, bases.control.spaces, context);
  return std::move(bases.control);
}

namespace detail {

ControlBases make_control_bases(const Model& model, const Sources& sources,
                                const ResolvedSizing& sizing, const ControlOptions& options,
                                const RunContext& context) {
  check(options);
  check_patches(model, sources);
  ControlBases result;
  ControlSpaces& control = result.control;
  if (auto notice = clamp_notice(model, sources, sizing.bounds)) {
    control.notices.push_back(std::move(*notice));
  }
  if (auto notice = unused_option(options)) control.notices.push_back(std::move(*notice));
  refuse_hopeless_sizes(model, sources, sizing, context);
  result.sources = model_sources(model, sources, sizing);
  result.inputs.resize(model.patches.size());
  control.spaces.resize(model.patches.size());
  for_each_patch(model, "control", context, cells_of_patches(model), [&](std::size_t p) {
    result.inputs[p] = collect_control_input(*model.patches[p].surface, sizing, result.sources[p],
                                             options, context);
    control.spaces[p] = make_control(result.inputs[p], context);
  });
  tell_coarse(model, result.inputs, control.notices);
  for (const ControlInput& input : result.inputs) control.precision += input.sampling.precision;
  tell_missed(control.precision, control.notices);
  tell_unfollowed(model, sources, result.inputs, control.notices);
  tell_unsearched(model, result.inputs, control.notices);
  return result;
}

void finish_control_spaces(const Model& model, std::vector<ControlInput>& inputs,
                           std::vector<std::unique_ptr<ControlSpace>>& spaces,
                           const RunContext& context) {
  grade_across_contours(model, inputs, spaces, context);
  share_indices(spaces.size(), [&](std::size_t p) { finish(*spaces[p]); });
}

}  // namespace detail
}  // namespace surfmesh
