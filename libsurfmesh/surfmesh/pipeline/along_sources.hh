// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/model_file/read_model.hh"
#include "surfmesh/pipeline/load_model.hh"

namespace surfmesh::detail {

/// Add to the input's sources the sizes that the file gives along contours and sides. These stay in
/// the mesh.
///
/// Throws   InvalidInput with the place in the file, as where there is no such contour
void add_along_sources(const ModelFile& file, const std::string& name, ModelInput& input);

}  // namespace surfmesh::detail
