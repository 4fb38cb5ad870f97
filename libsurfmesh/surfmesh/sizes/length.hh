// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// Read a length: a plain number in model units, or with % a share of the diagonal ("0.1%").
///
/// The share is the nearest double of the decimal number: "0.1%" is 0.001 exactly as written there.
/// Throws   InvalidInput if it cannot be read or is not finite; the sign is for the caller to check
Length parse_length(std::string_view text);

/// Write a length so that parse_length gives the same bits.
std::string to_text(const Length& length);

}  // namespace surfmesh
