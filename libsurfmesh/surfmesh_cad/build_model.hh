// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/model/model.hh"
#include "surfmesh_cad/cad_shape.hh"

namespace surfmesh {

/// A model of a shape, and the faces that it lacks.
struct BuiltModel {
  Model model;
  Notices left_out;  ///< one for each face that cannot be used, with the reason
};

/// Faces become patches, edges contours. Names and groups come from the facts of the faces.
///
/// Cost     a few hundred evaluations for each use of an edge, and 81 for each cell of a surface
BuiltModel build_model(const CadShape& cad);

}  // namespace surfmesh
