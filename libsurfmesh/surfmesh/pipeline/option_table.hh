// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "surfmesh/core/length.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/pipeline/options.hh"

namespace surfmesh {

/// What an option belongs to. A model file has the options of sizes in `sizing`.
enum class OptionGroup { Sizes, ControlSpace, Meshing, Cages };

/// Access to an option of PipelineOptions that is a number, a switch or a choice.
struct NumberAccess {
  const OptionRange* range = nullptr;
  double (*get)(const PipelineOptions&) = nullptr;
  void (*set)(PipelineOptions&, double) = nullptr;
};

/// Access to an option of PipelineOptions that is a length.
struct LengthAccess {
  const LengthRange* range = nullptr;
  std::optional<Length> (*get)(const PipelineOptions&) = nullptr;
  void (*set)(PipelineOptions&, const std::optional<Length>&) = nullptr;
};

/// An option of the pipeline. Getting and setting, model files and their schema, the command line
/// with its help, and the report all follow from this.
struct Option {
  OptionGroup group = OptionGroup::Sizes;
  bool is_common = false;  ///< shown in the short help
  std::string_view unit;   ///< "" for a number without dimension, a switch or a choice
  std::string_view text;   ///< what it is, a noun phrase
  std::variant<NumberAccess, LengthAccess> access;

  std::string_view name() const;
  /// Its legal values in words.
  std::string range_text() const;
  /// The words it accepts, those shown in help first.
  std::vector<std::string_view> words() const;
  /// The effective value, as set_option reads it.
  std::string value_text(const PipelineOptions& options) const;
};

/// All options, those of sizes first. This is the only list of them.
std::span<const Option> option_table();

/// Throws   InvalidOption for an unknown name, suggesting the nearest one
const Option& find_option(std::string_view name);

}  // namespace surfmesh
