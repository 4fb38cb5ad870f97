// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// Gmsh's format, version 4.1 or 2.2, binary or text, as OutputOptions::msh asks for.
///
/// Patch p is the surface of tag p + 1, faces of no patch are one more, contour c with its segments
/// as line elements is the curve of tag c + 1. Each surface and curve is a physical group of
/// the same tag, with the name of the patch or contour if it has one, because solvers take nothing
/// but physical groups. Groups of patches are physical groups with tags above those. Nodes and
/// elements are numbered in the order of the file, entity by entity. Version 2.2 has one physical
/// group an element: the first group of its patch, or else the patch. Where the mesh has a metric,
/// there is a view "size" of the sizes at the nodes.
MeshFormat msh_format();

}  // namespace surfmesh
