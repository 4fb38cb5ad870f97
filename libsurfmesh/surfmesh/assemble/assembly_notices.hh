// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/notice.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh::detail {

/// What the mesh of a model is other than the model, for a half-edge mesh cannot be so. `cut_sides`
/// are sides of faces left open although others have their vertices.
Notices notices_of_assembly(const Model& model, std::size_t cut_sides);

}  // namespace surfmesh::detail
