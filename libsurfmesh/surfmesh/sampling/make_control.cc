// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/make_control.hh"

#include <algorithm>

#include "surfmesh/control/control_grid.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/control/node_interpolation.hh"
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
/// hold the sizes: on a grid, and where discs end and gradation begins.
bool needs_interpolated_points(const PatchSources& sources, const ResolvedSizing& sizing,
                               const ControlOptions& options) {
  const bool has_others = sizing.follows_curvature() || !sources.everywhere.empty() ||
                          !sources.along.empty() || !sources.inside.empty() ||
                          !sources.fields.empty() || !sources.tables.empty() ||
                          !sources.trees.empty();
  const bool has_disc = std::any_of(
      sources.at.begin(), sources.at.end(),
      [](const AtSource& source) { return source.radius.value > 0 || source.outer.has_value(); });
  const bool needs_more = options.kind == ControlKind::Grid || options.regular_nodes > 0 ||
                          (has_disc && sizing.grade > 0);
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
  input.is_coarse = chosen.is_coarse;
}

/// Refine the triangulation of the nodes for shape; the new nodes have the sizes it gives there.
void add_inner_nodes(const Surface& surface, const ControlSpaceOptions& options,
                     std::vector<ControlNode>& nodes) {
  NodeTriangulation triangulation(surface.domain(), nodes);
  const ControlMesh control(surface.domain(), nodes,
                            {.interpolation = options.interpolation, .blend = options.blend});
  QueryHint hint;
  for (const Uv uv : triangulation.add_inner_nodes()) {
    const Jet jet = surface.evaluate(surface.domain().fold(uv), Order::First);
    const FirstFormFactor form = first_form_factor(jet.du, jet.dv);
    nodes.push_back({uv, jet.point, form, control.size({uv, jet.point, form}, hint)});
  }
}

/// Nodes where the sizes that hold the sag are known. They come from a mesh with the sizes of all
/// sources, so that they are as dense as elements can follow.
std::vector<ControlNode> sag_nodes(const TableSource& sag, const SizeField& field) {
  const auto known = table_nodes(sag, field.surface(), field.bounds());
  std::vector<ControlNode> nodes = corners_like_nearest(field.surface(), known);
  nodes.insert(nodes.end(), known.begin(), known.end());
  for (ControlNode& node : nodes) node.size = field.at(node.uv).size;
  return nodes;
}

}  // namespace

void check(const ControlOptions& options) {
  check_option(ranges::kControl, options.kind);
  check(node_options(options));
  check(space_options(options));
}

ControlInput collect_control_input(const Surface& surface, const ResolvedSizing& sizing,
                                   const PatchSources& sources, const ControlOptions& options) {
  if (needs_interpolated_points(sources, sizing, options)) {
    return collect_control_input(surface, sizing, with_interpolated_points(sources), options);
  }
  ControlNodeOptions own = node_options(options);
  own.precision = sources.precision().value_or(own.precision);
  check(own);
  const SizeField field(surface, sizing, sources, own.precision);
  std::vector<ControlNode> places = field_nodes(sources, field, sizing.grade > 0);
  ControlInput input{surface.domain(), {}, {}, options.kind, space_options(options)};
  input.options.grade = sizing.grade;
  check(input.options);
  const bool is_chosen = has_other_sources(sources, field) || places.empty();
  input.options.discs_meet_area_sources = is_chosen;
  if (options.kind == ControlKind::Grid) {
    take(choose_grid_nodes(field, own), input);
    input.extra_nodes = std::move(places);
    return input;
  }
  if (!sources.sag.empty()) {
    input.nodes = sag_nodes(sources.sag.front(), field);
  } else if (is_chosen) {
    take(choose_accurate_nodes(field, own), input);
  } else {
    input.nodes = corners_like_nearest(surface, places);
  }
  input.nodes.insert(input.nodes.end(), places.begin(), places.end());
  if (options.inner_nodes) add_inner_nodes(surface, input.options, input.nodes);
  return input;
}

std::unique_ptr<ControlSpace> make_control(const ControlInput& input) {
  if (input.kind == ControlKind::Grid) {
    return std::make_unique<ControlGrid>(input.domain, input.nodes, input.extra_nodes,
                                         input.options);
  }
  return std::make_unique<ControlMesh>(input.domain, input.nodes, input.options);
}

}  // namespace surfmesh
