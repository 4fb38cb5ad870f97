// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/scaled_spaces.hh"

#include <utility>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/pipeline/for_each_patch.hh"
#include "surfmesh/sizes/model_sources.hh"

namespace surfmesh::detail {
namespace {

/// The sizes of a patch that are not scaled: all but those that the sag takes from its curvature.
/// Null if there are none.
std::shared_ptr<const SizeField> wishes_of(const Surface& surface, const ResolvedSizing& sizing,
                                           const PatchSources& sources, double precision) {
  // With the sag first: what is interpolated between points depends on it.
  const SizeField all(surface, sizing, sources, sources.precision().value_or(precision));
  auto field = std::make_shared<const SizeField>(all.without_sag());
  return field->has_source() ? field : nullptr;
}

}  // namespace

ScaledSpaces::ScaledSpaces(const Model& model, const Sources& sources, const ResolvedSizing& sizing,
                           const ControlOptions& options, const RunContext& context)
    : model_(model),
      context_(context),
      bounds_(sizing.bounds),
      bases_(make_control_bases(model, sources, sizing, options, context)) {
  if (effective_kind(options) == ControlKind::Mesh) return;
  wishes_.resize(model.patches.size());
  share_indices(model.patches.size(), [&](std::size_t p) {
    wishes_[p] = wishes_of(*model.patches[p].surface, sizing, bases_.sources[p], options.precision);
  });
  for (const auto& space : bases_.control.spaces) {
    lattices_.push_back(dynamic_cast<const LatticeSpace*>(space.get()));
    factors_.push_back(std::make_shared<SizeFactors>(*lattices_.back()));
  }
  graded_.resize(lattices_.size());
}

ControlSpaces ScaledSpaces::make() {
  ControlSpaces result;
  result.notices = bases_.control.notices;
  result.precision = bases_.control.precision;
  if (!can_scale()) {
    result.spaces = std::move(bases_.control.spaces);
  } else {
    result.spaces.resize(lattices_.size());
    share_indices(lattices_.size(), [&](std::size_t p) { result.spaces[p] = scaled(p); });
  }
  finish_control_spaces(model_, bases_.inputs, result.spaces, context_);
  return result;
}

std::unique_ptr<ControlSpace> ScaledSpaces::scaled(std::size_t patch) {
  return graded(patch).changed_copy([](const ControlNode& node) { return node.size; });
}

const LatticeSpace& ScaledSpaces::graded(std::size_t patch) {
  const int changes = factors_[patch]->changes();
  if (changes == 0) return *lattices_[patch];  // these are graded within their patch
  Graded& kept = graded_[patch];
  if (kept.changes == changes) return *kept.space;
  const auto change = [bounds = bounds_, factors = factors_[patch], wishes = wishes_[patch],
                       near = -1](const ControlNode& node) mutable {
    const SizeTensor size = bounds.clamp(surfmesh::scaled(node.size, factors->at(node.uv, near)));
    return wishes ? minimum(size, wishes->at(node.uv).size) : size;
  };
  kept = {lattices_[patch]->changed_copy(change), changes};
  if (bases_.inputs[patch].options.grade > 0) kept.space->grade_all(context_);
  return *kept.space;
}

}  // namespace surfmesh::detail
