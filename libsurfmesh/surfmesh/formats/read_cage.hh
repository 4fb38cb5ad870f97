// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Read a control cage from an OBJ or OFF file, chosen by the ending in upper or lower case.
///
/// Throws   Io if the file cannot be read; InvalidInput for an unknown ending and as below
/// Cost     0.2 to 0.3 µs a face with its share of the points
Cage read_cage(const std::filesystem::path& path);

/// Read a cage from the text of an OBJ file; `name` stands before the line in messages.
///
/// Understands v (numbers after the third are ignored), f (with texture and normal indices, which
/// are ignored; indices from 1, or from -1 backwards), g and usemtl (both make groups; g without a
/// name is "default"), the joining of lines by a backslash, and OpenSubdiv's tags `t`, whose
/// indices count from 0: crease, corner, hole, interpolateboundary, creasemethod,
/// smoothtriangles. Other tags and unknown keywords give a warning. A face may have a vertex
/// several times in a row.
/// Throws   InvalidInput, naming file and line: a bad or missing number or index, a coordinate that
///          is not finite, a face with fewer than three different vertices or one that comes back
///          to a vertex, a bad tag, a NUL byte; naming the file: no vertices, no faces
Cage parse_obj(std::string_view text, const std::string& name);

/// Read a cage from the text of an OFF file; `name` stands before the line in messages.
///
/// The header may be missing, or have the prefixes ST, C and N. One vertex or face a line; normals,
/// colours and texture coordinates are ignored.
/// Throws   InvalidInput as parse_obj, and if there are fewer lines than the counts tell
Cage parse_off(std::string_view text, const std::string& name);

}  // namespace surfmesh
