// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/quality/face_set_check.hh"
#include "surfmesh/quality/surface_search.hh"

namespace surfmesh {

/// How far a mesh is from the surface. Lengths in model units.
struct SurfaceDistance {
  double max = 0;   ///< of samples inside the elements and at the middles of their sides
  double mean = 0;  ///< of the samples
  std::size_t max_face = 0;
  int max_contour = -1;  ///< that is so far from the mesh; -1 for a point of the mesh
  Vec3 max_at = Vec3::Zero();
  double max_corner = 0;  ///< of the vertices from the surface at their parameters
  std::size_t max_corner_face = 0;
  /// turned_face: against the normal of the surface, seen from the side on which most of its patch
  /// is, and in a projected mesh by more than 120°; corner_off_surface: farther than 1e-6 of the
  /// diagonal, than sides are joined and than the model's tolerances, from the surface at its
  /// (u,v), for a mesh with (u,v) of its own.
  std::vector<MeshFault> faults;
  /// Faces of a projected mesh that look turned, but whose corners are not all found on the
  /// surface, as most of the mesh's are, or have normals that are more than 90° apart: across a
  /// very large face, and at the seam of a surface with one side.
  std::size_t unjudged = 0;
};

/// Measure the distance of a mesh from its surface, and find turned elements.
///
/// Reads    surf:patch (face), surf:uv (halfedge)
/// Error    a lower bound of the greatest distance: four samples per triangle
/// Cost     about 15 surface evaluations per triangle
/// Throws   Cancelled; MissingProperty; InvalidInput for a patch that the model does not have
SurfaceDistance measure_distance(const PolyMesh& mesh, const Model& model,
                                 const SurfaceSearch& search, bool is_projected,
                                 const RunContext& context = RunContext());

}  // namespace surfmesh
