// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Give ends of curves that are one corner of a patch the same (u,v), to the last bit.
///
/// One corner are the ends that follow each other in a loop, and all ends at one vertex of the
/// model whose (u,v) differ by rounding only. They get their mean, but stay on a side of the
/// domain; the difference is spread linearly over each curve. Ends that are farther apart in space
/// than the tolerances allow stay as they are, for check() to refuse.
///
/// Cost     O(n²) for n ends at one vertex in one patch, two evaluations of each curve
/// Pre      the diagonal of the model is set
void pin_ends(Model& model);

}  // namespace surfmesh
