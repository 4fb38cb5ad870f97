// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "surfmesh/control/sizing.hh"
#include "surfmesh/geometry/cage_model.hh"
#include "surfmesh/geometry/model.hh"
#include "surfmesh/pipeline/options.hh"

namespace surfmesh {

/// What a file asks for: the arguments of mesh_model.
struct ModelInput {
  Model model;  ///< its warnings are those of reading, too
  Sources sources;
  PipelineOptions options;  ///< defaults, with the sizing and the options of a model file
};

/// Read a control cage (.obj, .off) or a model file (.json), chosen by the ending in upper or lower
/// case.
///
/// Throws   Io if the file cannot be read; InvalidInput for an unknown ending, a fault in the file
///          (naming it and the place) or a scheme other than Auto for a model file; Geometry
ModelInput load_model(const std::filesystem::path& path, const CageOptions& cage_options = {});

}  // namespace surfmesh
