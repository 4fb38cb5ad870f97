// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/model_file/read_model.hh"
#include "surfmesh/pipeline/load_model.hh"

/// The step of load_model that reads cages.
namespace surfmesh::detail {

/// The model of a file that is a cage.
///
/// Throws   InvalidInput, Io; Cancelled
ModelInput load_cage(const std::filesystem::path& path, const LoadOptions& options,
                     const RunContext& context);

/// Read the cages of a model file and add them to the model.
///
/// Returns  the groups that are whole cages
/// Throws   InvalidInput with the place in the file, Io; Cancelled
std::set<std::size_t> append_cages(const ModelFile& file, const std::string& name,
                                   const CageOptions& given, const RunContext& context,
                                   ModelInput& result);

}  // namespace surfmesh::detail
