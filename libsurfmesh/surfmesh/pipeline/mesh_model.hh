// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/core/observer.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pipeline/options.hh"
#include "surfmesh/pipeline/report.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// What a run makes: the mesh, the names of its parts, and what there is to tell of it.
struct MeshResult {
  PolyMesh mesh;
  MeshNames names;  ///< of the patches and contours of the mesh, and groups of patches
  Report report;
};

/// Mesh a model: control spaces, contour nodes, boundary triangulations, inner nodes, improvement,
/// assembly.
///
/// The result is a proper half-edge mesh. Each face records its patch, and each corner its
/// parameters and metric. The same input gives the same bytes, whatever the number of threads.
/// Threads share contours and patches; an error is that of the first patch that has one. The
/// observer is not owned and may be null; any thread calls it, one at a time. Between control and
/// boundary it is told of a stage "estimate", whose total is about the number of elements to come.
///
/// Writes   of the result: surf:patch (face), surf:contour (edge), surf:uv, surf:metric (halfedge),
///          surf:normal and surf:texture (halfedge) if they are asked for,
///          surf:sag (face) if a sag is
/// Cost     about 2 µs per triangle. Sizes that ask for more than max_elements are refused before
///          the mesh is begun, mostly within milliseconds
/// Throws   InvalidOption, InvalidInput, Geometry, Limit, Cancelled
/// Source   paper, section 2.1
MeshResult mesh_model(const Model& model, const Sources& sources = {},
                      const PipelineOptions& options = {}, Observer* observer = nullptr);

/// Make the control spaces of a model only, and estimate from them how many triangles its mesh
/// would have; with a sag, its first mesh.
///
/// Returns  a report without a mesh: estimated_elements, control, seconds, and the notices so far
/// Error    see estimate_triangles
/// Throws   as mesh_model
Report estimate_mesh(const Model& model, const Sources& sources = {},
                     const PipelineOptions& options = {}, Observer* observer = nullptr);

/// Write the mesh of a result with the names of its patches and groups, and what its options ask
/// for; see write_mesh.hh, also for formats that have no place for that (unused_options).
///
/// Throws   MissingProperty where report.options.output asks for normals that mesh_model was not
///          asked for; otherwise as write_mesh of a mesh
void write_mesh(const MeshResult& result, const std::filesystem::path& path);
/// To a file that is open, likewise.
void write_mesh(const MeshResult& result, OutputFile& file);

}  // namespace surfmesh
