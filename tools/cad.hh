// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/model/cad_input.hh"

namespace surfmesh {

/// What reads STEP, IGES and BREP files; none if the programs were built without OpenCASCADE.
///
/// To load the libraries of OpenCASCADE takes longer than many a mesh. So they are linked to a
/// program of their own, surfmesh-cad, with the same commands. Where surfmesh meets a CAD file,
/// that program takes over, with the arguments of the command line.
CadReader cad_reader();

/// "OpenCASCADE 7.6.3" for --version; empty if the programs were built without it.
std::string cad_library();

}  // namespace surfmesh
