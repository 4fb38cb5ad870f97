// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/control_spaces.hh"

#include <fmt/format.h>

#include "surfmesh/core/error.hh"
#include "surfmesh/pipeline/for_each_patch.hh"
#include "surfmesh/pipeline/patch_names.hh"
#include "surfmesh/sampling/contour_gradation.hh"
#include "surfmesh/sampling/make_control.hh"
#include "surfmesh/sizes/length.hh"
#include "surfmesh/sizes/model_sources.hh"

namespace surfmesh {
namespace {

void check_patches(const Model& model, const Sources& sources) {
  const auto check_all = [&](const auto& list) {
    for (const auto& source : list) {
      if (source.patch >= 0 && static_cast<std::size_t>(source.patch) < model.patches.size()) {
        continue;
      }
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("a source names patch {} of {}", source.patch, model.patches.size()));
    }
  };
  check_all(sources.everywhere);
  check_all(sources.at);
  check_all(sources.along);
  check_all(sources.inside);
  check_all(sources.fields);
  check_all(sources.tables);
  check_all(sources.sag);
}

/// Throws   InvalidOption if hmin is above hmax, which only the size of the model may tell
void check_bounds(const Model& model, const Sizing& sizing) {
  const double hmin = sizing.hmin.in_units(model.diagonal);
  const double hmax = sizing.hmax.in_units(model.diagonal);
  if (hmin <= hmax) return;
  throw Error(ErrorCode::InvalidOption,
              fmt::format("hmin = {} must not be above hmax = {}, which are lengths of {:.6g} and "
                          "{:.6g}",
                          to_text(sizing.hmin), to_text(sizing.hmax), hmin, hmax));
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

}  // namespace

ControlSpaces make_control_spaces(const Model& model, const Sources& sources,
                                  const PipelineOptions& options) {
  check(options);
  check_bounds(model, options.sizing);
  check_patches(model, sources);
  ControlSpaces result;
  const SizeBounds bounds(options.sizing, model.diagonal);
  if (auto warning = clamp_warning(model, sources, bounds)) result.warnings.push_back(*warning);
  const auto patch_sources = model_sources(model, sources, options.sizing);
  std::vector<ControlInput> inputs(model.patches.size());
  result.spaces.resize(model.patches.size());
  for_each_patch(model, "control", options.observer, cells_of_patches(model), [&](std::size_t p) {
    inputs[p] = collect_control_input(*model.patches[p].surface, options.sizing, patch_sources[p],
                                      model.diagonal, options.control);
    result.spaces[p] = make_control(inputs[p]);
  });
  std::vector<char> is_coarse;
  for (const ControlInput& input : inputs) is_coarse.push_back(input.is_coarse);
  if (const std::string names = detail::patch_names(model, is_coarse); !names.empty()) {
    result.shortfalls.push_back(
        fmt::format("{}: the control space does not hold its precision, for sizes change faster "
                    "than elements can follow; a larger hmin or precision helps",
                    names));
  }
  if (!grade_across_contours(model, inputs, result.spaces, options.observer).has_converged) {
    result.shortfalls.push_back("gradation across contours has not come to an end");
  }
  return result;
}

}  // namespace surfmesh
