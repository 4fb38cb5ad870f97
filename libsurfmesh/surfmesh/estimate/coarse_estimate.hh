// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/estimate/estimate_triangles.hh"
#include "surfmesh/sizes/patch_sources.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// Estimates from a coarse lattice of samples in each patch, before there are any control spaces.
struct CoarseEstimate {
  TriangleEstimate likely;
  /// With the greatest of the sizes at the corners of each cell of the lattice: a small size that
  /// holds in a narrow area counts for nothing.
  TriangleEstimate least;
};

/// Estimate from 8 × 8 to 32 × 32 samples a patch, fewer for models of more patches. Sizes are not
/// graded.
///
/// Cost     1 µs a sample
/// Throws   InvalidInput for a source that is invalid
CoarseEstimate estimate_coarsely(const Model& model, const std::vector<PatchSources>& sources,
                                 const ResolvedSizing& sizing);

/// The number of triangles that no sizes exceed that are hmin or larger, from the area of a coarse
/// lattice.
double most_triangles(const Model& model, double hmin);

}  // namespace surfmesh
