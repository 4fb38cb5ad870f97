// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "surfmesh/pipeline/options.hh"

namespace surfmesh {

/// The names of all options, those of `sizing` first.
const std::vector<std::string_view>& option_names();

/// Set an option by its name from text: `grade=1.3`, `hmin=0.1%`, `nodes=auto`, `features=off`.
///
/// Whatever can be off is switched off by `off`, numbers and the sag also by 0, switches also by
/// `false`.
/// Throws   InvalidOption for an unknown name, suggesting the nearest one; for a value that cannot
///          be read or is out of its range, naming option, value and range
void set_option(PipelineOptions& options, std::string_view name, std::string_view value);

/// A switch, a whole number, a number, or a word or length.
using OptionValue = std::variant<bool, std::int64_t, double, std::string>;

/// The effective value of an option. set_option accepts its text. Switches are bool.
/// Throws   InvalidOption as set_option
OptionValue get_option(const PipelineOptions& options, std::string_view name);

/// The value as set_option reads it; doubles read back exactly.
std::string to_text(const OptionValue& value);

}  // namespace surfmesh
