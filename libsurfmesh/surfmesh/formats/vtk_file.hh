// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// The legacy format of VTK, version 3.0, which nearly all programs that read VTK files know:
/// binary, with all that vtk_grid.hh has.
MeshFormat vtk_format();

}  // namespace surfmesh
