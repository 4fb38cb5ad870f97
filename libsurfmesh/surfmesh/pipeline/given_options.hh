// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/model/model.hh"
#include "surfmesh/pipeline/options.hh"

namespace surfmesh {

/// Where the value of an option is from.
enum class OptionOrigin { ModelFile, CommandLine, Python };

/// The name of an origin in reports: "model file", "command line", "python".
std::string_view name(OptionOrigin origin);

/// An option that was given, with its value as text.
struct GivenOption {
  std::string name;
  std::string value;
  OptionOrigin origin = OptionOrigin::CommandLine;

  friend bool operator==(const GivenOption&, const GivenOption&) = default;
};

/// The options of a model file that differ from their defaults, in the order of the option table,
/// then those that its cages have of their own, named "<cage>:<option>".
std::vector<GivenOption> options_of_file(const PipelineOptions& options, const Model& model);

/// Add an option, or replace what was given for it before.
void add_given(GivenOption option, std::vector<GivenOption>& given);

}  // namespace surfmesh
