// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/options_of_model.hh"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "surfmesh/model/cad_input.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/pipeline/option_table.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh::detail {
namespace {

/// Options of models: not one of those that act in meshing.
bool is_of_models(const Option& option) { return option.group == OptionGroup::Cages; }

/// The joining of a report, which has it in model units.
bool is_joining_of(const Model& model, const Option& option, const PipelineOptions& options) {
  return option.name() == ranges::kJoining.name && options.joining &&
         *options.joining == Length::units(model.joining);
}

}  // namespace

bool was_made_with(const Model& model, std::string_view option, std::string_view value) {
  return std::any_of(model.made_with.begin(), model.made_with.end(), [&](const MadeWith& made) {
    return made.option == option && made.value == value;
  });
}

Notices options_too_late(const Model& model, const PipelineOptions& options) {
  Notices notices;
  for (const Option& option : option_table()) {
    if (!is_of_models(option)) continue;
    const std::string value = option.value_text(options);
    if (value == option.value_text({}) || was_made_with(model, option.name(), value) ||
        is_joining_of(model, option, options)) {
      continue;
    }
    const auto structs = [&]() -> const char* {
      if (option.name() == ranges::kJoining.name) return "JoinOptions of model_from_patches";
      if (option.name() == ranges::kSew.name) return "CadOptions of read_cad";
      return "CageOptions of model_from_cage";
    };
    notices.push_back(warning(
        NoticeKind::UnusedOption,
        fmt::format("{} = {} has no effect: the model is made already, and without it; it belongs "
                    "in the {}, or in the LoadOptions of load_model",
                    option.name(), value, structs())));
  }
  return notices;
}

PipelineOptions options_in_effect(const Model& model, PipelineOptions options) {
  const PipelineOptions defaults;
  options.patches = defaults.patches;
  options.weld = defaults.weld;
  options.orient = defaults.orient;
  options.crease_angle = defaults.crease_angle;
  options.surface = defaults.surface;
  options.fit = defaults.fit;
  options.joining = defaults.joining;
  options.sew = defaults.sew;
  for (const MadeWith& made : model.made_with) {
    if (made.part.empty()) set_option(options, made.option, made.value);
  }
  if (model.joining > 0) options.joining = Length::units(model.joining);
  // Corrections for a sag are not undone by moves across contours.
  if (options.sizing.sag && options.sizing.sag->value > 0) options.across.is_on = false;
  return options;
}

}  // namespace surfmesh::detail
