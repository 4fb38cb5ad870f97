// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/geometry/cage.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh {

/// What is wrong with the vertices of a face.
enum class CornerFault { None, TwiceInARow, TooFew, Twice };

/// Drop all but one of equal vertices in a row, also across the end, and tell what was or is wrong.
CornerFault mend_corners(std::vector<int>& corners);

/// The fault as it stands in messages.
const char* text_of(CornerFault fault);

/// Which groups a reader of OBJ files keeps: those with faces, in the order of their first face, or
/// all, in the order in which the file names them.
enum class ObjGroups { WithFaces, All };

/// As parse_obj of read_cage.hh, with a choice of the groups.
Cage parse_obj(std::string_view text, const std::string& name, ObjGroups groups);

/// Check the vertices of a face just read from the current line and add it to the cage.
///
/// Vertices that come twice in a row are dropped once, with a warning; `corners` is changed.
/// Throws   InvalidInput for fewer than three different vertices, or one twice but not in a row
void add_face(Cage& cage, std::vector<int>& corners, const TextScanner& scanner,
              WarningList& warnings);

/// Throws   InvalidInput if the cage has no vertices or no faces
void check_not_empty(const Cage& cage, const TextScanner& scanner);

}  // namespace surfmesh
