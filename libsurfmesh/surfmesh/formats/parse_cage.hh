// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh {

/// What is wrong with the vertices of a face.
enum class CornerFault { None, TwiceInARow, TooFew, Twice };

/// Drop all but one of equal vertices in a row, also across the end, and tell what was or is wrong.
CornerFault mend_corners(std::vector<int>& corners);

/// The fault as it stands in messages.
const char* text_of(CornerFault fault);

/// What faces are read for.
///
/// Cage     groups are those with faces, in the order of their first face; a vertex that comes
///          several times in a row stays so, for a scheme has its own surface for such a face
/// Mesh     groups are all, in the order in which the file names them; of equal vertices in a row
///          one is taken, with a warning
enum class ReadFor { Cage, Mesh };

/// As those of read_cage.hh, with a choice of the purpose.
Cage parse_obj(std::string_view text, const std::string& name, ReadFor purpose);
Cage parse_off(std::string_view text, const std::string& name, ReadFor purpose);

/// Check the vertices of a face just read from the current line and add it to the cage as the
/// purpose asks for.
///
/// Throws   InvalidInput for fewer than three different vertices, or one twice but not in a row
void add_face(Cage& cage, const std::vector<int>& corners, ReadFor purpose,
              const TextScanner& scanner, WarningList& warnings);

/// Throws   InvalidInput if the cage has no vertices or no faces
void check_not_empty(const Cage& cage, const TextScanner& scanner);

}  // namespace surfmesh
