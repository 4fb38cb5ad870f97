// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/io/json_node.hh"
#include "surfmesh/model_file/model_values.hh"
#include "surfmesh/model_file/read_model.hh"

/// Parts of a model file: cages, contours, loops. All functions throw InvalidInput with the place
/// for what does not fit.
namespace surfmesh {

/// Read `cages`; their files are relative to `folder`.
std::vector<CageInput> read_cages(const JsonNode& node, const std::filesystem::path& folder);

/// Read `cad`; the files are relative to `folder`.
std::vector<CadFileInput> read_cad_files(const JsonNode& node, const std::filesystem::path& folder);

/// Read `contours`.
std::vector<ContourInput> read_contours(const JsonNode& node, const Constants& constants);

/// Read the `loops` of a patch.
std::vector<std::vector<std::string>> read_loops(const JsonNode& node);

/// Check that names of patches and cages, and of contours, are there once, and that loops and
/// contours name nothing else.
void check_names(const JsonNode& root, const ModelFile& model);

}  // namespace surfmesh
