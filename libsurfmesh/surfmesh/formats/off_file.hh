// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// OFF of Geomview: see read_cage.hh, read_mesh.hh and write_mesh.hh.
MeshFormat off_format();

}  // namespace surfmesh
