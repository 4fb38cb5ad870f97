// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pipeline/options.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// What a file asks for: the arguments of mesh_model.
struct ModelInput {
  Model model;  ///< its notices are those of reading, too
  Sources sources;
  PipelineOptions options;  ///< defaults, with the sizing and the options of a model file
};

/// Read a control cage (.obj, .off) or a model file (.json), chosen by the ending in upper or lower
/// case.
///
/// The model of a model file has its formula patches, then those of its cages, named
/// <cage>:<patch>; each cage is a group, too. Contours are shared within a cage and among formula
/// patches, not between these. A scheme or kind of patches other than Auto replaces
/// that of all cages; a kind that a cage names in the file beats the option of the file.
///
/// Throws   Io if a file cannot be read; InvalidInput for an unknown ending, a fault in a file
///          (naming it and the place) or a scheme for a model file without cages; Geometry
ModelInput load_model(const std::filesystem::path& path, const CageOptions& cage_options = {});

}  // namespace surfmesh
