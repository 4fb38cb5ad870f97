// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "surfmesh/geometry/domain.hh"
#include "surfmesh/io/json_node.hh"
#include "surfmesh/model_file/model_values.hh"
#include "surfmesh/model_file/read_model.hh"

/// The `sources` of a model file. All functions throw InvalidInput with the place for what does not
/// fit.
namespace surfmesh {

/// The patch that a source belongs to, and the folder that tables are relative to.
struct PatchScope {
  int index;
  Domain domain;
  const Constants& constants;
  std::filesystem::path folder;
};

/// Read a source of a patch.
void read_patch_source(const JsonNode& node, const PatchScope& patch, ModelFile& model);

/// Read a source of a patch that is divided into pieces with these domains. It applies to all of
/// them; a size at a point to those that have it.
void read_divided_source(const JsonNode& node, const std::vector<PatchScope>& pieces,
                         const Domain& whole, ModelFile& model);

/// Read a source of the model: it applies to all patches, or to those of a group. Files are
/// relative to the folder.
void read_space_source(const JsonNode& node, const Constants& constants,
                       const std::filesystem::path& folder, ModelFile& model);

}  // namespace surfmesh
