// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/quality/surface_search.hh"

namespace surfmesh {

/// Distances between mesh and model below this are rounding, model units: of the model, or of a
/// mesh whose coordinates are all in single precision.
double surface_tolerance(const PolyMesh& mesh, const Model& model);

/// Give the corners of a mesh the patches and parameters of the nearest points of a model.
///
/// The patch of a face is that of the point nearest to its middle, among the patches that have the
/// name of the face's group, or are in the model's group of that name. If no patch or group has
/// this name, all patches count. Its corners are projected from there, so that a face at a seam
/// stays on one side of it. Corners that end off the surface are searched once more from where
/// their neighbours lie on it: beside a fold the search may have ended on the wrong sheet. Those
/// that lie on another patch than the rest of their face get (u,v) beyond its domain.
///
/// Reads    surf:patch (face; optional), with its names
/// Writes   surf:patch (face), surf:uv, surf:beyond (halfedge)
/// Cost     about 10 surface evaluations per corner
/// Throws   Cancelled
void project_mesh(PolyMesh& mesh, const std::vector<std::string>& patch_names, const Model& model,
                  const SurfaceSearch& search, const RunContext& context = RunContext());

}  // namespace surfmesh
