// SPDX-License-Identifier: BSD-3-Clause
#include "cad.hh"

#ifdef SURFMESH_HAS_CAD
#include <fmt/format.h>

#include "surfmesh_cad/read_cad.hh"
#endif

namespace surfmesh {

#ifdef SURFMESH_HAS_CAD

CadReader cad_reader() { return read_cad; }

std::string cad_library() { return fmt::format("OpenCASCADE {}", cad_version()); }

#else

CadReader cad_reader() { return {}; }

std::string cad_library() { return {}; }

#endif

}  // namespace surfmesh
