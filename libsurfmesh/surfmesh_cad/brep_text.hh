// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Check that the text of a BREP file is complete, and that what its shapes refer to is there.
///
/// OpenCASCADE believes the indices that it reads: one out of range ends the program.
///
/// Throws   InvalidInput, naming the shape as the file numbers it
void check_brep_text(std::string_view text);

}  // namespace surfmesh
