// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// What is wrong with a function that formulas do not have, which was probably meant, and all that
/// they have.
std::string unknown_function(std::string_view name);

/// The same for a name that is not followed by a parenthesis; `known` are those that there are
/// besides functions.
std::string unknown_name(std::string_view name, const std::vector<std::string_view>& known);

/// Text to be quoted: the first 80 bytes of a long one.
std::string shortened(std::string_view text);

}  // namespace surfmesh
