// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "surfmesh/core/option_range.hh"
#include "surfmesh/pipeline/options.hh"
#include "surfmesh/sizes/length.hh"

namespace surfmesh {

/// What an option belongs to; a model file has those of the sizes in its `sizing`.
enum class OptionGroup { Sizes, ControlSpace, Meshing, Cages };

/// Where an option that is a number, a switch or a choice stands in PipelineOptions.
struct NumberAccess {
  const OptionRange* range = nullptr;
  double (*get)(const PipelineOptions&) = nullptr;
  void (*set)(PipelineOptions&, double) = nullptr;
};

/// Where an option that is a length stands in PipelineOptions.
struct LengthAccess {
  const LengthRange* range = nullptr;
  std::optional<Length> (*get)(const PipelineOptions&) = nullptr;
  void (*set)(PipelineOptions&, const std::optional<Length>&) = nullptr;
};

/// An option of the pipeline: all that get and set, model files and their schema, the command line,
/// its help, and the report know of it.
struct Option {
  OptionGroup group = OptionGroup::Sizes;
  bool is_common = false;  ///< stands in the short help
  std::string_view unit;   ///< "" for a number without dimension, a switch or a choice
  std::string_view text;   ///< what it is, a noun phrase
  std::variant<NumberAccess, LengthAccess> access;

  std::string_view name() const;
  /// Its legal values in words.
  std::string range_text() const;
  /// The words that it takes, those that are shown first.
  std::vector<std::string_view> words() const;
  /// The effective value as set_option reads it.
  std::string value_text(const PipelineOptions& options) const;
};

/// All options, those of the sizes first. It is the only list of them.
std::span<const Option> option_table();

/// Throws   InvalidOption for an unknown name, with the nearest one
const Option& find_option(std::string_view name);

}  // namespace surfmesh
