// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// The known word that a misspelt one probably means: the nearest by letters put in, left out,
/// changed or exchanged with their neighbour, if at most a third of its letters differ.
///
/// Returns  nothing also for words of more than 40 letters, which are near to anything
/// Cost     O(length²) a known word
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> known);

}  // namespace surfmesh
