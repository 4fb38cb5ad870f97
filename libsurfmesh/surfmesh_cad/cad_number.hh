// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// What a text is worth that is a number as a whole: infinite if it is beyond the range of a
/// double, 0 if it is as near to zero as that.
std::optional<double> cad_number(std::string_view text);

/// Whether a number is too large to be one of a shape: OpenCASCADE's own infinity is 2e100.
/// Products of a few larger ones overflow; it then computes with NaN, and may not come to an end.
bool is_too_large(double number);

}  // namespace surfmesh
