// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/observer.hh"
#include "surfmesh/model/cad_input.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pipeline/options.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// The contents of a file, as arguments of mesh_model.
struct ModelInput {
  Model model;  ///< its notices include those from reading
  Sources sources;
  PipelineOptions options;  ///< defaults, overridden by the sizing and options of a model file
  std::vector<std::filesystem::path> files;  ///< all that were read: with cages and tables
};

/// What decides how files become a model.
struct LoadOptions {
  CageOptions cages = {};
  std::optional<Length> joining = {};  ///< see JoinOptions; unset: that of the file
  CadOptions cad = {};
  CadReader read_cad = {};  ///< reads STEP, IGES and BREP files; none refuses them
};

/// Read a control cage (.obj, .off, ...), a CAD file (.step, .iges, .brep) or a model file (.json),
/// chosen by the ending in upper or lower case.
///
/// The model of a model file has the formula patches first, then those of its cages, named
/// `<cage>:<patch>`; each cage is also a group. Contours are shared within a cage and among formula
/// patches, but not between them. A scheme or kind of patches other than Auto replaces that of all
/// cages. In the file, the kind given with a cage overrides the option. A `joining` replaces that
/// of the file.
///
/// Throws   Io if a file cannot be read; InvalidInput for an unknown ending, an error in a file
///          (naming it and the location), a scheme for a model file without cages or a joining
///          for one without formula patches; Geometry;
///          Limit if memory runs out; Cancelled by the observer, which may be null and is asked
///          between the steps of each cage
ModelInput load_model(const std::filesystem::path& path, const LoadOptions& options = {},
                      Observer* observer = nullptr);

}  // namespace surfmesh
