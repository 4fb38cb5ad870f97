// SPDX-License-Identifier: BSD-3-Clause
#include "compare/exact_metric.hh"

#include <fmt/format.h>

#include "surfmesh/core/error.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/sizes/model_sources.hh"

namespace surfmesh::compare {

ExactMetric::ExactMetric(const std::filesystem::path& model) : input_(load_model(model)) {
  const Model& loaded = input_.model;
  if (loaded.patches.size() != 1) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{} has {} patches, not 1", model.string(), loaded.patches.size()));
  }
  const ResolvedSizing sizing = resolve(input_.options.sizing, loaded);
  const auto sources = model_sources(loaded, input_.sources, sizing);
  field_ = std::make_unique<SizeField>(*loaded.patches[0].surface, sizing, sources[0],
                                       input_.options.control.precision);
}

Metric ExactMetric::at(Uv uv) const {
  const SizeField::Sample sample = field_->at(uv);
  return metric_from_size(sample.form, sample.size);
}

}  // namespace surfmesh::compare
