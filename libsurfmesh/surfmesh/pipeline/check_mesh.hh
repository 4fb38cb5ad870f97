// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/observer.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/text_style.hh"
#include "surfmesh/quality/face_set_check.hh"
#include "surfmesh/quality/facet_distance.hh"
#include "surfmesh/quality/mesh_extent.hh"
#include "surfmesh/quality/quad_statistics.hh"
#include "surfmesh/quality/statistics.hh"
#include "surfmesh/quality/surface_distance.hh"

namespace surfmesh {

/// How well a mesh fits a metric.
struct MetricFit {
  EdgeStatistics edges;
  QualityStatistics quality;  ///< of triangles
  QuadStatistics quads = {};
};

/// The sizes by which a mesh is judged.
enum class JudgedBy {
  StoredMetric,  ///< of its corners, which it was made by, if they have one; else those of a run
  SizesOfRun,    ///< of the control spaces of a run on the model, which know all but the sag
  ExactSizes,    ///< of the area sources of a model
};

/// How well a mesh fits its model.
struct ModelFit {
  bool is_projected = false;         ///< the mesh has no (u,v): nearest points were used
  std::size_t corners_beyond = 0;    ///< whose (u,v) go on beyond the patch of their face
  bool is_by_stored_metric = false;  ///< the sizes below are those that the mesh was made by
  bool is_by_exact_sizes = false;    ///< if neither, they are those of the control space of a run
  /// True if more is asked for than the sizes below include: the mesh may rightly be finer. Exact
  /// sizes do not know sizes `at` points and gradation, nor those of a run corrections of the sag.
  bool has_other_sizes = false;
  std::optional<double> sag;  ///< asked for, model units
  MetricFit sizes;
  /// Its greatest distance is that of measure_sag, as in the report of a run. If the mesh is
  /// projected, it is that of samples of the mesh, of contours and of samples of the surface.
  SurfaceDistance distance;
  /// How far the surface is from a mesh that is projected: what that lacks.
  std::optional<OneWayDistance> from_surface = {};
  /// From the faces of the cages of the model, and back; none if it has no cages.
  std::optional<FacetDistance> facets = {};
  std::string max_contour = {};  ///< the name of the contour of the greatest distance, if any
  /// Where the mesh differs from what the model promises, see compare_with_promise.
  std::vector<MeshFault> differences;
};

/// The result of `surfmesh check`.
struct MeshCheck {
  std::string mesh;   ///< as given
  std::string model;  ///< as given; empty for none
  FaceSetCheck faces;
  /// Pairs of faces that pass through each other. No faults: a surface may do so by right.
  MeshFault self_intersections{"self_intersection", 0, {}};
  MeshExtent extent;
  ShapeStatistics shape;
  std::optional<MetricFit> stored;       ///< in the metric that the mesh was made by, if it has one
  std::optional<ModelFit> fit;           ///< with a model
  Notices notices;                       ///< of reading; add those of the model
  std::vector<std::string> patch_names;  ///< of the model, by which its notices are told
  std::vector<MeshFault> faults;         ///< of all kinds; empty if the mesh is clean
};

/// Check a mesh by itself, exactly as it was read from a file.
///
/// Faults are those of check_face_set, and degenerate_face for faces of the file that do not have
/// three different corners.
///
/// Cost     about 3 µs a triangle, most of it for self-intersections; see there
/// Throws   Cancelled by the observer, which may be null
MeshCheck check_mesh(const MeshArraysFile& file, Observer* observer = nullptr);

/// Measure a mesh in the metric of its corners; nothing if a corner has none, or no (u,v).
///
/// Reads    surf:uv, surf:metric (halfedge; optional)
std::optional<MetricFit> measure_stored_metric(const PolyMesh& mesh);

/// Measure a mesh against its model.
///
/// Reads    surf:uv (halfedge; optional: without it, or where it is unset, the mesh is projected),
///          surf:patch (face), surf:metric (halfedge; optional)
/// Writes   surf:uv (halfedge) and surf:patch (face) if the mesh is projected; surf:metric
///          (halfedge), which replaces that of the mesh where exact sizes judge it
/// Cost     about 90 surface evaluations per triangle, and the control spaces of a run for a mesh
///          without a metric
/// Throws   InvalidInput for a patch that the model does not have; Cancelled by the observer, which
///          may be null
ModelFit measure_fit(MeshFile& mesh, const ModelInput& input,
                     JudgedBy judged_by = JudgedBy::StoredMetric, Observer* observer = nullptr);

/// Add the fit of a mesh, with its faults, to its check, and a shortfall (SagNotReached) where a
/// sag is asked for and the mesh is farther from its model. Of duplicate_vertex, only those remain
/// that the model does not promise.
void add_fit(MeshCheck& check, ModelFit fit);

/// The check as JSON text. Keys: mesh, model, clean, faults (kind, count, places), notices (kind,
/// text, count), counts (vertices, edges, triangles, quads, polygons, boundary_edges,
/// boundary_loops, components, euler), open_edges (count, places), self_intersections (count,
/// places), closed, manifold, oriented, area, volume (null unless closed and oriented), box (min,
/// max; null without faces), angles (min, max, min_face, max_face, histogram), edge_lengths (min,
/// mean, max), shape (min, mean, below_0.3, histogram); stored_metric, null for a mesh that has
/// none: edges (count, mean, stddev, min, max, unit_fraction, histogram), quality (as shape); with
/// a model fit, else null: projected, stored_metric (true if that judges it), exact_sizes
/// (likewise), other_sizes, edges and quality likewise, sag (asked for, or null), distance (max,
/// mean, max_face, max_at, max_corner), from_surface (max, mean, max_at, max_face; null unless
/// projected), facets (to_facets and from_facets, likewise; null without cages).
std::string to_json(const MeshCheck& check);

/// The check for a terminal, with histograms as in the report of a run, in the metric if there is
/// one and else of shapes and angles, and with the first faults. The long style has both, with all
/// bins.
std::string to_text(const MeshCheck& check, const TextStyle& style = {});

}  // namespace surfmesh
