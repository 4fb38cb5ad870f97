// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/cage/face_neighbours.hh"

namespace surfmesh {

/// Sides end to end, the last to the first, with their faces on the left.
using FaceLoop = std::vector<FaceNeighbours::Side>;

/// The loops around faces that are connected: their sides beyond which none of them is a neighbour.
/// They are ascending, and those that have the number given in `numbers`. A loop comes to a vertex
/// again where faces on both sides of it meet there only.
///
/// Cost     O(n log n) for n faces
std::vector<FaceLoop> face_loops(const FaceNeighbours& neighbours, const std::vector<int>& faces,
                                 const std::vector<int>& numbers, int number);

}  // namespace surfmesh
