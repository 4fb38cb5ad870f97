// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "surfmesh/pipeline/load_model.hh"

/// The step of load_model that reads CAD files.
namespace surfmesh::detail {

/// Read a CAD file with the reader of the options.
///
/// Throws   InvalidInput without a reader, saying how to get one; what the reader throws
Model read_cad_file(const std::filesystem::path& path, const LoadOptions& options,
                    const CadOptions& cad);

/// The model with one more group of all its patches, if it gets a name.
void add_whole_group(const std::string& name, Model& model);

}  // namespace surfmesh::detail
