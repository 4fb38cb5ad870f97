// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/make_quads.hh"

#include <utility>
#include <vector>

#include "surfmesh/core/face_editor.hh"
#include "surfmesh/delaunay/metric_swaps.hh"
#include "surfmesh/quad/boundary_corners.hh"
#include "surfmesh/quad/clean_quads.hh"
#include "surfmesh/quad/compact_patch.hh"
#include "surfmesh/quad/frontal.hh"
#include "surfmesh/quad/pair_triangles.hh"
#include "surfmesh/quad/patch_geometry.hh"
#include "surfmesh/quad/place_nodes.hh"
#include "surfmesh/quad/smooth_quads.hh"

namespace surfmesh {
namespace {

/// Sweeps of smoothing before and after the quads are cleaned, and for the worst corners.
constexpr int kFirstSweeps = 5, kLastSweeps = 10, kPolishingSweeps = 8;

/// Passes of swaps after nodes have been placed.
constexpr int kSwapPasses = 2;

std::vector<int> wanted_faces(const std::vector<BoundaryCorner>& corners) {
  std::vector<int> wanted;
  for (const BoundaryCorner& corner : corners) wanted.push_back(corner.quads);
  return wanted;
}

/// What both ways have in common, once there are quads, and triangles that are left.
void finish_quads(PolyMesh& mesh, FaceEditor& editor, PatchGeometry& geometry,
                  const std::vector<BoundaryCorner>& corners, QuadReport& report,
                  const RunContext& context) {
  report.triangles = walk_triangles(mesh, editor, geometry, context);
  smooth_quads(mesh, geometry, SmoothingAim::Shape, kFirstSweeps, context);
  const CleaningReport cleaned =
      clean_quads(mesh, editor, geometry, wanted_faces(corners), context);
  report.tried = cleaned.tried;
  report.changed = cleaned.changed;
  smooth_quads(mesh, geometry, SmoothingAim::BetterShape, kLastSweeps, context);
  smooth_quads(mesh, geometry, SmoothingAim::WorstCorners, kPolishingSweeps, context);
  detach(mesh, keys::edge_constrained);  // whose edges get other numbers
  compact_patch(mesh, editor);
  report.queries += geometry.queries();
}

}  // namespace

PatchQuads make_quads(std::unique_ptr<DelaunayMesh> boundary, const MetricField& field,
                      std::span<const std::size_t> loop_sizes, const RunContext& context) {
  PatchQuads result;
  QuadReport& report = result.report;
  const std::size_t fixed = boundary->n_vertices();
  const std::vector<BoundaryCorner> corners = boundary_corners(boundary->mesh(), loop_sizes);
  const PlacementReport placed = place_square_nodes(*boundary, field, corners, context);
  report.is_given_up = placed.is_stopped;
  report.queries = placed.queries;
  for (int pass = 0; pass < kSwapPasses; ++pass) swap_edges(*boundary, context);

  result.mesh = boundary->release();
  PolyMesh& mesh = *result.mesh;
  FaceEditor editor(mesh);
  PatchGeometry geometry(mesh, field, fixed);
  pair_triangles(mesh, editor, context);
  finish_quads(mesh, editor, geometry, corners, report, context);
  return result;
}

PatchQuads convert_to_quads(std::unique_ptr<DelaunayMesh> triangles, const FrontalInput& input,
                            const RunContext& context) {
  PatchQuads result;
  result.mesh = triangles->release();
  PolyMesh& mesh = *result.mesh;
  const std::vector<BoundaryCorner> corners = boundary_corners(mesh, input.loop_sizes);
  FaceEditor editor(mesh);
  result.report.queries = convert_frontal(mesh, editor, input, context).queries;
  PatchGeometry geometry(mesh, input.field, corners.size());
  finish_quads(mesh, editor, geometry, corners, result.report, context);
  return result;
}

}  // namespace surfmesh
