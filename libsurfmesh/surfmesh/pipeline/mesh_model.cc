// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/mesh_model.hh"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/across/across.hh"
#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/assemble/carry_texture.hh"
#include "surfmesh/assemble/corner_normals.hh"
#include "surfmesh/assemble/promised_topology.hh"
#include "surfmesh/assemble/vertex_copies.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/patch/mesh_patch.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/counted_surfaces.hh"
#include "surfmesh/pipeline/do_or_cancel.hh"
#include "surfmesh/pipeline/face_notices.hh"
#include "surfmesh/pipeline/for_each_patch.hh"
#include "surfmesh/pipeline/mesh_plan.hh"
#include "surfmesh/pipeline/options_of_model.hh"
#include "surfmesh/pipeline/patch_cache.hh"
#include "surfmesh/pipeline/reach_sag.hh"
#include "surfmesh/pipeline/sag_notices.hh"
#include "surfmesh/pipeline/tile_notices.hh"
#include "surfmesh/pipeline/unused_options.hh"
#include "surfmesh/pipeline/unused_sources.hh"
#include "surfmesh/quality/measure_lengths.hh"
#include "surfmesh/quality/patch_measures.hh"

namespace surfmesh {
namespace {

/// Meshes of up to so many quads are made in two ways.
constexpr std::size_t kMostQuadsMadeTwice = 1000;

class Run {
 public:
  Run(const Model& model, const ResolvedSizing& sizing, const PipelineOptions& options,
      const RunContext& context)
      : model_(model),
        options_(options),
        context_(context),
        sizing_(sizing),
        plan_(model, sizing, options, context, report_) {
    if (sizing.sag > 0) demands_.sag = sizing.sag;
    report_.options = detail::options_in_effect(model, options);
    report_.surfaces = model.fits;
    if (options.quads.is_on) demands_.parity = SegmentParity::EvenPatches;
    append(model.notices, report_.notices);
    append(detail::options_too_late(model, options), report_.notices);
    append(detail::unused_options(options), report_.notices);
  }

  /// What is known without a mesh.
  Report estimate_only(ControlSpaces control) {
    context_.begin_mesh();
    plan_.take_spaces(std::move(control));
    return std::move(report_);
  }

  /// Correct triangles above a sag one by one (0 is off), give contours more segments, and take
  /// patches from a cache if nothing has changed for them.
  void demand(double corrected_sag, std::vector<double> more_segments, detail::PatchCache& cache) {
    corrected_sag_ = corrected_sag;
    demands_.more_segments = std::move(more_segments);
    cache_ = &cache;
  }

  /// Mesh with the sizes of control spaces.
  void mesh(ControlSpaces control, MeshResult& result) {
    context_.begin_mesh();
    plan_.take_spaces(std::move(control));
    const Report before = report_;
    make(result);
    if (!is_worth_two_meshes(result.report)) return;
    report_ = before;
    report_.seconds = result.report.seconds;
    demands_.parity = SegmentParity::EvenContours;
    context_.begin_mesh();
    MeshResult other;
    try {
      make(other);
    } catch (const Error& error) {
      // The mesh that is there does for all but a user who has had enough.
      if (error.code() == ErrorCode::Cancelled) throw;
      return;
    }
    result.report.seconds = other.report.seconds;
    if (has_better_quads(other.report, result.report)) result = other;
  }

 private:
  void make(MeshResult& result) {
    // A mesh that is not corrected is never asked for again.
    plan_.divide(demands_, corrected_sag_, corrected_sag_ > 0 ? cache_ : nullptr);
    mesh_patches();
    assemble_patches(result.mesh);
    improve_smooth_parts(result.mesh);
    mark_copies(result.mesh, model_);
    const MeshTopology topology = measure_topology(result.mesh);
    compare(result.mesh, topology);
    measure(result.mesh, topology);
    result.report = std::move(report_);
  }

  /// Opposite sides of patches are equal more often if every contour has an even number of
  /// segments. That costs size, so which is better shows in the mesh; in a large one it hardly
  /// matters.
  bool is_worth_two_meshes(const Report& report) const {
    return options_.quads.is_on && !demands_.sag && model_.patches.size() > 1 &&
           report.mesh.quads <= kMostQuadsMadeTwice;
  }

  static bool has_better_quads(const Report& a, const Report& b) {
    if (a.mesh.triangles != b.mesh.triangles) return a.mesh.triangles < b.mesh.triangles;
    if (a.quads.inverted != b.quads.inverted) return a.quads.inverted < b.quads.inverted;
    if (a.quads.folded != b.quads.folded) return a.quads.folded < b.quads.folded;
    return a.quads.mean_jacobian * a.edges.unit_fraction >
           b.quads.mean_jacobian * b.edges.unit_fraction;
  }

  void mesh_patches() {
    patches_.clear();
    turned_.clear();
    std::vector<PatchResult> results(plan_.tiles().size());
    share_and_tell("mesh", detail::largest_first(plan_.tiles()), context_,
                   [&](std::size_t t) { results[t] = plan_.mesh_tile(t, context_); });
    for (PatchResult& result : results) {
      report_.seconds += result.seconds;
      report_.control.queries += result.queries;
      report_.refine += result.refine;
      patches_.push_back(std::move(result.mesh));
      turned_.push_back(result.turned);
    }
    tell_given_up(results);
    const StageClock clock(report_.seconds[Stage::Assemble]);
    for (const auto& [t, turned] : plan_.make_proper(patches_)) turned_[t] = turned;
    if (!options_.quads.is_on) tell_turned();
  }

  void tell_given_up(const std::vector<PatchResult>& results) {
    std::vector<char> is_given_up(model_.patches.size(), 0);
    for (std::size_t t = 0; t < results.size(); ++t) {
      if (results[t].is_given_up) is_given_up[patches_[t].patch()] = 1;
    }
    append(detail::notices_of_given_up(model_, is_given_up, context_.element_kind()),
           report_.notices);
  }

  void tell_turned() {
    std::vector<detail::TurnedTile> tiles;
    for (std::size_t t = 0; t < turned_.size(); ++t) {
      tiles.push_back({patches_[t].boundary.patch, turned_[t]});
    }
    append(detail::notices_of_turned(model_, tiles), report_.notices);
  }

  void assemble_patches(PolyMesh& mesh) {
    const StageClock clock(report_.seconds[Stage::Assemble]);
    context_.tell("assemble", 0, 1);
    AssembleReport report =
        assemble(mesh, model_, plan_.nodes(), plan_.numbers(), std::move(patches_), context_);
    append(std::move(report.notices), report_.notices);
    between_tiles_ = report.between_tiles;
    context_.tell("assemble", 1, 1);
  }

  void improve_smooth_parts(PolyMesh& mesh) {
    if (!report_.options.across.is_on) return;
    const StageClock clock(report_.seconds[Stage::Across]);
    context_.tell("across", 0, 1);
    report_.control.queries[Stage::Across] =
        improve_across(mesh, model_, plan_.fields(), context_, between_tiles_).queries;
    if (mesh.n_faces() > context_.max_elements()) context_.throw_too_many_elements();
    context_.tell("across", 1, 1);
  }

  void compare(const PolyMesh& mesh, const MeshTopology& topology) {
    for (const MeshFault& fault : compare_with_promise(mesh, topology, model_)) {
      report_.notices.push_back(
          shortfall(NoticeKind::BrokenPromise,
                    fmt::format("the mesh is not as the model promises: {}: {}, the first: {}",
                                fault.kind, fault.count, fault.places.front())));
    }
  }

  void measure(const PolyMesh& mesh, const MeshTopology& topology) {
    const std::size_t corners = 2 * topology.edges - topology.boundary_edges;
    const std::size_t quads = corners - 3 * topology.faces;  // there are triangles and quads only
    report_.mesh = {topology.vertices,     topology.faces - quads, quads,
                    model_.patches.size(), topology.is_closed,     topology.euler};
    context_.throw_if_cancelled();
    report_.edges = measure_edges(mesh);
    context_.throw_if_cancelled();
    report_.quality = measure_quality(mesh);
    if (quads > 0) report_.quads = measure_quads(mesh);
    report_.diagonal = model_.diagonal;
    report_.tolerance = greatest_tolerance(model_);
    const detail::SpaceLengths lengths = detail::measure_lengths(mesh);
    report_.lengths = {lengths.min, lengths.moments.mean(), lengths.max};
    locate_worst(mesh);
    append(detail::notices_of_faces(model_, report_, detail::told_faces(mesh, report_)),
           report_.notices);
  }

  void locate_worst(const PolyMesh& mesh) {
    report_.worst = place_of(mesh, report_.quality.worst_face);
    report_.worst_quad = place_of(mesh, report_.quads.worst_face);
    report_.worst_quad_in_space = place_of(mesh, report_.quads.worst_face_in_space);
  }

  std::optional<Report::WorstFace> place_of(const PolyMesh& mesh, int face) const {
    if (face < 0) return {};
    const FaceHandle fh(face);
    const int patch = mesh.property(require(mesh, keys::face_patch), fh);
    return Report::WorstFace{model_.patch(patch).name, to_eigen(mesh.calc_face_centroid(fh))};
  }

  const Model& model_;
  const PipelineOptions& options_;
  const RunContext& context_;
  const ResolvedSizing& sizing_;
  ContourDemands demands_;
  detail::PatchCache* cache_ = nullptr;
  double corrected_sag_ = 0;  ///< triangles above this are corrected one by one; 0 is off
  Report report_;
  detail::MeshPlan plan_;
  std::vector<PatchMesh> patches_;       ///< by tile
  std::vector<TurnedTriangles> turned_;  ///< likewise
  VertexRange between_tiles_;
};

/// Hand new control spaces to `work`, and add their times to the report that it makes.
template <class Work>
void work_with_control(const Model& model, const Sources& sources, const ResolvedSizing& sizing,
                       const PipelineOptions& options, const RunContext& context, Report& report,
                       Work work) {
  const auto start = std::chrono::steady_clock::now();
  ControlSpaces control;
  double seconds = 0;
  {
    const StageClock clock(seconds);
    control = make_control_spaces(model, sources, sizing, options.control, context);
  }
  work(std::move(control));
  report.seconds[Stage::Control] += seconds;
  report.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Mesh the model once or until the sag is reached.
void mesh_as_asked(const Model& model, const Sources& sources, const PipelineOptions& options,
                   const RunContext& context, MeshResult& result) {
  const ResolvedSizing sizing = resolve(options.sizing, model);
  if (sizing.sag == 0) {
    work_with_control(model, sources, sizing, options, context, result.report,
                      [&](ControlSpaces control) {
                        Run(model, sizing, options, context).mesh(std::move(control), result);
                      });
    return;
  }
  const detail::CountedModel counted(model);
  detail::PatchCache cache(model.patches.size());
  const auto mesh_with = [&](ControlSpaces control, double corrected_sag,
                             const std::vector<double>& more_segments) {
    MeshResult once;
    Run run(counted.model(), sizing, options, context);
    run.demand(corrected_sag, more_segments, cache);
    run.mesh(std::move(control), once);
    return once;
  };
  result =
      detail::reach_sag({counted.model(), sources, sizing, options.control, context}, mesh_with);
  result.report.sag.evaluations = counted.evaluations();
  append(detail::notices_of_raised_sag(model, options.sizing), result.report.notices);
}

/// The normals of the surface, if they are wanted in the file.
void add_normals(const Model& model, const PipelineOptions& options, const RunContext& context,
                 MeshResult& result) {
  if (!options.output.normals) return;
  const StageClock clock(result.report.seconds[Stage::Assemble]);
  attach_corner_normals(result.mesh, model, context);
}

/// The texture coordinates of the input, if they are wanted in the file.
void add_texture(const Model& model, const PipelineOptions& options, MeshResult& result) {
  if (!options.output.texture) return;
  const StageClock clock(result.report.seconds[Stage::Assemble]);
  carry_texture(model, result.mesh);
}

/// Tell the least quality of the triangles and quads of each patch.
void add_qualities(Report& report) {
  const std::vector<double>& least = report.quality.min_of_patches;
  for (std::size_t p = 0; p < report.patches.size() && p < least.size(); ++p) {
    if (std::isfinite(least[p])) report.patches[p].least_quality = least[p];
  }
  const std::vector<double>& jacobians = report.quads.min_of_patches;
  for (std::size_t p = 0; p < report.patches.size() && p < jacobians.size(); ++p) {
    if (std::isfinite(jacobians[p])) report.patches[p].least_jacobian = jacobians[p];
  }
}

/// The names of parts, and what is told of each patch and source.
void describe(const Model& model, const Sources& sources, const PipelineOptions& options,
              MeshResult& result) {
  result.names = mesh_names(model);
  result.report.patches = measure_patches(result.mesh, result.names);
  add_qualities(result.report);
  append(detail::unused_sources(result.mesh, model, sources, resolve(options.sizing, model)),
         result.report.notices);
}

/// Throws   MissingProperty for normals that are asked for after the mesh was made
void check_output(const MeshResult& result) {
  const bool has_normals = find(result.mesh, keys::corner_normal).is_valid();
  if (!result.report.options.output.normals || has_normals) return;
  throw Error(
      ErrorCode::MissingProperty,
      "the mesh has no normals of its corners (surf:normal): output.normals is an option of "
      "mesh_model, and is set too late here");
}

/// Apart, so that the mesh is made where it is returned to.
MeshResult meshed(const Model& model, const Sources& sources, const PipelineOptions& options,
                  Observer* observer) {
  check(options);
  check(model);
  const RunContext context(observer, options.max_elements, element_kind(options));
  MeshResult result;  // OpenMesh's meshes cannot be moved, only copied
  double serial_seconds = 0;
  with_threads(options.threads, [&] {
    const SerialClock clock(serial_seconds);
    detail::do_or_cancel(context, "patches", [&] {
      mesh_as_asked(model, sources, options, context, result);
      add_normals(model, options, context, result);
      add_texture(model, options, result);
      result.report.facets =
          measure_facet_distance(result.mesh, model, FacetsOf::InterpolatedCages, context);
      describe(model, sources, options, result);
    });
  });
  result.report.serial_seconds = serial_seconds;
  return result;
}

}  // namespace

void write_mesh(const MeshResult& result, const std::filesystem::path& path) try {
  check_output(result);
  const PipelineOptions& options = result.report.options;
  with_threads(options.threads,
               [&] { write_mesh(result.mesh, path, result.names, options.output); });
} catch (const std::bad_alloc&) {
  fail_without_memory("while writing " + path.string());
}

void write_mesh(const MeshResult& result, OutputFile& file) try {
  check_output(result);
  const PipelineOptions& options = result.report.options;
  with_threads(options.threads,
               [&] { write_mesh(result.mesh, file, result.names, options.output); });
} catch (const std::bad_alloc&) {
  fail_without_memory("while writing " + file.path().string());
}

MeshResult mesh_model(const Model& model, const Sources& sources, const PipelineOptions& options,
                      Observer* observer) {
  return tell_out_of_memory([&] { return meshed(model, sources, options, observer); },
                            [] { return "while meshing"; });
}

Report estimate_mesh(const Model& model, const Sources& sources, const PipelineOptions& options,
                     Observer* observer) try {
  check(options);
  check(model);
  const RunContext context(observer, options.max_elements, element_kind(options));
  const ResolvedSizing sizing = resolve(options.sizing, model);
  Report report;
  const auto estimate = [&](ControlSpaces control) {
    report = Run(model, sizing, options, context).estimate_only(std::move(control));
  };
  double serial_seconds = 0;
  with_threads(options.threads, [&] {
    const SerialClock clock(serial_seconds);
    detail::do_or_cancel(context, "patches", [&] {
      work_with_control(model, sources, sizing, options, context, report, estimate);
    });
  });
  report.serial_seconds = serial_seconds;
  append(detail::notices_of_raised_sag(model, options.sizing), report.notices);
  report.mesh.patches = model.patches.size();
  report.patches = measure_patches(PolyMesh(), mesh_names(model));
  return report;
} catch (const std::bad_alloc&) {
  fail_without_memory("while estimating");
}

}  // namespace surfmesh
