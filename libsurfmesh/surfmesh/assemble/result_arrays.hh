// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/core/mesh.hh"

namespace surfmesh::detail {

/// A result that is being assembled, and the values of its properties by element.
struct ResultArrays {
  PolyMesh& mesh;
  std::vector<int>& patch;      ///< surf:patch, by face
  std::vector<int>& contour;    ///< surf:contour, by edge
  std::vector<Uv>& uv;          ///< surf:uv, by halfedge
  std::vector<Metric>& metric;  ///< surf:metric, by halfedge
};

/// Attach the properties of a result to a mesh without elements, and give it its elements, which
/// are not linked yet and lie on no contour.
///
/// Cost     O(n), most of it the system's for memory that was never used; all arrays at once
ResultArrays make_room(PolyMesh& mesh, std::size_t vertices, std::size_t edges, std::size_t faces);

}  // namespace surfmesh::detail
