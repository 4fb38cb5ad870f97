// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "surfmesh/model_file/read_model.hh"
#include "surfmesh/pipeline/load_model.hh"

namespace surfmesh::detail {

/// Add to the input's sources those that the file gives groups, or the whole model. A name that
/// means more than one thing is told by a notice.
///
/// `whole_files`  the groups that are whole cages or CAD files
///
/// Throws   InvalidInput with the place in the file, as where there is no such group
void add_space_sources(const ModelFile& file, const std::string& name,
                       const std::set<std::size_t>& whole_files, ModelInput& input);

}  // namespace surfmesh::detail
