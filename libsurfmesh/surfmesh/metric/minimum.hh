// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Combine two metrics by simultaneous reduction: the shorter wanted length in each of their common
/// directions.
///
/// Asks for lengths that are never longer than those of either in any direction. Exactly
/// commutative and idempotent; where one metric is nowhere longer it is returned as it is. Not
/// associative: combine several in the order of their index.
///
/// Error    1e-14 × aspect² of the sum of both (test MetricMinimum.*)
/// Pre      both positive semidefinite; one may be singular
Metric minimum(const Metric& a, const Metric& b);

/// Combine two size tensors of one tangent frame, as for their metrics H⁻².
///
/// Lengths that differ by less than 1e-10 count as equal, so that the result can be combined with
/// either argument again and stays as it is, bit by bit, up to aspect 1e4.
///
/// Error    1e-10, and 1e-14 × aspect, by never forming the squares (test SizeMinimum.*)
/// Pre      both positive definite
SizeTensor minimum(const SizeTensor& a, const SizeTensor& b);

}  // namespace surfmesh
