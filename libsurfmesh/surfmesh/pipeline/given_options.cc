// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/given_options.hh"

#include <algorithm>
#include <utility>

#include "surfmesh/pipeline/option_table.hh"

namespace surfmesh {

std::string_view name(OptionOrigin origin) {
  switch (origin) {
    case OptionOrigin::ModelFile:
      return "model file";
    case OptionOrigin::CommandLine:
      return "command line";
    case OptionOrigin::Python:
      return "python";
  }
  return "";
}

std::vector<GivenOption> options_of_file(const PipelineOptions& options, const Model& model) {
  const PipelineOptions defaults;
  std::vector<GivenOption> given;
  for (const Option& option : option_table()) {
    std::string value = option.value_text(options);
    if (value == option.value_text(defaults)) continue;
    given.push_back({std::string(option.name()), std::move(value), OptionOrigin::ModelFile});
  }
  for (const MadeWith& made : model.made_with) {
    const bool is_of_all =
        made.part.empty() || find_option(made.option).value_text(options) == made.value;
    if (!is_of_all) {
      given.push_back({made.part + made.option, made.value, OptionOrigin::ModelFile});
    }
  }
  return given;
}

void add_given(GivenOption option, std::vector<GivenOption>& given) {
  const auto found = std::find_if(given.begin(), given.end(), [&](const GivenOption& earlier) {
    return earlier.name == option.name;
  });
  if (found != given.end()) {
    *found = std::move(option);
  } else {
    given.push_back(std::move(option));
  }
}

}  // namespace surfmesh
