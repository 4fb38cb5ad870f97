// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// Wavefront OBJ: see read_cage.hh, read_mesh.hh and write_mesh.hh.
MeshFormat obj_format();

}  // namespace surfmesh
