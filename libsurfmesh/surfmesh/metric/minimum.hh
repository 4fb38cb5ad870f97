// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Combine two metrics by simultaneous reduction: the shorter wanted length in each of their common
/// directions.
///
/// In no direction does the result ask for a longer length than either of the two. Exactly
/// commutative and idempotent; if one metric asks for no longer length in any direction, it is
/// returned unchanged. Not associative: combine several in the order of their index.
///
/// Error    1e-14 × aspect² of the sum of both (test MetricMinimum.*)
/// Pre      both positive semidefinite; one may be singular
Metric minimum(const Metric& a, const Metric& b);

/// Combine two size tensors of one tangent frame, as for their metrics H⁻².
///
/// Lengths that differ by less than 1e-10 count as equal, so that combining the result with either
/// argument again does not change a bit of it, up to aspect 1e4.
///
/// Error    1e-10, and 1e-14 × aspect, by never forming the squares (test SizeMinimum.*)
/// Pre      both positive definite
SizeTensor minimum(const SizeTensor& a, const SizeTensor& b);

}  // namespace surfmesh
