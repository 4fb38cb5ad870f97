// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/assemble/piece.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh::detail {

/// What the elements of a result hold.
struct ResultArrays {
  std::vector<PolyMesh::Point>& point;  ///< by vertex
  std::vector<int>& patch;              ///< surf:patch, by face
  std::vector<int>& contour;            ///< surf:contour, by edge
  std::vector<Uv>& uv;                  ///< surf:uv, by halfedge
  std::vector<Metric>& metric;          ///< surf:metric, by halfedge
};

/// Attach the properties of a result to a mesh without elements, and make them long enough for so
/// many, which the mesh is to get later. No edge lies on a contour.
///
/// Cost     O(n), most of it the system's for memory that was never used; all arrays at once
ResultArrays make_result_arrays(PolyMesh& mesh, const ElementCounts& counts);

}  // namespace surfmesh::detail
