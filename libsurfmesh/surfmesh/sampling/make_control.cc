// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/make_control.hh"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "surfmesh/control/control_cells.hh"
#include "surfmesh/control/control_grid.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/control/node_interpolation.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/sampling/accurate_nodes.hh"
#include "surfmesh/sizes/point_nodes.hh"
#include "surfmesh/sizes/table_sizes.hh"

namespace surfmesh {
namespace {

ControlNodeOptions node_options(const ControlOptions& options) {
  return {.regular = options.regular_nodes,
          .precision = options.precision,
          .by_distance = options.interpolation != Interpolation::Linear};
}

/// Without gradation.
ControlSpaceOptions space_options(const ControlOptions& options) {
  return {.interpolation = options.interpolation,
          .epsilon = options.epsilon,
          .blend = options.blend,
          .lookup = options.lookup,
          .reuse = options.reuse};
}

/// True if there is nothing but `at`, not even curvature, and it takes more than its own nodes to
/// hold the sizes: in a lattice, and where discs end and gradation begins.
bool needs_interpolated_points(const PatchSources& sources, const ResolvedSizing& sizing,
                               const ControlOptions& options) {
  const bool has_others = sizing.follows_curvature() || !sources.everywhere.empty() ||
                          !sources.along.empty() || !sources.inside.empty() ||
                          !sources.fields.empty() || !sources.tables.empty() ||
                          !sources.trees.empty();
  const bool has_disc = std::any_of(
      sources.at.begin(), sources.at.end(),
      [](const AtSource& source) { return source.radius.value > 0 || source.outer.has_value(); });
  const bool needs_more = effective_kind(options) != ControlKind::Mesh ||
                          options.regular_nodes > 0 || (has_disc && sizing.grade > 0);
  return !has_others && !sources.at.empty() && needs_more;
}

/// The sources with those of `at` as a table, too.
PatchSources with_interpolated_points(const PatchSources& sources) {
  PatchSources result = sources;
  TableSource& table = result.tables.emplace_back();
  for (const AtSource& source : sources.at) {
    table.nodes.push_back({source.at, source.outer ? source.outer->size : source.size, {}});
  }
  return result;
}

void take(ChosenNodes chosen, ControlInput& input) {
  input.nodes = std::move(chosen.nodes);
  input.sampling.is_coarse = chosen.is_coarse;
}

/// Refine the triangulation of the nodes for shape; the new nodes have the sizes it gives there. If
/// there are none, the triangulation is kept.
void add_inner_nodes(const Surface& surface, ControlInput& input) {
  auto triangulation = std::make_unique<NodeTriangulation>(surface.domain(), input.nodes);
  const std::vector<Uv> added = triangulation->add_inner_nodes();
  if (added.empty()) {
    input.triangulation = std::move(triangulation);
    return;
  }
  const ControlMesh control(
      surface.domain(), input.nodes,
      {.interpolation = input.options.interpolation, .blend = input.options.blend});
  QueryHint hint;
  for (const Uv uv : added) {
    const Jet jet = surface.evaluate(surface.domain().fold(uv), Order::First);
    const FirstFormFactor form = first_form_factor(jet.du, jet.dv);
    input.nodes.push_back({uv, jet.point, form, control.size({uv, jet.point, form}, hint)});
  }
}

/// Takes the field with it.
ControlCells::SampleNode sample_of(std::shared_ptr<const SizeField> field) {
  return [field = std::move(field)](Uv uv) {
    const SizeField::Sample sample = field->at(uv);
    return ControlNode{uv, sample.point, sample.form, sample.size};
  };
}

/// A lattice with the sizes of a field and of single points.
void make_lattice(const std::shared_ptr<const SizeField>& field, const ControlNodeOptions& options,
                  const std::vector<ControlNode>& points, ControlInput& input,
                  const RunContext& context) {
  const Surface& surface = field->surface();
  if (input.kind == ControlKind::Cells) {
    auto cells = std::make_unique<ControlCells>(surface.domain(), first_cells(surface),
                                                sample_of(field), input.options, points);
    input.sampling = sample_cells(*field, *cells, options.precision, context);
    input.lattice = std::move(cells);
  } else {
    const ChosenNodes chosen = choose_grid_nodes(*field, options, context);
    auto grid = std::make_unique<ControlGrid>(input.domain, chosen.nodes, input.options, points);
    input.sampling.is_coarse = chosen.is_coarse;
    if (options.regular == 0) {
      input.sampling.precision =
          sample_precision(*field, *grid, options.precision, kLeastCellLength, context);
    }
    input.lattice = std::move(grid);
  }
  input.lattice->hold_points(points);
}

/// The nodes of a mesh: those that sources give, and others by the precision.
void collect_mesh_nodes(const SizeField& field, const ControlNodeOptions& options,
                        const std::vector<ControlNode>& places, ControlInput& input) {
  if (input.options.discs_meet_area_sources) {
    take(choose_accurate_nodes(field, options), input);
  } else {
    input.nodes = corners_like_nearest(field.surface(), places);
  }
  input.nodes.insert(input.nodes.end(), places.begin(), places.end());
}

std::string_view option_of_mesh(const ControlOptions& options) {
  const ControlOptions defaults;
  if (options.inner_nodes) return ranges::kInnerNodes.name;
  if (options.interpolation != defaults.interpolation) return ranges::kInterpolation.name;
  if (options.epsilon != defaults.epsilon) return ranges::kEpsilon.name;
  if (options.lookup != defaults.lookup) return ranges::kLookup.name;
  if (options.reuse != 0) return ranges::kReuse.name;
  return {};
}

}  // namespace

ControlKind effective_kind(const ControlOptions& options) {
  if (options.kind != ControlKind::Automatic) return options.kind;
  const bool is_mesh = options.regular_nodes > 0 || !option_of_mesh(options).empty();
  return is_mesh ? ControlKind::Mesh : ControlKind::Cells;
}

void check(const ControlOptions& options) {
  check_option(ranges::kControl, options.kind);
  check(node_options(options));
  check(space_options(options));
}

std::optional<Notice> unused_option(const ControlOptions& options) {
  if (effective_kind(options) != options.kind || options.kind == ControlKind::Mesh) return {};
  std::string_view unused = option_of_mesh(options);
  if (options.kind == ControlKind::Cells && options.regular_nodes > 0) unused = ranges::kNodes.name;
  if (unused.empty()) return {};
  return warning(NoticeKind::UnusedOption,
                 fmt::format("{} has no effect with control = {}, but with control = mesh", unused,
                             to_text(ranges::kControl, static_cast<double>(options.kind))));
}

ControlInput collect_control_input(const Surface& surface, const ResolvedSizing& sizing,
                                   const PatchSources& sources, const ControlOptions& options,
                                   const RunContext& context) {
  if (needs_interpolated_points(sources, sizing, options)) {
    return collect_control_input(surface, sizing, with_interpolated_points(sources), options,
                                 context);
  }
  ControlNodeOptions own = node_options(options);
  own.precision = sources.precision().value_or(own.precision);
  check(own);
  const auto field = std::make_shared<SizeField>(surface, sizing, sources, own.precision);
  std::vector<ControlNode> places = field_nodes(sources, *field, sizing.grade > 0);
  ControlInput input{surface.domain(), effective_kind(options), {}, space_options(options)};
  input.options.grade = sizing.grade;
  check(input.options);
  input.options.discs_meet_area_sources = has_other_sources(sources, *field) || places.empty();
  if (input.kind != ControlKind::Mesh) {
    input.options.reuse = 0;  // as unused_option tells
    make_lattice(field, own, places, input, context);
  } else {
    collect_mesh_nodes(*field, own, places, input);
    if (options.inner_nodes) add_inner_nodes(surface, input);
  }
  return input;
}

std::unique_ptr<ControlSpace> make_control(ControlInput& input, const RunContext& context) {
  if (input.triangulation) {
    const auto triangulation = std::exchange(input.triangulation, nullptr);
    return std::make_unique<ControlMesh>(std::move(*triangulation), input.nodes, input.options);
  }
  if (!input.lattice) {
    return std::make_unique<ControlMesh>(input.domain, input.nodes, input.options);
  }
  if (input.options.grade > 0) input.lattice->grade_all(context);
  return std::move(input.lattice);
}

void finish(ControlSpace& space) {
  if (auto* lattice = dynamic_cast<LatticeSpace*>(&space)) lattice->finish();
}

}  // namespace surfmesh
