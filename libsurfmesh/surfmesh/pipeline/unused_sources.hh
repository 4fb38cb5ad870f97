// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/resolved_sizing.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh::detail {

/// Warn of each source whose place no triangle of its patches comes to: boxes and balls beside the
/// surface, points from which a size has grown to hmax before it is there, and (u,v) outside of the
/// loops of their patch. Warn of background meshes that patches lie beyond, with the share, from
/// 200 triangles of each patch.
///
/// Reads    surf:patch (face), surf:uv (halfedge)
/// Error    places nearer than a tenth of a triangle's box, and segments whose box it meets, count
///          as reached
/// Cost     O(log n) a triangle for n sources; nothing without such sources
Notices unused_sources(const PolyMesh& mesh, const Model& model, const Sources& sources,
                       const ResolvedSizing& sizing);

}  // namespace surfmesh::detail
