// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// Shells for Nastran and the preprocessors that read its files: CTRIA3 and CQUAD4 elements,
/// numbered patch by patch. The property of an element is its patch + 1, that of elements of no
/// patch one more than all; property and material cards are left to the analysis.
///
/// Groups are sets of elements and named contours sets of nodes, as SET cards. Names are in
/// comments as HyperMesh writes and reads them: `$HMNAME COMP` for properties, `$HMSET` for sets.
/// Coordinates have 16 characters: 13 to 15 digits.
MeshFormat bdf_format();

}  // namespace surfmesh
