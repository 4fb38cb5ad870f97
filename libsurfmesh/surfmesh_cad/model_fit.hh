// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Put vertices at the mean of the ends of their contours where that is nearer to all of them.
void centre_vertices(Model& model);

/// Set the tolerances of contours and vertices to the gaps that are there, with some slack, or to 0
/// where those do not count. The file's own tolerances are not believed: edges that it says fit to
/// 1e-7 are off by 1e-4 of the part. A gap that elements may see is told.
///
/// Pre      the model is finished
void set_tolerances(Model& model);

}  // namespace surfmesh
