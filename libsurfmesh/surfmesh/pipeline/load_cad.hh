// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/model_file/read_model.hh"
#include "surfmesh/pipeline/load_model.hh"

/// The step of load_model that reads CAD files.
namespace surfmesh::detail {

/// The model of a CAD file.
///
/// Throws   InvalidInput without a reader, saying how to get one, and for options of other files;
///          what the reader throws; Cancelled
ModelInput load_cad(const std::filesystem::path& path, const LoadOptions& options,
                    const RunContext& context);

/// Add the models of the CAD files of a model file.
///
/// Returns  the groups that are whole files
///
/// Throws   as load_cad, with the place in the file; InvalidInput for a file without a name that is
///          not alone
std::set<std::size_t> append_cad_files(const ModelFile& file, const std::string& name,
                                       const LoadOptions& given, const RunContext& context,
                                       ModelInput& result);

}  // namespace surfmesh::detail
