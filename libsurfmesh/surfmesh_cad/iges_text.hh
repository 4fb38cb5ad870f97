// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// The section of a line of an IGES file: S, G, D, P or T; 0 if it has none.
char section_of(std::string_view line);

/// Check the numbers of the entities of an IGES file: OpenCASCADE may compute without end with
/// those that are too large.
///
/// Throws   InvalidInput, naming the number and its line
void check_iges_text(std::string_view text);

}  // namespace surfmesh
