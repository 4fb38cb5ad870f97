// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surfmesh {

/// The first lines of an .obj file: a square, and a point above its first corner.
inline const std::string kFive = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";

}  // namespace surfmesh
