// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/check_mesh.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <numbers>
#include <utility>

#include "surfmesh/across/metric_beyond.hh"
#include "surfmesh/assemble/promised_topology.hh"
#include "surfmesh/control/surface_metric_field.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/io/json.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/notice_json.hh"
#include "surfmesh/pipeline/statistics_json.hh"
#include "surfmesh/quality/contour_distance.hh"
#include "surfmesh/quality/corners_beyond.hh"
#include "surfmesh/quality/project_mesh.hh"
#include "surfmesh/quality/sag.hh"
#include "surfmesh/quality/self_intersections.hh"
#include "surfmesh/sizes/model_sources.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {
namespace {

/// How near chords between points of contours keep to these, as a share of the model's diagonal.
constexpr double kContourTolerance = 1e-6;

/// Share of the diagonal of a model beyond which a corner belongs to no mesh of it: these have
/// their corners near the surface, however coarse they are.
constexpr double kFarCorner = 0.1;

constexpr double kDegrees = 180 / std::numbers::pi;

MetricFit measure_metric(const PolyMesh& mesh) {
  return {measure_edges(mesh), measure_quality(mesh), measure_quads(mesh)};
}

/// Take the greatest distance of a mesh as the report of a run has it.
void add_sag(const PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
             const std::vector<SharpContour>& contours, const RunContext& context,
             SurfaceDistance& distance) {
  const Sag sag = measure_sag(mesh, model, search, context, {.contours = &contours});
  if (sag.max <= distance.max) return;
  const auto greatest = std::max_element(sag.of_faces.begin(), sag.of_faces.end());
  distance.max = sag.max;
  distance.max_at = sag.max_at;
  distance.max_contour = sag.max_contour;
  distance.max_face = static_cast<std::size_t>(greatest - sag.of_faces.begin());
}

/// Take the greatest distance of contours from a mesh without (u,v), which they do not need.
void add_contours(const PolyMesh& mesh, const std::vector<SharpContour>& contours,
                  const RunContext& context, SurfaceDistance& distance) {
  for (const ContourDistance& far : far_contour_points(mesh, contours, distance.max, context)) {
    if (far.distance <= distance.max) continue;
    distance.max = far.distance;
    distance.max_at = far.point;
    distance.max_contour = far.contour;
    distance.max_face = index(far.face);
  }
}

std::size_t count_corners_beyond(const PolyMesh& mesh) {
  const detail::CornersBeyond is_beyond(mesh);
  const auto corners = mesh.halfedges();
  return static_cast<std::size_t>(std::count_if(
      corners.begin(), corners.end(),
      [&](HalfedgeHandle corner) { return !mesh.is_boundary(corner) && is_beyond(corner); }));
}

/// Measure how far a mesh is from its model.
SurfaceDistance distance_of(const PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
                            bool is_projected, const RunContext& context) {
  SurfaceDistance distance = measure_distance(mesh, model, search, is_projected, context);
  const auto contours = sharp_contours(model, kContourTolerance * model.diagonal, context);
  if (is_projected) {
    add_contours(mesh, contours, context, distance);
  } else {
    add_sag(mesh, model, search, contours, context, distance);
  }
  return distance;
}

/// Take the greatest distance of the surface from a projected mesh, which may lack a part of it.
void add_surface(const std::optional<OneWayDistance>& from_surface, ModelFit& fit) {
  fit.from_surface = from_surface;
  if (!from_surface || from_surface->max <= fit.distance.max) return;
  fit.distance.max = from_surface->max;
  fit.distance.max_at = from_surface->max_at;
  fit.distance.max_face = static_cast<std::size_t>(from_surface->max_face);
  fit.distance.max_contour = -1;
}

std::vector<std::unique_ptr<SizeField>> size_fields(const ModelInput& input) {
  std::vector<std::unique_ptr<SizeField>> fields;
  const ResolvedSizing sizing = resolve(input.options.sizing, input.model);
  const auto sources = model_sources(input.model, input.sources, sizing);
  for (std::size_t p = 0; p < input.model.patches.size(); ++p) {
    fields.push_back(std::make_unique<SizeField>(*input.model.patches[p].surface, sizing,
                                                 sources[p], input.options.control.precision));
  }
  return fields;
}

/// Give each corner the metric at its (u,v) of its patch, or where its vertex is if that lies
/// beyond. Corners of one vertex with one patch and (u,v) are evaluated once.
template <class MetricAt>
void attach_metric(PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
                   const RunContext& context, MetricAt metric_at) {
  const detail::CornersBeyond is_beyond(mesh);
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto patch_of = require(mesh, keys::face_patch);
  detach(mesh, keys::corner_metric);
  const auto metric_of = attach(mesh, keys::corner_metric);
  for (const VertexHandle vh : mesh.vertices()) {
    if (index(vh) % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
    int patch = -1;
    Uv uv;
    Metric metric;
    for (const HalfedgeHandle corner : mesh.vih_range(vh)) {
      if (mesh.is_boundary(corner) || is_beyond(corner)) continue;
      const int corner_patch = mesh.property(patch_of, mesh.face_handle(corner));
      const Uv corner_uv = mesh.property(uv_of, corner);
      if (patch != corner_patch || !(uv == corner_uv)) {
        patch = corner_patch;
        uv = corner_uv;
        metric = metric_at(static_cast<std::size_t>(patch), uv);
      }
      mesh.property(metric_of, corner) = metric;
    }
  }
  set_metrics_beyond(mesh, model, search, [&](const SurfacePlace& place) {
    return metric_at(static_cast<std::size_t>(place.patch), place.uv);
  });
}

void attach_exact_metric(PolyMesh& mesh, const ModelInput& input, const SurfaceSearch& search,
                         const RunContext& context) {
  const auto fields = size_fields(input);
  attach_metric(mesh, input.model, search, context, [&](std::size_t patch, Uv uv) {
    const SizeField::Sample sample = fields[patch]->at(uv);
    return metric_from_size(sample.form, sample.size);
  });
}

/// The metric that a run would make a mesh by.
void attach_metric_of_run(PolyMesh& mesh, const ModelInput& input, const SurfaceSearch& search,
                          Observer* observer) {
  const RunContext context(observer, input.options.max_elements);
  const ResolvedSizing sizing = resolve(input.options.sizing, input.model);
  const ControlSpaces control =
      make_control_spaces(input.model, input.sources, sizing, input.options.control, context);
  std::vector<QueryHint> hints(control.spaces.size());
  attach_metric(mesh, input.model, search, context, [&](std::size_t patch, Uv uv) {
    const SurfaceMetricField field(*input.model.patches[patch].surface, *control.spaces[patch]);
    return field.at(uv, hints[patch]);
  });
}

/// The fault of this kind, made if there is none.
MeshFault& fault_of_kind(std::vector<MeshFault>& faults, const char* kind) {
  const auto found = std::find_if(faults.begin(), faults.end(),
                                  [&](const MeshFault& fault) { return fault.kind == kind; });
  return found != faults.end() ? *found : faults.emplace_back(MeshFault{kind, 0, {}});
}

/// Tell that a mesh is farther from its model than asked for.
Notice far_notice(const ModelFit& fit) {
  const SurfaceDistance& distance = fit.distance;
  Notice notice = shortfall(
      NoticeKind::SagNotReached,
      fmt::format(
          "the mesh is {:.4g} from the model at {}, in face {}{}; sag = {:.4g} is asked for",
          distance.max, point_text(distance.max_at), distance.max_face,
          fit.max_contour.empty() ? "" : " on contour " + fit.max_contour, *fit.sag));
  notice.point = distance.max_at;
  notice.contour = distance.max_contour;
  return notice;
}

/// Null without triangles.
Json quality_json(const QualityStatistics& quality) {
  if (quality.count == 0) return nullptr;
  return {{"min", quality.min},
          {"mean", quality.mean},
          {"below_0.3", quality.below_0_3},
          {"histogram", detail::histogram_json(quality.histogram)}};
}

/// Null without quads.
Json quads_json(const QuadStatistics& quads) {
  if (quads.count == 0) return nullptr;
  return {{"min_scaled_jacobian", quads.min_jacobian},
          {"mean_scaled_jacobian", quads.mean_jacobian},
          {"min_scaled_jacobian_in_space", quads.min_space_jacobian},
          {"mean_scaled_jacobian_in_space", quads.mean_space_jacobian},
          {"histogram", detail::histogram_json(quads.histogram)}};
}

Json notices_json(const MeshCheck& check) {
  return detail::notices_json(check.notices, [&check](int patch) {
    const auto p = static_cast<std::size_t>(patch);
    return p < check.patch_names.size() ? check.patch_names[p] : std::string();
  });
}

Json faults_json(const std::vector<MeshFault>& faults) {
  Json json = Json::array();
  for (const MeshFault& fault : faults) {
    json.push_back({{"kind", fault.kind}, {"count", fault.count}, {"places", fault.places}});
  }
  return json;
}

/// What is counted, but is no fault in itself.
Json places_json(const MeshFault& found) {
  return {{"count", found.count}, {"places", found.places}};
}

Json volume_json(const MeshCheck& check) {
  return check.faces.has_volume() ? Json(check.extent.volume) : Json();
}

Json box_json(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) return nullptr;
  const Vec3 &low = box.min(), &high = box.max();
  return {{"min", {low.x(), low.y(), low.z()}}, {"max", {high.x(), high.y(), high.z()}}};
}

Json counts_json(const FaceSetCheck& faces) {
  return {{"vertices", faces.vertices},
          {"edges", faces.edges},
          {"triangles", faces.triangles},
          {"quads", faces.quads},
          {"polygons", faces.polygons},
          {"boundary_edges", faces.boundary_edges},
          {"boundary_loops", faces.boundary_loops},
          {"components", faces.components},
          {"euler", faces.euler}};
}

Json angles_json(const ShapeStatistics& shape) {
  return {{"min", kDegrees * shape.min_angle},
          {"max", kDegrees * shape.max_angle},
          {"min_face", shape.min_angle_face},
          {"max_face", shape.max_angle_face},
          {"histogram", detail::histogram_json(shape.angles)}};
}

Json metric_json(const MetricFit& fit) {
  return {{"edges", detail::edges_json(fit.edges)},
          {"quality", quality_json(fit.quality)},
          {"quads", quads_json(fit.quads)}};
}

Json fit_json(const ModelFit& fit) {
  const SurfaceDistance& distance = fit.distance;
  return {{"projected", fit.is_projected},
          {"unjudged_faces", fit.distance.unjudged},
          {"corners_beyond", fit.corners_beyond},
          {"stored_metric", fit.is_by_stored_metric},
          {"exact_sizes", fit.is_by_exact_sizes},
          {"other_sizes", fit.has_other_sizes},
          {"edges", detail::edges_json(fit.sizes.edges)},
          {"quality", quality_json(fit.sizes.quality)},
          {"quads", quads_json(fit.sizes.quads)},
          {"sag", fit.sag ? Json(*fit.sag) : Json(nullptr)},
          {"distance",
           {{"max", distance.max},
            {"mean", distance.mean},
            {"max_face", distance.max_face},
            {"max_contour", fit.max_contour.empty() ? Json(nullptr) : Json(fit.max_contour)},
            {"max_at", {distance.max_at.x(), distance.max_at.y(), distance.max_at.z()}},
            {"max_corner", distance.max_corner}}},
          {"from_surface", fit.from_surface ? detail::distance_json(*fit.from_surface) : Json()},
          {"facets", fit.facets ? detail::facets_json(*fit.facets) : Json()}};
}

}  // namespace

MeshCheck check_mesh(const MeshArraysFile& file, Observer* observer) try {
  MeshCheck check;
  check.faces = check_face_set(file.mesh);
  check.self_intersections = find_self_intersections(file.mesh, RunContext(observer));
  check.extent = measure_extent(file.mesh);
  check.shape = measure_shape(file.mesh);
  check.notices = file.notices;
  check.faults = check.faces.faults;
  for (const std::size_t face : file.degenerate_faces) {
    fault_of_kind(check.faults, "degenerate_face").add([&] {
      return fmt::format("face {} of the file does not have three different corners, or no inside",
                         face);
    });
  }
  return check;
} catch (const std::bad_alloc&) {
  fail_without_memory("while checking a mesh");
}

std::optional<MetricFit> measure_stored_metric(const PolyMesh& mesh) try {
  if (!has_parameters(mesh) || !has_metric(mesh)) return std::nullopt;
  return measure_metric(mesh);
} catch (const std::bad_alloc&) {
  fail_without_memory("while checking a mesh");
}

ModelFit measure_fit(MeshFile& mesh, const ModelInput& input, JudgedBy judged_by,
                     Observer* observer) try {
  const RunContext context(observer);
  ModelFit fit;
  const SurfaceSearch search(input.model);
  fit.is_projected = !has_parameters(mesh.mesh);
  if (fit.is_projected) project_mesh(mesh.mesh, mesh.names.patches, input.model, search, context);
  fit.corners_beyond = count_corners_beyond(mesh.mesh);
  fit.distance = distance_of(mesh.mesh, input.model, search, fit.is_projected, context);
  if (fit.is_projected) {
    add_surface(measure_surface_to_mesh(search, mesh.mesh, context), fit);
  }
  fit.facets = measure_facet_distance(mesh.mesh, input.model, FacetsOf::AllCages, context);
  if (fit.distance.max_contour >= 0) {
    fit.max_contour = input.model.contour(fit.distance.max_contour).name;
  }
  fit.differences = compare_with_promise(mesh.mesh, input.model);
  if (fit.is_projected && fit.distance.max_corner > kFarCorner * input.model.diagonal) {
    fit.differences.push_back(
        {"corner_off_surface",
         1,
         {fmt::format("a corner is {:.3g} from the surface, {:.0f} % of the diagonal of the model: "
                      "this is no mesh of it",
                      fit.distance.max_corner,
                      100 * fit.distance.max_corner / input.model.diagonal)}});
  }
  fit.is_by_stored_metric =
      judged_by == JudgedBy::StoredMetric && !fit.is_projected && has_metric(mesh.mesh);
  const Sizing& sizing = input.options.sizing;
  if (sizing.sag) fit.sag = sizing.sag->in_units(input.model.diagonal);
  fit.is_by_exact_sizes = judged_by == JudgedBy::ExactSizes;
  if (fit.is_by_exact_sizes) {
    fit.has_other_sizes = sizing.grade > 0 || sizing.sag || !input.sources.at.empty();
    attach_exact_metric(mesh.mesh, input, search, context);
  } else if (!fit.is_by_stored_metric) {
    fit.has_other_sizes = sizing.sag.has_value();
    attach_metric_of_run(mesh.mesh, input, search, observer);
  }
  fit.sizes = measure_metric(mesh.mesh);
  return fit;
} catch (const std::bad_alloc&) {
  fail_without_memory("while comparing a mesh with its model");
}

void add_fit(MeshCheck& check, ModelFit fit) try {
  // The comparison knows which duplicates are cuts.
  std::erase_if(check.faults,
                [](const MeshFault& fault) { return fault.kind == "duplicate_vertex"; });
  for (const auto& faults : {fit.distance.faults, fit.differences}) {
    check.faults.insert(check.faults.end(), faults.begin(), faults.end());
  }
  if (fit.sag && fit.distance.max > *fit.sag) check.notices.push_back(far_notice(fit));
  check.fit = std::move(fit);
} catch (const std::bad_alloc&) {
  fail_without_memory("while checking a mesh");
}

std::string to_json(const MeshCheck& check) try {
  const ShapeStatistics& shape = check.shape;
  const Json json = {
      {"mesh", check.mesh},
      {"model", check.model.empty() ? Json() : Json(check.model)},
      {"clean", check.faults.empty()},
      {"faults", faults_json(check.faults)},
      {"notices", notices_json(check)},
      {"counts", counts_json(check.faces)},
      {"open_edges", places_json(check.faces.open_edges)},
      {"self_intersections", places_json(check.self_intersections)},
      {"closed", check.faces.is_closed},
      {"manifold", check.faces.is_manifold},
      {"oriented", check.faces.is_oriented},
      {"area", check.extent.area},
      {"volume", volume_json(check)},
      {"box", box_json(check.extent.box)},
      {"angles", angles_json(shape)},
      {"edge_lengths",
       {{"min", shape.min_edge}, {"mean", shape.mean_edge}, {"max", shape.max_edge}}},
      {"shape", quality_json(shape.quality)},
      {"stored_metric", check.stored ? metric_json(*check.stored) : Json()},
      {"fit", check.fit ? fit_json(*check.fit) : Json()}};
  // Names of files need not be UTF-8: what is not becomes a replacement character.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
} catch (const std::bad_alloc&) {
  fail_without_memory("while writing a report");
}

}  // namespace surfmesh
