// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Give the corners of a result the texture coordinates that the cages of its model have there.
///
/// A face of the result all of whose corners have none keeps them unset, and so does one that lies
/// across the border of the part that has a texture. Seams stay where contours run along them, see
/// ResultPlaces; across others the faces on both sides are taken as they are, and the texture is
/// smeared in the face between them.
///
/// Reads    as ResultPlaces
/// Writes   surf:texture (halfedge), unless no cage has texture coordinates
/// Returns  how many faces have a texture
/// Cost     0.4 µs a corner
/// Throws   as ResultPlaces
std::size_t carry_texture(const Model& model, PolyMesh& result);

}  // namespace surfmesh
