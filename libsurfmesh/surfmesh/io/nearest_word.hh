// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// The known word that a misspelt word probably means: the nearest by inserted, missing, changed or
/// swapped letters, if at most a third of its letters differ.
///
/// Returns  nothing for words of more than 40 letters as well, because they are near to anything
/// Cost     O(length²) per known word
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> known);

}  // namespace surfmesh
