// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/model/cad_input.hh"

namespace surfmesh {

/// What reads STEP, IGES and BREP files; none if the program was built without OpenCASCADE.
CadReader cad_reader();

/// "OpenCASCADE 7.6.3" for --version; empty if the program was built without it.
std::string cad_library();

}  // namespace surfmesh
