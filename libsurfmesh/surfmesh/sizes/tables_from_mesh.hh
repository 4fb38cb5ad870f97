// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// Adaptation data: the metric at the corners of an earlier mesh as tables, one for each patch that
/// has faces. A vertex has one row for each (u,v) it has in a patch. This includes poles, whose
/// rows are left out when the table is used.
///
/// Reads    surf:patch (face), surf:uv and surf:metric (corner); a simulation writes the metric it
///          wants into the last
/// Units    M in (u,v), which becomes sizes when the table is used
/// Cost     O(corners)
/// Throws   MissingProperty
/// Source   paper, section 3
std::vector<TableSource> tables_from_mesh(const PolyMesh& mesh);

}  // namespace surfmesh
