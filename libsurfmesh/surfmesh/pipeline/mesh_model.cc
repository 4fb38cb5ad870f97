// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/mesh_model.hh"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <utility>
#include <vector>

#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/assemble/turned_triangles.hh"
#include "surfmesh/boundary/patch_boundary.hh"
#include "surfmesh/control/contour_gradation.hh"
#include "surfmesh/control/make_control.hh"
#include "surfmesh/control/model_sources.hh"
#include "surfmesh/control/parse_length.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/refine/boundary_triangulation.hh"

namespace surfmesh {
namespace {

constexpr double kNanosecond = 1e-9;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + kNanosecond * static_cast<double>(now.tv_nsec);
}

/// Adds the processor time of a scope to a member of the report.
class StageClock {
 public:
  explicit StageClock(double& seconds) : seconds_(seconds), start_(processor_seconds()) {}
  ~StageClock() { seconds_ += processor_seconds() - start_; }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

 private:
  double& seconds_;
  double start_;
};

class Run {
 public:
  Run(const Model& model, const Sources& sources, const PipelineOptions& options)
      : model_(model), sources_(sources), options_(options) {
    report_.options = options;
    report_.options.observer = nullptr;
    report_.warnings = model.warnings;
  }

  MeshResult mesh() {
    const auto start = std::chrono::steady_clock::now();
    make_control_spaces();
    place_nodes();
    mesh_patches();
    MeshResult result = assemble_patches();
    measure(result.mesh);
    report_.seconds.wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.report = std::move(report_);
    return result;
  }

 private:
  void tell(std::string_view stage, std::size_t done, std::size_t total) const {
    if (!options_.observer) return;
    options_.observer->progress(stage, done, total);
    throw_if_cancelled(options_.observer);
  }

  /// Call `body(index)`, and name the patch in its errors.
  template <class Body>
  void for_each_patch(std::string_view stage, Body body) {
    for (std::size_t p = 0; p < model_.patches.size(); ++p) {
      tell(stage, p, model_.patches.size());
      try {
        body(p);
      } catch (const Error& error) {
        throw Error(error.code(),
                    fmt::format("patch {}: {}", model_.patches[p].name, error.what()));
      }
    }
    tell(stage, model_.patches.size(), model_.patches.size());
  }

  void make_control_spaces() {
    const StageClock clock(report_.seconds.control);
    count_clamped_sizes();
    patch_sources_ = model_sources(model_, sources_, options_.sizing);
    for_each_patch("control", [this](std::size_t p) { make_control_space(p); });
    if (!grade_across_contours(model_, inputs_, spaces_, options_.observer).has_converged) {
      report_.shortfalls.push_back("gradation across contours has not come to an end");
    }
    inputs_.clear();
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

  void count_clamped_sizes() {
    const SizeBounds bounds(options_.sizing, model_.diagonal);
    const std::size_t count = count_clamped(sources_, bounds);
    if (count == 0) return;
    report_.warnings.push_back(
        fmt::format("{} sizes of sources are brought into the bounds hmin = {} and hmax = {}",
                    count, bounds.hmin, bounds.hmax));
  }

  void make_control_space(std::size_t p) {
    inputs_.push_back(collect_control_input(*model_.patches[p].surface, options_.sizing,
                                            patch_sources_[p], model_.diagonal, options_.control));
    spaces_.push_back(make_control(inputs_.back()));
  }

  void count_classes(const TriMesh& mesh) {
    const auto handle = find(mesh, keys::face_class);
    if (!handle.is_valid()) return;  // a grid has none
    Report::Classes& classes = report_.control.classes;
    for (const FaceHandle fh : mesh.faces()) {
      const int index = mesh.property(handle, fh);
      ++(index == 0 ? classes.single : index == 1 ? classes.triangle : classes.circles);
    }
  }

  void place_nodes() {
    const StageClock clock(report_.seconds.boundary);
    tell("boundary", 0, model_.contours.size());
    BoundaryNodes boundary = place_contour_nodes(model_, fields_, options_.boundary);
    nodes_ = std::move(boundary.contours);
    report_.control.queries.boundary = boundary.report.queries;
    numbers_ = std::make_unique<NodeNumbers>(model_, nodes_);
    tell("boundary", model_.contours.size(), model_.contours.size());
  }

  void mesh_patches() {
    patches_.resize(model_.patches.size());
    std::size_t elements = 0;
    for_each_patch("mesh", [&](std::size_t p) {
      RefineOptions refine_options = options_.refine;
      refine_options.observer = options_.observer;
      refine_options.max_elements -= elements;
      mesh_patch(p, refine_options);
      elements += patches_[p].delaunay->n_faces();
      if (elements >= options_.refine.max_elements) {
        throw Error(ErrorCode::Limit, fmt::format("more than max_elements = {} triangles",
                                                  options_.refine.max_elements));
      }
    });
    const StageClock clock(report_.seconds.assemble);
    for (PatchMesh& patch : patches_) {
      evaluate_vertices(patch);
      mend_turned_triangles(patch);
    }
    split_improper_chords(patches_);
    std::size_t turned = 0;
    for (PatchMesh& patch : patches_) {
      evaluate_vertices(patch);
      turned += count_turned_triangles(patch);
    }
    if (turned > 0) {
      report_.shortfalls.push_back(
          fmt::format("{} triangles are turned against the normal of the surface; smaller sizes "
                      "help (curvature, hmax)",
                      turned));
    }
  }

  void mesh_patch(std::size_t p, const RefineOptions& refine_options) {
    PatchMesh& patch = patches_[p];
    patch.surface = model_.patches[p].surface.get();
    patch.field = fields_[p];
    {
      const StageClock clock(report_.seconds.triangulate);
      patch.boundary =
          collect_boundary(model_, static_cast<int>(p), nodes_, *numbers_, *patch.field);
      std::vector<std::vector<Uv>> loops;
      for (const BoundaryLoop& loop : patch.boundary.loops) {
        std::vector<Uv>& uvs = loops.emplace_back();
        for (const BoundaryNode& node : loop) uvs.push_back(node.uv);
      }
      BoundaryTriangulation triangulation = triangulate_boundary(loops, *patch.field);
      patch.delaunay = std::move(triangulation.delaunay);
      report_.control.queries.triangulate += triangulation.queries;
    }
    {
      const StageClock clock(report_.seconds.refine);
      report_.control.queries.refine += refine(*patch.delaunay, *patch.field, refine_options).queries;
    }
    const StageClock clock(report_.seconds.improve);
    ImproveOptions improve_options = options_.improve;
    improve_options.observer = options_.observer;
    report_.control.queries.improve +=
        improve(*patch.delaunay, *patch.field, improve_options).queries;
  }

  MeshResult assemble_patches() {
    const StageClock clock(report_.seconds.assemble);
    tell("assemble", 0, 1);
    Assembly assembly = assemble(model_, nodes_, *numbers_, patches_);
    for (std::string& warning : assembly.report.warnings) {
      report_.warnings.push_back(std::move(warning));
    }
    tell("assemble", 1, 1);
    return {std::move(assembly.mesh), {}};
  }

  void measure(const PolyMesh& mesh) {
    const MeshTopology topology = measure_topology(mesh);
    report_.mesh = {topology.vertices, topology.faces, 0, model_.patches.size(),
                    topology.is_closed, topology.euler};
    report_.edges = measure_edges(mesh);
    report_.quality = measure_quality(mesh);
    StageSeconds& s = report_.seconds;
    const double meshing =
        s.boundary + s.triangulate + s.refine + s.improve + s.quad + s.assemble;
    s.total = meshing + s.control;
    report_.triangles_per_second =
        meshing > 0 ? static_cast<double>(topology.faces) / meshing : 0;
  }

  const Model& model_;
  const Sources& sources_;
  const PipelineOptions& options_;
  Report report_;
  std::vector<ControlInput> inputs_;
  std::vector<std::unique_ptr<ControlSpace>> spaces_;
  std::vector<std::unique_ptr<SurfaceMetricField>> surface_fields_;
  std::vector<PatchSources> patch_sources_;
  std::vector<const MetricField*> fields_;
  std::vector<ContourNodes> nodes_;
  std::unique_ptr<NodeNumbers> numbers_;
  std::vector<PatchMesh> patches_;
};

/// Throws   InvalidInput for a source of a patch that does not exist
void check_patches(const Model& model, const Sources& sources) {
  const auto check_patch = [&](int patch) {
    if (patch < 0 || static_cast<std::size_t>(patch) >= model.patches.size()) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("a source names patch {} of {}", patch, model.patches.size()));
    }
  };
  const auto check_all = [&](const auto& list) {
    for (const auto& source : list) check_patch(source.patch);
  };
  check_all(sources.everywhere);
  check_all(sources.at);
  check_all(sources.along);
  check_all(sources.inside);
  check_all(sources.fields);
  check_all(sources.tables);
}

void check_length(const char* name, const Length& length) {
  if (length.value > 0 && std::isfinite(length.value)) return;
  throw Error(ErrorCode::InvalidOption, fmt::format("{} = {} is outside its range: a length above 0",
                                                    name, to_text(length)));
}

/// Throws   InvalidOption if hmin or hmax is no length, or hmin above hmax, which only the size of
///          the model may tell
void check_bounds(const Model& model, const Sizing& sizing) {
  check_length("hmin", sizing.hmin);
  check_length("hmax", sizing.hmax);
  const double hmin = sizing.hmin.in_units(model.diagonal);
  const double hmax = sizing.hmax.in_units(model.diagonal);
  if (hmin <= hmax) return;
  throw Error(ErrorCode::InvalidOption,
              fmt::format("hmin = {} must not be above hmax = {}, which are lengths of {:.6g} and "
                          "{:.6g}",
                          to_text(sizing.hmin), to_text(sizing.hmax), hmin, hmax));
}

}  // namespace

MeshResult mesh_model(const Model& model, const Sources& sources, const PipelineOptions& options) {
  check(options);
  check(model);
  check_bounds(model, options.sizing);
  check_patches(model, sources);
  return Run(model, sources, options).mesh();
}

}  // namespace surfmesh
