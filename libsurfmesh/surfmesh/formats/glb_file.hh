// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// Binary glTF 2.0: one mesh of triangles in single precision, a primitive with a material for each
/// patch.
///
/// A material has the name of its patch and a colour of its first group, or of the patch; among its
/// `extras` are the index of the patch and its groups. Normals are those of the surface where the
/// mesh has them; others are means of those of the faces around a vertex, weighted by their angles
/// there, up to contours (or where patches meet, in a mesh without contours) and borders. Vertices
/// are there once for each normal. On wish, the parameters (u,v) are texture coordinates, as they
/// are. A rotation of the node makes z point upwards, which in glTF is y.
MeshFormat glb_format();

}  // namespace surfmesh
