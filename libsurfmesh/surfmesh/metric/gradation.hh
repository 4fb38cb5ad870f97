// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Limit the sizes at node j so that they grow from node i by at most ln(grade) per unit of length:
/// M_j >= M_i / (1 + ln g · l)², as the minimum of H_j and (1 + ln g · l) H_i.
///
/// Returns H_j itself, bit by bit, if it is within the limit. After one call it is, so sweeps over
/// the edges of a control mesh end when no tensor changes. Both tensors are in the same tangent
/// frame.
///
/// Units    length_m is the metric length √(eᵀM_i e) of the edge in the metric of node i
/// Pre      grade is 0 (off) or at least 1 (1: no growth at all)
SizeTensor graded(const SizeTensor& at_j, const SizeTensor& at_i, double length_m, double grade);

}  // namespace surfmesh
