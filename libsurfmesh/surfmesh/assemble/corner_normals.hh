// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Give each corner of a result the normal of its patch's surface there, of unit length, on the
/// side from which its face goes around counter-clockwise.
///
/// Across a crease, the corners of a vertex have the normals of their own patches; those that
/// differ by less than a millionth are made equal. Where the surface has no tangent plane (at a
/// pole, at the tip of a cone), a corner takes the normal a millionth of the way to the middle of
/// its face, or nearer to the middle if there is none either, in the end the normal of the face. At
/// singular points of surfaces, where patches do not have the derivatives of the true surface, all
/// corners between two creases have one normal, the mean of limits in their patches, unless the
/// vertex is a tip.
///
/// Reads    surf:patch (face), surf:uv (halfedge), surf:contour (edge; optional)
/// Writes   surf:normal (halfedge, at its tip)
/// Error    a millionth; at poles likewise, for faces over which the normal turns by up to a
///          radian; at singular points of cages 1e-4 (CornerNormals.*)
/// Cost     one evaluation of first order for each vertex and patch around it: 0.2 µs per triangle
/// Throws   InvalidInput for a patch that the model does not have, or if the mesh has surf:normal
///          already; MissingProperty; Cancelled
void attach_corner_normals(PolyMesh& mesh, const Model& model,
                           const RunContext& context = RunContext());

}  // namespace surfmesh
