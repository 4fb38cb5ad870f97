// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/mesh_model.hh"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/assemble/promised_topology.hh"
#include "surfmesh/boundary/patch_boundary.hh"
#include "surfmesh/control/surface_metric_field.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/patch/sag_corrections.hh"
#include "surfmesh/patch_mesh/turned_triangles.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/for_each_patch.hh"
#include "surfmesh/pipeline/patch_names.hh"
#include "surfmesh/pipeline/reach_sag.hh"
#include "surfmesh/pipeline/serial_observer.hh"
#include "surfmesh/quality/patch_measures.hh"
#include "surfmesh/refine/boundary_triangulation.hh"

namespace surfmesh {
namespace {

/// A triangle of less quality is told: it is of no use, and the user can mend it.
constexpr double kFlatQuality = 0.1;

/// What the meshing of one patch tells beside its mesh.
struct PatchReport {
  StageSeconds seconds;
  Report::Queries queries;
  bool is_given_up = false;
  std::size_t turned = 0;  ///< triangles against the normal of the surface
};

class Run {
 public:
  Run(const Model& model, const Sources& sources, const PipelineOptions& options,
      std::optional<double> corrected_sag = {})
      : model_(model), sources_(sources), options_(options), corrected_sag_(corrected_sag) {
    if (options.sizing.sag) sag_ = options.sizing.sag->in_units(model.diagonal);
    report_.options = options;
    report_.options.observer = nullptr;
    report_.warnings = model.warnings;
  }

  void mesh(MeshResult& result) {
    const auto start = std::chrono::steady_clock::now();
    make_spaces();
    place_nodes();
    mesh_patches();
    assemble_patches(result.mesh);
    measure(result.mesh);
    report_.seconds.wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.report = std::move(report_);
  }

 private:
  void tell(std::string_view stage, std::size_t done, std::size_t total) const {
    surfmesh::tell(options_.observer, stage, done, total);
  }

  void make_spaces() {
    const StageClock clock(report_.seconds.control);
    ControlSpaces made = make_control_spaces(model_, sources_, options_);
    std::move(made.warnings.begin(), made.warnings.end(), std::back_inserter(report_.warnings));
    std::move(made.shortfalls.begin(), made.shortfalls.end(),
              std::back_inserter(report_.shortfalls));
    spaces_ = std::move(made.spaces);
    for (std::size_t p = 0; p < spaces_.size(); ++p) {
      const TriMesh& mesh = spaces_[p]->mesh();
      report_.control.nodes += mesh.n_vertices();
      report_.control.triangles += mesh.n_faces();
      count_classes(mesh);
      surface_fields_.push_back(
          std::make_unique<SurfaceMetricField>(*model_.patches[p].surface, *spaces_[p]));
      fields_.push_back(surface_fields_.back().get());
    }
  }

  void count_classes(const TriMesh& mesh) {
    const auto handle = find(mesh, keys::face_class);
    if (!handle.is_valid()) return;  // a grid has none
    Report::Classes& classes = report_.control.classes;
    for (const FaceHandle fh : mesh.faces()) {
      switch (static_cast<Interpolation>(mesh.property(handle, fh))) {
        case Interpolation::Single:
          ++classes.single;
          break;
        case Interpolation::Triangle:
          ++classes.triangle;
          break;
        case Interpolation::Linear:
          ++classes.linear;
          break;
        default:
          ++classes.circles;
      }
    }
  }

  void place_nodes() {
    const StageClock clock(report_.seconds.boundary);
    tell("boundary", 0, model_.contours.size());
    BoundaryOptions boundary_options = options_.boundary;
    boundary_options.sag = sag_;
    BoundaryNodes boundary = place_contour_nodes(model_, fields_, boundary_options);
    nodes_ = std::move(boundary.contours);
    report_.control.queries.boundary = boundary.report.queries;
    numbers_ = std::make_unique<NodeNumbers>(model_, nodes_);
    tell("boundary", model_.contours.size(), model_.contours.size());
  }

  void mesh_patches() {
    patches_.resize(model_.patches.size());
    patch_reports_.resize(model_.patches.size());
    for_each_patch(model_, "mesh", options_.observer, boundary_counts(),
                   [this](std::size_t p) { mesh_patch(p); });
    for (const PatchReport& report : patch_reports_) take(report);
    tell_given_up();
    const StageClock clock(report_.seconds.assemble);
    if (split_improper_chords(patches_) > 0 || corrected_sag_) {
      share_indices(patches_.size(), [this](std::size_t p) {
        evaluate_vertices(patches_[p]);
        patch_reports_[p].turned = count_turned_triangles(patches_[p]);
      });
    }
    tell_turned();
  }

  /// Nodes on the contours of each patch: how much work the patch is goes by them, roughly.
  std::vector<std::size_t> boundary_counts() const {
    std::vector<std::size_t> counts(model_.patches.size(), 0);
    for (std::size_t c = 0; c < nodes_.size(); ++c) {
      for (const ContourUse& use : model_.contours[c].uses) {
        counts[static_cast<std::size_t>(use.patch)] += nodes_[c].points.size();
      }
    }
    return counts;
  }

  void take(const PatchReport& report) {
    report_.seconds += report.seconds;
    Report::Queries& queries = report_.control.queries;
    queries.triangulate += report.queries.triangulate;
    queries.refine += report.queries.refine;
    queries.improve += report.queries.improve;
  }

  void tell_given_up() {
    std::vector<char> is_given_up;
    for (const PatchReport& report : patch_reports_) is_given_up.push_back(report.is_given_up);
    const std::string names = detail::patch_names(model_, is_given_up);
    if (names.empty()) return;
    report_.shortfalls.push_back(
        fmt::format("{}: given up at three times the triangles that the sizes ask for: they change "
                    "direction faster than elements can follow; smaller stretch or a lower grade "
                    "helps",
                    names));
  }

  void tell_turned() {
    std::size_t turned = 0;
    for (const PatchReport& report : patch_reports_) turned += report.turned;
    if (turned == 0) return;
    report_.shortfalls.push_back(
        fmt::format("{} triangles are turned against the normal of the surface{}; smaller sizes "
                    "help (curvature, hmin, hmax)",
                    turned, turned_place()));
  }

  /// ", one in patch wing at (0, 0, 1)"; nothing where all are in fans around poles.
  std::string turned_place() const {
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      if (const auto place = find_turned_place(patches_[p])) {
        return fmt::format(", one in patch {} at {}", model_.patches[p].name, place_text(*place));
      }
    }
    return {};
  }

  void mesh_patch(std::size_t p) {
    triangulate_patch(p);
    refine_patch(p);
    improve_patch(p);
    count_elements(patches_[p].delaunay->n_faces());
    finish_patch(p);
  }

  void triangulate_patch(std::size_t p) {
    const StageClock clock(patch_reports_[p].seconds.triangulate);
    PatchMesh& patch = patches_[p];
    patch.surface = model_.patches[p].surface.get();
    patch.field = fields_[p];
    patch.boundary = collect_boundary(model_, static_cast<int>(p), nodes_, *numbers_, *patch.field);
    std::vector<std::vector<Uv>> loops;
    for (const BoundaryLoop& loop : patch.boundary.loops) {
      std::vector<Uv>& uvs = loops.emplace_back();
      for (const BoundaryNode& node : loop) uvs.push_back(node.uv);
    }
    BoundaryTriangulation triangulation = triangulate_boundary(loops, *patch.field);
    patch.delaunay = std::move(triangulation.delaunay);
    patch_reports_[p].queries.triangulate = triangulation.queries;
  }

  void refine_patch(std::size_t p) {
    PatchReport& report = patch_reports_[p];
    const StageClock clock(report.seconds.refine);
    RefineOptions refine_options = options_.refine;
    refine_options.observer = options_.observer;
    refine_options.max_elements = elements_left();
    const RefineReport refined = refine(*patches_[p].delaunay, *patches_[p].field, refine_options);
    report.queries.refine = refined.queries;
    report.is_given_up = refined.is_stopped;
  }

  void improve_patch(std::size_t p) {
    const StageClock clock(patch_reports_[p].seconds.improve);
    ImproveOptions improve_options = options_.improve;
    improve_options.observer = options_.observer;
    patch_reports_[p].queries.improve =
        improve(*patches_[p].delaunay, *patches_[p].field, improve_options).queries;
  }

  /// Elements that the patches which are not finished may have: each takes at least one. Whichever
  /// these are, there is an error if, and only if, all patches together have too many.
  std::size_t elements_left() const {
    const std::size_t count = elements_;
    expect_few(count + 1);
    return options_.refine.max_elements - count;
  }

  void count_elements(std::size_t count) { expect_few(elements_ += count); }

  void expect_few(std::size_t elements) const {
    const std::size_t most = options_.refine.max_elements;
    if (elements > most) {
      throw Error(ErrorCode::Limit, fmt::format("more than max_elements = {} triangles", most));
    }
  }

  void finish_patch(std::size_t p) {
    const StageClock clock(patch_reports_[p].seconds.assemble);
    evaluate_vertices(patches_[p]);
    patch_reports_[p].turned = mend_turned_triangles(patches_[p]);
    if (corrected_sag_) detail::correct_sag(patches_[p], *corrected_sag_);
  }

  void assemble_patches(PolyMesh& mesh) {
    const StageClock clock(report_.seconds.assemble);
    tell("assemble", 0, 1);
    AssembleReport report = assemble(mesh, model_, nodes_, *numbers_, patches_);
    for (std::string& warning : report.warnings) report_.warnings.push_back(std::move(warning));
    tell("assemble", 1, 1);
    compare(mesh);
  }

  void compare(const PolyMesh& mesh) {
    for (const MeshFault& fault : compare_with_promise(mesh, model_)) {
      report_.shortfalls.push_back(
          fmt::format("the mesh is not as the model promises: {}: {}, the first: {}", fault.kind,
                      fault.count, fault.places.front()));
    }
  }

  void measure(const PolyMesh& mesh) {
    const MeshTopology topology = measure_topology(mesh);
    report_.mesh = {topology.vertices,     topology.faces,     0,
                    model_.patches.size(), topology.is_closed, topology.euler};
    report_.edges = measure_edges(mesh);
    report_.quality = measure_quality(mesh);
    warn_of_flat_triangles(mesh);
    StageSeconds& s = report_.seconds;
    const double meshing = s.boundary + s.triangulate + s.refine + s.improve + s.quad + s.assemble;
    s.total = meshing + s.control;
    report_.triangles_per_second = meshing > 0 ? static_cast<double>(topology.faces) / meshing : 0;
  }

  void warn_of_flat_triangles(const PolyMesh& mesh) {
    const QualityStatistics& quality = report_.quality;
    if (quality.worst_face < 0 || quality.min >= kFlatQuality) return;
    const FaceHandle fh(quality.worst_face);
    const auto patch = mesh.property(require(mesh, keys::face_patch), fh);
    report_.warnings.push_back(fmt::format(
        "triangles are as flat as quality {:.3g}, in patch {} at {}: the boundary leaves less room "
        "than the sizes ask for; gaps get their sizes by proximity, not below hmin",
        quality.min, model_.patches[static_cast<std::size_t>(patch)].name,
        place_text(to_eigen(mesh.calc_face_centroid(fh)))));
  }

  const Model& model_;
  const Sources& sources_;
  const PipelineOptions& options_;
  std::optional<double> corrected_sag_;  ///< triangles above this are corrected one by one
  std::optional<double> sag_;            ///< asked for, model units
  Report report_;
  std::vector<std::unique_ptr<ControlSpace>> spaces_;
  std::vector<std::unique_ptr<SurfaceMetricField>> surface_fields_;
  std::vector<const MetricField*> fields_;
  std::vector<ContourNodes> nodes_;
  std::unique_ptr<NodeNumbers> numbers_;
  std::vector<PatchMesh> patches_;
  std::vector<PatchReport> patch_reports_;
  std::atomic<std::size_t> elements_ = 0;  ///< of the patches that are finished
};

/// Mesh the model once or until the sag is reached.
void mesh_as_asked(const Model& model, const Sources& sources, const PipelineOptions& options,
                   MeshResult& result) {
  if (!options.sizing.sag) {
    Run(model, sources, options).mesh(result);
    return;
  }
  result = detail::reach_sag(model, sources, options,
                             [&](const Sources& corrected, std::optional<double> corrected_sag) {
                               MeshResult once;
                               Run(model, corrected, options, corrected_sag).mesh(once);
                               return once;
                             });
}

/// The same, with an observer that all threads may tell and ask.
void mesh_observed(const Model& model, const Sources& sources, PipelineOptions options,
                   MeshResult& result) {
  if (!options.observer) return mesh_as_asked(model, sources, options, result);
  detail::SerialObserver observer(*options.observer);
  options.observer = &observer;
  try {
    mesh_as_asked(model, sources, options, result);
  } catch (const Error&) {
    // Which patch was at work then is a matter of chance.
    if (observer.has_cancelled()) throw_if_cancelled(&observer);
    throw;
  }
}

}  // namespace

MeshResult mesh_model(const Model& model, const Sources& sources, const PipelineOptions& options) {
  check(options);
  check(model);
  MeshResult result;  // OpenMesh's meshes cannot be moved, only copied
  with_threads(options.threads, [&] { mesh_observed(model, sources, options, result); });
  result.names = mesh_names(model);
  result.report.patches = measure_patches(result.mesh, result.names);
  return result;
}

}  // namespace surfmesh
