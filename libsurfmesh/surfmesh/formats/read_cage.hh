// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Read a control cage from an OBJ, OFF, PLY, STL or .om file, chosen by the ending in upper or
/// lower case. The last three are read as meshes (see read_mesh.hh), whose named patches and groups
/// become groups.
///
/// Throws   Io if the file cannot be read; InvalidInput for an unknown ending and as below
/// Cost     0.2 to 0.3 µs per face, including its share of the points
Cage read_cage(const std::filesystem::path& path);

/// Read a cage from the text of an OBJ file. Messages begin with `name` and the line.
///
/// Supports v (numbers after the third are ignored), vt (of two numbers; the third is ignored), f
/// (normal indices are ignored; indices count from 1, or backwards from -1), g, o and usemtl (all
/// make groups; g without a name is "default"), lines joined by a backslash, and OpenSubdiv's tags
/// `t`, whose indices count from 0: crease, corner, hole, interpolateboundary, creasemethod,
/// smoothtriangles. Other tags, unknown keywords and texture indices of nothing give a warning. A
/// face may have a vertex several times in a row. Throws   InvalidInput, naming file and line, for
/// a bad or missing number or index, a coordinate
///          that is not finite, a face with fewer than three different vertices or one that returns
///          to a vertex, a bad tag, a NUL byte; naming the file, for no vertices or no faces
Cage parse_obj(std::string_view text, const std::string& name);

/// Read a cage from the text of an OFF file. Messages begin with `name` and the line.
///
/// The header may be missing or have the prefixes ST, C and N. Each line has one vertex or face;
/// normals, colours and texture coordinates are ignored.
/// Throws   InvalidInput as parse_obj, and if there are fewer lines than the counts say
Cage parse_off(std::string_view text, const std::string& name);

}  // namespace surfmesh
