// SPDX-License-Identifier: BSD-3-Clause
#include "paper/experiment.hh"

#include <fmt/format.h>

#include "surfmesh/control/surface_metric_field.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/quality/statistics.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh::paper {
namespace {

/// The metric distance of R with which about 27 % of the questions are answered by the last answer,
/// as in table 5. The middles of two neighbouring triangles are 0.58 apart.
constexpr double kReuse = 0.55;

/// Sweeps of the paper's smoothing.
constexpr int kSweeps = 2;

std::string_view letter(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::Single:
      return "V_s";
    case Interpolation::Triangle:
      return "V_t";
    case Interpolation::Circles:
      return "V_o";
    case Interpolation::Automatic:
      return "V_x";
    default:
      return "linear";
  }
}

EdgeFigures figures(const EdgeStatistics& edges) { return {edges.mean, edges.stddev}; }

}  // namespace

std::string label(const Variant& variant) {
  const bool has_letters = variant.has_inner_nodes || variant.is_reusing;
  return fmt::format("{}{}{}{}", letter(variant.interpolation), has_letters ? "+" : "",
                     variant.has_inner_nodes ? "I" : "", variant.is_reusing ? "R" : "");
}

double Outcome::generation_seconds() const { return report.seconds.sum(is_meshing); }

double Outcome::control_seconds() const { return report.seconds[Stage::Control]; }

double Outcome::steps_of_a_walk() const {
  const QueryCounts answers = report.control.queries.sum();
  return answers.walks == 0
             ? 0
             : static_cast<double>(answers.steps) / static_cast<double>(answers.walks);
}

Experiment::Experiment(const std::filesystem::path& model) : input_(load_model(model)) {
  if (input_.model.patches.size() != 1) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: an example has one patch", model.string()));
  }
}

PipelineOptions Experiment::options(const Variant& variant, Way way, bool has_quads) const {
  PipelineOptions options = input_.options;
  options.threads = 1;
  options.control.kind = ControlKind::Mesh;
  options.control.interpolation = variant.interpolation;
  options.control.inner_nodes = variant.has_inner_nodes;
  options.control.regular_nodes = variant.nodes;
  options.quads.is_on = has_quads;
  if (way == Way::Today) return options;
  options.refine.placement = Placement::Circumcentre;
  options.refine.conformity = variant.conformity;
  options.improve = {.smoothing = way == Way::Paper ? Smoothing::Element : Smoothing::Off,
                     .sweeps = kSweeps,
                     .repairs = 0};
  options.quads.method = QuadMethod::Frontal;
  if (variant.is_reusing) options.control.reuse = kReuse;
  return options;
}

Outcome Experiment::run(const Variant& variant, Way way, bool has_quads) {
  auto result = std::make_shared<MeshResult>(
      mesh_model(input_.model, input_.sources, options(variant, way, has_quads)));
  Outcome outcome;
  outcome.report = result->report;
  outcome.own = figures(outcome.report.edges);
  outcome.by_triangles = measure(result->mesh, variant, Interpolation::Triangle);
  outcome.by_circles = measure(result->mesh, variant, Interpolation::Circles);
  outcome.result = std::move(result);
  return outcome;
}

const ControlSpace& Experiment::control(const Variant& variant) {
  Variant own = variant;
  own.is_reusing = false;
  const std::string key = fmt::format("{} {}", label(own), own.nodes);
  if (!controls_.contains(key)) {
    const ResolvedSizing sizing = resolve(input_.options.sizing, input_.model);
    controls_.emplace(key, make_control_spaces(input_.model, input_.sources, sizing,
                                               options(own, Way::Paper, false).control));
  }
  return *controls_.at(key).spaces.front();
}

/// The edges in the metric of the same nodes by another interpolation.
EdgeFigures Experiment::measure(PolyMesh& mesh, Variant variant, Interpolation by) {
  variant.interpolation = by;
  const SurfaceMetricField field(*input_.model.patches.front().surface, control(variant));
  const auto uv = require(mesh, keys::corner_uv);
  const auto metric = require(mesh, keys::corner_metric);
  QueryHint hint;
  for (const VertexHandle vh : mesh.vertices()) {
    Uv last;
    Metric there;
    for (const HalfedgeHandle heh : mesh.vih_range(vh)) {
      if (mesh.is_boundary(heh)) continue;
      const Uv at = mesh.property(uv, heh);
      if (!(at == last)) there = field.at(last = at, hint);
      mesh.property(metric, heh) = there;
    }
  }
  return figures(measure_edges(mesh));
}

}  // namespace surfmesh::paper
