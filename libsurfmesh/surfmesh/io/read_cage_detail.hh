// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/geometry/cage.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh {

/// Check the vertices of a face just read from the current line and add it to the cage.
///
/// Vertices that come twice in a row are dropped once, with a warning; `corners` is changed.
/// Throws   InvalidInput for fewer than three different vertices, or one twice but not in a row
void add_face(Cage& cage, std::vector<int>& corners, const TextScanner& scanner,
              WarningList& warnings);

/// Throws   InvalidInput if the cage has no vertices or no faces
void check_not_empty(const Cage& cage, const TextScanner& scanner);

}  // namespace surfmesh
