// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/model/model.hh"
#include "surfmesh/model_file/read_model.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/options.hh"

/// The options that a model file has, and those that are asked for beside it.
namespace surfmesh::detail {

/// Where the options belong in a file.
KeyPlaces places_of_options();

/// The options of a model file of this name, over the defaults.
///
/// Throws   InvalidInput with the place of an option that is unknown, in the wrong object or out of
///          its bounds
PipelineOptions file_options(const ModelFile& file, const std::string& name);

/// True for an option that leaves all as it is.
bool is_default(const FileOption& entry);

/// What is asked for from outside replaces the options of a file.
void set_given(const LoadOptions& given, PipelineOptions& options);

/// Note in the model the options of models that it was asked for as a whole.
void note_options(const PipelineOptions& options, Model& model);

}  // namespace surfmesh::detail
