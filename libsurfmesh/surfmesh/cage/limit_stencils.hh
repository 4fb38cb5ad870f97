// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <Eigen/SparseCore>
#include <vector>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Weights of the points of a cage, a row for each of their combinations.
using Stencils = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The limit positions of the vertices of a refiner's base level from the points of the cage: a row
/// for each vertex.
///
/// Sharp tags, borders and cuts at edges of more than two faces are as OpenSubdiv has them. A
/// vertex without faces is its own point, and so is one at the border with BoundaryRule::None,
/// where no face has a limit surface. A vertex between holes only has the position where the
/// surface would be without its semi-sharp tags.
///
/// Error    exact but for rounding; at ends of creases and inner vertices of two faces as far from
///          the limit as the surfaces of make_limit_surfaces, which are elsewhere as near to these
///          positions as they promise (test LimitStencils.AreThePositionsOfLimitSurfaces)
/// Cost     O(face corners), 0.2 µs a vertex; faces at those and at semi-sharp tags 0.1 ms,
///          which are refined in groups, in some 100 MB, and
///          meshes with faces that are not the scheme's four times as much
Stencils limit_stencils(const OpenSubdiv::Far::TopologyRefiner& refiner);

/// The points of a cage's limit surface at its vertices; see limit_stencils.
///
/// Pre      scheme is not Auto
/// Throws   InvalidInput for a cage that cannot be subdivided
std::vector<Vec3> limit_points(const Cage& cage, Scheme scheme);

}  // namespace surfmesh
