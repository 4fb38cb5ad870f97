// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// The versions of Gmsh's format, each as binary file and as text.
enum class MshVersion { Binary41, Text41, Binary22, Text22 };

/// What a file of a mesh has besides positions, faces and patches, if its format has a place for it
/// and the mesh has it.
struct OutputOptions {
  bool normals = false;  ///< the normals of the corners
  bool uv = false;       ///< the parameters (u,v) of the corners, as they are
  /// Texture coordinates of the corners as the cage has them; where a format has one place for
  /// both, they stand there in place of (u,v).
  bool texture = false;
  MshVersion msh = MshVersion::Binary41;  ///< of .msh files
};

}  // namespace surfmesh
