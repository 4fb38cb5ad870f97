// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/notice.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pipeline/report.hh"

namespace surfmesh::detail {

/// What is wrong with faces of a mesh, by the figures of its report: flat triangles and quads,
/// quads that are inverted or folded, triangles among quads.
Notices notices_of_faces(const PolyMesh& mesh, const Model& model, const Report& report);

}  // namespace surfmesh::detail
