// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "surfmesh/core/values.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh::compare {

/// The metric that a model of one patch asks for, without a control space.
class ExactMetric {
 public:
  /// Throws   as load_model; InvalidInput if there are several patches
  explicit ExactMetric(const std::filesystem::path& model);

  Metric at(Uv uv) const;

  Domain domain() const { return field_->surface().domain(); }

 private:
  ModelInput input_;
  std::unique_ptr<SizeField> field_;
};

}  // namespace surfmesh::compare
