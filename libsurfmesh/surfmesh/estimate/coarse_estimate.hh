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
  /// With the greatest of the sizes in each cell of the lattice: a small size that holds in a
  /// narrow area counts for nothing.
  TriangleEstimate least;
};

/// How closely sizes are looked at: the first look takes a sixteenth of the samples.
enum class CoarseLook { First, Close };

/// Estimate from 8 × 8 to 32 × 32 cells a patch, fewer for models of more patches; from 2 × 2 to
/// 8 × 8 with the first look. Sizes are not graded.
///
/// Cost     3 samples of the field a cell
/// Throws   InvalidInput for a source that is invalid, naming the patch
CoarseEstimate estimate_coarsely(const Model& model, const std::vector<PatchSources>& sources,
                                 const ResolvedSizing& sizing, CoarseLook look = CoarseLook::Close);

/// An upper bound on the number of triangles if all sizes are at least hmin, apart from tubes that
/// are thinner. From the area of a coarse lattice.
/// Throws   Geometry, naming the patch
double most_triangles(const Model& model, double hmin);

}  // namespace surfmesh
