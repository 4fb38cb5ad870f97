// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/cage/cage.hh"
#include "surfmesh/formats/read_mesh.hh"

namespace surfmesh {

/// Take the faces of a mesh for a control cage. Its named patches and its groups become groups,
/// those of one name one.
///
/// Cost     O(face corners)
Cage cage_of(MeshArraysFile file);

}  // namespace surfmesh
