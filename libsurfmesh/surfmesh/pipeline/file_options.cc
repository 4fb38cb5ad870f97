// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/file_options.hh"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/length.hh"
#include "surfmesh/io/json.hh"
#include "surfmesh/pipeline/at_file.hh"
#include "surfmesh/pipeline/option_table.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh::detail {
namespace {

/// True for a number in quotes, which only a share of the diagonal may have.
bool is_quoted_number(const Json& value) {
  if (!value.is_string()) return false;
  const std::string text = value.get<std::string>();
  return text.find_first_of("0123456789+-.") == 0 && text.find('%') == text.npos;
}

/// The text of a JSON value for set_option: what stands in quotes are words and shares of the
/// diagonal.
std::string text_for(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Set one entry of a file's `sizing` or `options`; null leaves the default.
void set_file_option(PipelineOptions& options, const FileOption& entry) {
  const Option& option = find_option(entry.name);
  if ((option.group == OptionGroup::Sizes) != entry.is_in_sizing) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("it belongs in {}", entry.is_in_sizing ? "options" : "sizing"));
  }
  const auto value = Json::parse(entry.value);
  if (is_quoted_number(value)) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("{} = {}: a number stands without quotes", entry.name, value.dump()));
  }
  if (!value.is_null()) set_option(options, entry.name, text_for(value));
}

/// Where both bounds are of one kind, a file that gives both is told of its fault before the model
/// is there. A bound that it leaves out may still come from the command line.
void check_bounds(const Sizing& sizing) {
  const Length hmin = sizing.least_size();
  if (hmin.is_relative != sizing.hmax.is_relative) return;
  if (hmin.value <= sizing.hmax.value) return;
  throw Error(ErrorCode::InvalidOption, fmt::format("hmin = {} must not be above hmax = {}",
                                                    to_text(hmin), to_text(sizing.hmax)));
}

}  // namespace

KeyPlaces places_of_options() {
  KeyPlaces places;
  for (const Option& option : option_table()) {
    places.emplace(option.name(), option.group == OptionGroup::Sizes ? "sizing" : "options");
  }
  return places;
}

PipelineOptions file_options(const ModelFile& file, const std::string& name) {
  PipelineOptions options;
  std::vector<std::string> bounds;  // where they stand
  for (const FileOption& entry : file.options) {
    at_file(fmt::format("{}: {}", name, entry.origin), [&] { set_file_option(options, entry); });
    if (entry.name == ranges::kHmin.name || entry.name == ranges::kHmax.name) {
      bounds.push_back(entry.origin);
    }
  }
  if (bounds.size() == 2) {
    at_file(fmt::format("{}: {}", name, bounds.back()), [&] { check_bounds(options.sizing); });
  }
  return options;
}

bool is_default(const FileOption& entry) {
  PipelineOptions options;
  set_file_option(options, entry);
  return get_option(options, entry.name) == get_option({}, entry.name);
}

void set_given(const LoadOptions& given, PipelineOptions& options) {
  const CageOptions& cages = given.cages;
  if (cages.patches != PatchKind::Auto) options.patches = cages.patches;
  if (cages.weld) options.weld = cages.weld;
  if (cages.orient) options.orient = cages.orient;
  if (cages.crease_angle) options.crease_angle = cages.crease_angle;
  if (cages.surface != SurfaceKind::Auto) options.surface = cages.surface;
  if (cages.fit) options.fit = cages.fit;
  if (given.joining) options.joining = given.joining;
  if (given.cad.sew) options.sew = given.cad.sew;
}

void note_options(const PipelineOptions& options, Model& model) {
  for (const Option& option : option_table()) {
    const std::string value = option.value_text(options);
    if (option.group != OptionGroup::Cages || value == option.value_text({})) continue;
    const MadeWith made{std::string(option.name()), value};
    const auto known = std::find(model.made_with.begin(), model.made_with.end(), made);
    if (known == model.made_with.end()) model.made_with.push_back(made);
  }
}

}  // namespace surfmesh::detail
