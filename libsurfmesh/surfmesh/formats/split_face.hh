// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// Add the triangles of a face to those of others, for formats without larger faces: quads are
/// split at their shorter diagonal, others into the fan of their first corner.
void split_face(const PolyMesh& mesh, std::span<const int> face,
                std::vector<std::array<int, 3>>& triangles);

/// How many faces have more corners than `corners`.
std::size_t count_faces_above(const PolyMesh& mesh, std::size_t corners);

}  // namespace surfmesh
