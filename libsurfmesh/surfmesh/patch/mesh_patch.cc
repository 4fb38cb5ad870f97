// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/mesh_patch.hh"

#include <utility>
#include <vector>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/improve/shape_moves.hh"
#include "surfmesh/patch/divide_far_quads.hh"
#include "surfmesh/patch/sag_corrections.hh"
#include "surfmesh/patch/smooth_within_sag.hh"
#include "surfmesh/quad/make_quads.hh"
#include "surfmesh/refine/boundary_triangulation.hh"

namespace surfmesh {
namespace {

/// Sweeps for the shapes of triangles before they are corrected: well shaped ones are seldom too
/// far.
constexpr int kShapeSweeps = 2;

std::vector<std::vector<Uv>> points_of(const PatchBoundary& boundary) {
  std::vector<std::vector<Uv>> loops;
  for (const BoundaryLoop& loop : boundary.loops) {
    std::vector<Uv>& uvs = loops.emplace_back();
    for (const BoundaryNode& node : loop) uvs.push_back(node.uv);
  }
  return loops;
}

/// The stretch up to which the shapes of corrected triangles count in space: one that is
/// equilateral in the metric is of shape 0.8 there.
constexpr double kMostStretchInSpace = 2;

/// One patch on its way through the stages.
class PatchRun {
 public:
  PatchRun(PatchTask task, const RunContext& context) : task_(std::move(task)), context_(context) {}

  PatchResult run() {
    triangulate();
    if (task_.quads.is_on) {
      fill_with_quads();
    } else {
      insert_inner_nodes();
      improve_triangles();
      finish();
    }
    context_.change_unfinished(-refined_faces_);
    context_.add_elements(result_.mesh.mesh->n_faces());
    return std::move(result_);
  }

 private:
  void triangulate() {
    const StageClock clock(result_.seconds[Stage::Triangulate]);
    patch_.surface = &task_.surface;
    patch_.field = &task_.field;
    patch_.has_shapes_of_metric = task_.stretch > kMostStretchInSpace;
    patch_.boundary = std::move(task_.boundary);
    BoundaryTriangulation made = triangulate_boundary(points_of(patch_.boundary), task_.field);
    patch_.delaunay = std::move(made.delaunay);
    context_.throw_if_cancelled();
    result_.queries[Stage::Triangulate] = made.queries;
  }

  void fill_with_quads() {
    std::vector<std::size_t> loop_sizes;
    for (const BoundaryLoop& loop : patch_.boundary.loops) loop_sizes.push_back(loop.size());
    const bool is_converted = task_.quads.method == QuadMethod::Frontal;
    if (is_converted) {
      insert_inner_nodes();
      improve_triangles();
    }
    const StageClock clock(result_.seconds[Stage::Quad]);
    PatchQuads quads =
        is_converted ? convert_to_quads(std::move(patch_.delaunay),
                                        {task_.field, loop_sizes, task_.quads.front}, context_)
                     : make_quads(std::move(patch_.delaunay), task_.field, loop_sizes, context_);
    result_.queries[Stage::Quad] = quads.report.queries;
    if (task_.corrected_sag > 0) {
      result_.queries[Stage::Quad] += detail::divide_far_quads(
          *quads.mesh, task_.surface, task_.field, boundary_vertices(patch_.boundary).size(),
          task_.corrected_sag, context_);
    }
    result_.is_given_up = result_.is_given_up || quads.report.is_given_up;
    result_.mesh = finish_patch(std::move(patch_.boundary), std::move(quads.mesh), task_.surface);
  }

  void insert_inner_nodes() {
    const StageClock clock(result_.seconds[Stage::Refine]);
    const RefineReport report = refine(*patch_.delaunay, task_.field, task_.refine, context_);
    refined_faces_ = static_cast<std::ptrdiff_t>(patch_.delaunay->n_faces());
    result_.queries[Stage::Refine] = report.queries;
    result_.is_given_up = report.is_stopped;
    result_.refine = report.counts;
  }

  void improve_triangles() {
    const StageClock clock(result_.seconds[Stage::Improve]);
    result_.queries[Stage::Improve] =
        improve(*patch_.delaunay, task_.field, task_.improve, context_).queries;
    if (task_.corrected_sag == 0) return;
    for (int i = 0; i < kShapeSweeps; ++i) smooth_shapes(*patch_.delaunay, task_.field, context_);
  }

  /// Mends are counted as part of the assembly, which they are made for.
  void finish() {
    const StageClock clock(result_.seconds[Stage::Assemble]);
    evaluate_vertices(patch_);
    context_.throw_if_cancelled();
    result_.turned = mend_turned_triangles(patch_);
    if (task_.corrected_sag > 0) {
      detail::correct_sag(patch_, task_.corrected_sag, context_);
      detail::smooth_within_sag(patch_, task_.corrected_sag, context_);
      result_.turned = find_turned_triangles(patch_);
    }
    result_.mesh = finish_patch(std::move(patch_));
  }

  PatchTask task_;
  const RunContext& context_;
  TriangulatedPatch patch_;
  std::ptrdiff_t refined_faces_ = 0;  ///< that the observer knows of
  PatchResult result_;
};

}  // namespace

PatchResult mesh_patch(PatchTask task, const RunContext& context) {
  return PatchRun(std::move(task), context).run();
}

}  // namespace surfmesh
