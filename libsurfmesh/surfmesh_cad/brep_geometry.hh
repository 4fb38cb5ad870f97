// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh_cad/brep_words.hh"

namespace surfmesh {

/// Check curves or surfaces in the text of a BREP file: that they are of known kinds, with as many
/// numbers as these have. OpenCASCADE falls over others, or prints that it does not know them.
///
/// `words` stands at the first of them, afterwards behind the last.
/// Throws   InvalidInput
void check_brep_curves(BrepWords& words, int count, int dimension);
void check_brep_surfaces(BrepWords& words, int count);

}  // namespace surfmesh
