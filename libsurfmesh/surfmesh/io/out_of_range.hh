// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace surfmesh {

/// Whether a number that std::from_chars calls out of range is too near to zero for a double,
/// rather than too far from it.
///
/// Pre      the text is a number in decimal, other than 0, perhaps with an exponent
bool is_too_near_to_zero(std::string_view number);

}  // namespace surfmesh
