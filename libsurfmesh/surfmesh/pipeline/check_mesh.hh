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

/// How well a mesh fits its model.
struct ModelFit {
  bool is_projected = false;  ///< the mesh has no (u,v): nearest points were used
  /// True if the model has more sources than the sizes below include: the mesh may rightly be
  /// finer.
  bool has_other_sizes = false;
  /// In the exact sizes of the area sources. Sizes `at` points and gradation are known only to the
  /// control space and are not included: a mesh that has them is finer in some areas.
  EdgeStatistics edges;
  QualityStatistics quality;  ///< likewise
  SurfaceDistance distance;
  /// Where the mesh differs from what the model promises, see compare_with_promise.
  std::vector<MeshFault> differences;
};

/// The result of `surfmesh check`.
struct MeshCheck {
  std::string mesh;   ///< as given
  std::string model;  ///< as given; empty for none
  FaceSetCheck faces;
  ShapeStatistics shape;
  std::optional<ModelFit> fit;           ///< with a model
  Notices notices;                       ///< of reading; add those of the model
  std::vector<std::string> patch_names;  ///< of the model, by which its notices are told
  std::vector<MeshFault> faults;         ///< of all kinds; empty if the mesh is clean
};

/// Check a mesh by itself, exactly as it was read from a file.
///
/// Faults are those of check_face_set, and degenerate_face for triangles of .stl files with two
/// equal corners.
MeshCheck check_mesh(const MeshArraysFile& file);

/// Measure a mesh against its model, in the exact sizes of the area sources of `input`.
///
/// Reads    surf:uv (halfedge; optional: without it, or where it is unset, the mesh is projected),
///          surf:patch (face)
/// Writes   surf:uv (halfedge) and surf:patch (face) if the mesh is projected; surf:metric
///          (halfedge), which replaces that of the mesh
/// Cost     about 30 surface evaluations per triangle
/// Throws   InvalidInput for a patch that the model does not have
ModelFit measure_fit(MeshFile& mesh, const ModelInput& input);

/// Add the fit of a mesh, with its faults, to its check. Of duplicate_vertex, only those remain
/// that the model does not promise.
void add_fit(MeshCheck& check, ModelFit fit);

/// The check as JSON text. Keys: mesh, model, clean, faults (kind, count, places), notices (kind,
/// text, count), counts (vertices, edges, triangles, quads, polygons, boundary_edges,
/// boundary_loops, components, euler), open_edges (count, places), closed, manifold, oriented,
/// angles (min, max, min_face, max_face, histogram), edge_lengths (min, mean, max), shape (min,
/// mean, below_0.3); with a model fit, else null: projected, edges (count, mean, stddev, min, max,
/// unit_fraction, histogram), quality (min, mean, below_0.3), distance (max, mean, max_face,
/// max_at, max_corner).
std::string to_json(const MeshCheck& check);

/// The check in a few lines for a terminal, with the first faults.
std::string to_text(const MeshCheck& check);

}  // namespace surfmesh
