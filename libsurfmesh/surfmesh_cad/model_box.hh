// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Set the box of a model whose patches are trimmed: of samples inside their loops, and of their
/// contours. Its diagonal is set by finish().
///
/// Error    the square of the distance of samples: an eighth of a cell, a 32nd of a contour's part
void set_box(Model& model);

}  // namespace surfmesh
