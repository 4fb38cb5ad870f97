// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/quality/sag_memory.hh"
#include "surfmesh/quality/sharp_contours.hh"
#include "surfmesh/quality/surface_search.hh"

namespace surfmesh {

/// How far a mesh and its surface are from each other. Lengths in model units.
struct Sag {
  double max = 0;
  Vec3 max_at = Vec3::Zero();    ///< a point of the mesh, or of a contour
  int max_contour = -1;          ///< the sharp contour of that point; -1 for a point of the mesh
  std::vector<double> of_faces;  ///< by the index of the face, with contours that it is nearest to
};

/// What else is to be known, or known already.
struct SagDemands {
  /// Faces above this are measured, too, not only the greatest one.
  double asked = std::numeric_limits<double>::infinity();
  /// If not null, faces are taken from there that are as they were, and so are all around them; all
  /// faces are kept there.
  SagMemory* memory = nullptr;
  /// The sharp contours of the model, if the mesh should follow them; null for a mesh of a part.
  const std::vector<SharpContour>* contours = nullptr;
};

/// Measure the distance between a mesh and its surface, both ways.
///
/// A quad is taken for the two triangles at either of its diagonals. Each face is sampled at 25
/// points per triangle, and a search goes on from the greatest one. A
/// sample is a point of the triangle and the point of the surface at the same parameters. Two
/// distances count: from the former to the nearest point of the surface, and from the latter to the
/// nearest triangle. The first alone would miss what the mesh cuts off, the second what it adds.
/// The distance between the two points does not count, because it also grows where parameters are
/// uneven.
///
/// The nearest triangle is searched among those that share a vertex with the face. Faces that are
/// surely below the greatest one, and below `demands.asked`, are estimated at seven points.
/// Contours along which the surface ends are compared with the border of the mesh, creases with its
/// triangles: where their bends are cut off, no face need be far from the surface.
/// Reads    surf:patch (face), surf:uv (halfedge)
/// Error    a lower bound, by 3 % of the sag of a triangle over a sphere (test Sag.*); of
///          contours, by the tolerance of their points
/// Cost     7 surface evaluations per triangle, about 60 for those that may be the greatest one
/// Throws   MissingProperty; Cancelled
Sag measure_sag(const PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
                const RunContext& context = RunContext(), const SagDemands& demands = {});

/// About how far each face is from its surface, by the index of the face: the distance of the
/// surface from the planes of its triangles, at a few points.
///
/// Reads    surf:patch (face), surf:uv (halfedge)
/// Cost     7 surface evaluations per triangle
/// Throws   MissingProperty; Cancelled
std::vector<double> estimate_sag(const PolyMesh& mesh, const Model& model,
                                 const RunContext& context = RunContext());

}  // namespace surfmesh
