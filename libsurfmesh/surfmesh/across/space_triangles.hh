// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/across/vertex_chart.hh"
#include "surfmesh/core/face_editor.hh"
#include "surfmesh/core/run_context.hh"

namespace surfmesh {

/// Improve triangles that lie on several patches: smooth vertices, swap edges, mend what is not of
/// unit length or has other than six triangles on trial, search places for the vertices of bad
/// triangles.
///
/// `charts` are those of the vertices. Vertices at the border of the mesh stay where they are, and
/// no two of them are joined that were not.
/// Cost     about 3 µs a triangle, half of it evaluations of the surface
/// Throws   Cancelled
void improve_space_triangles(PolyMesh& mesh, FaceEditor& editor, std::vector<VertexChart>& charts,
                             ChartMaker& maker, const RunContext& context);

}  // namespace surfmesh
