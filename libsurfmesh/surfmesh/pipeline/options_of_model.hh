// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "surfmesh/core/notice.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pipeline/options.hh"

/// The options of cages and of joining act where a model is made; what they are afterwards changes
/// nothing.
namespace surfmesh::detail {

/// True if the model was made with an option of this value, in text as for set_option.
bool was_made_with(const Model& model, std::string_view option, std::string_view value);

/// Warn of options that the model was not made with, and say where they belong.
Notices options_too_late(const Model& model, const PipelineOptions& options);

/// The options with those that the model was made with in place of what has no effect.
PipelineOptions options_in_effect(const Model& model, PipelineOptions options);

}  // namespace surfmesh::detail
