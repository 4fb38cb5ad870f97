// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "pictures/canvas.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// Join segments, pairs of indices of points, to a few long lines that run through each of them
/// once and turn little: a file of them is less than half as long as one of segments.
std::vector<PicturePoints> long_lines(const std::vector<PicturePoint>& points,
                                      const std::vector<std::array<int, 2>>& segments);

/// The edges of a mesh as such lines.
std::vector<PicturePoints> edge_lines(const PolyMesh& mesh,
                                      const std::function<PicturePoint(VertexHandle)>& at);

}  // namespace surfmesh
