// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/run_context.hh"
#include "surfmesh/estimate/estimate_triangles.hh"

namespace surfmesh {

/// How many elements of the kind that the run makes there will be.
double estimated_elements(const TriangleEstimate& estimate, const RunContext& context);

/// True if there will be more elements than the run may make, even if the estimate is 15 % too
/// high.
bool is_surely_above(const TriangleEstimate& estimate, const RunContext& context);

/// Tell the estimate, and an hmin (or hmax, where that is below it) that fits.
/// Throws   Limit
[[noreturn]] void throw_too_many(const TriangleEstimate& estimate, double hmax,
                                 const RunContext& context);

}  // namespace surfmesh
