// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/quality/face_set_check.hh"
#include "surfmesh/quality/statistics.hh"
#include "surfmesh/quality/surface_distance.hh"

namespace surfmesh {

/// How a mesh fits the model that it is a mesh of.
struct ModelFit {
  bool is_projected = false;  ///< the mesh has no (u,v): nearest points were taken
  /// True where the model asks for more than the sizes below: a mesh may be finer by right.
  bool has_other_sizes = false;
  /// In the exact sizes of the area sources. Sizes `at` points and gradation, which only the
  /// control space knows, are not among them: a mesh with these is finer here and there.
  EdgeStatistics edges;
  QualityStatistics quality;  ///< likewise
  SurfaceDistance distance;
  /// Where the mesh is not as the model promises, see compare_with_promise.
  std::vector<MeshFault> differences;
};

/// What `surfmesh check` tells.
struct MeshCheck {
  std::string mesh;   ///< as given
  std::string model;  ///< as given; empty for none
  FaceSetCheck faces;
  ShapeStatistics shape;
  std::optional<ModelFit> fit;  ///< with a model
  Notices notices;
  std::vector<MeshFault> faults;  ///< of all kinds; empty for a clean mesh
};

/// Check a mesh that was read from a file as it stands there, by itself.
///
/// Faults are those of check_face_set, and degenerate_face for triangles of .stl files with two
/// equal corners.
MeshCheck check_mesh(const MeshArraysFile& file);

/// Measure a mesh against its model, in the exact sizes of the area sources of `input`.
///
/// Reads    surf:uv (halfedge; optional: without it, or where it is unset, the mesh is projected),
///          surf:patch (face)
/// Writes   surf:uv (halfedge) and surf:patch (face) if the mesh is projected; surf:metric
///          (halfedge), in place of that of the mesh
/// Cost     about 30 surface evaluations a triangle
/// Throws   InvalidInput for a patch that the model does not have
ModelFit measure_fit(MeshFile& mesh, const ModelInput& input);

/// Add the fit of a mesh to its check, with its faults; duplicate_vertex is then only what the
/// model does not promise.
void add_fit(MeshCheck& check, ModelFit fit);

/// The check as JSON text. Keys: mesh, model, clean, faults (kind, count, places), notices (kind,
/// text, count), counts (vertices, edges, triangles, quads, polygons, boundary_edges,
/// boundary_loops, components, euler), open_edges (count, places), closed, manifold, oriented,
/// angles (min, max, min_face, max_face, histogram), edge_lengths (min, mean, max), shape (min,
/// mean, below_0.3); with a model fit, else null: projected, edges (count, mean, stddev, min, max,
/// unit_fraction, histogram), quality (min, mean, below_0.3), distance (max, mean, max_face,
/// max_at, max_corner).
std::string to_json(const MeshCheck& check);

/// The check in some lines for a terminal, with the first faults.
std::string to_text(const MeshCheck& check);

}  // namespace surfmesh
