// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// The format of medit, Mmg and others: .mesh as text, .meshb binary, in double precision.
///
/// The reference of an element is its patch + 1, of an edge on a contour its contour + 1, and 0 is
/// none. Corners are the points at which contours end, branch or meet; ridges are the edges on
/// contours at which two faces meet at more than 30°. The text file has the names in comments:
/// `# patch 3 NAME`, `# group 1 2 5: NAME` and `# contour 2 NAME`, with references as numbers.
///
/// Beside it, the metric at the vertices (vertex_metric.hh) is written as .sol or .solb, where the
/// mesh has one.
MeshFormat medit_format();
MeshFormat meditb_format();

}  // namespace surfmesh
