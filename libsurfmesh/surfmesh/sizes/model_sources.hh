// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/patch_sources.hh"

namespace surfmesh {

/// What has a say in the sizes of each patch of a model, by the index of the patch: the user's
/// sources, and by the sizing the curvature of contours, short contours and gaps.
///
/// These three come from contours that are not smooth (true boundaries, creases, trims), and go to
/// all patches that share the contour.
/// Cost     about 0.1 ms a contour that is not smooth, and proximity_sizes
/// Throws   InvalidInput for a size or radius of `near` that is none
std::vector<PatchSources> model_sources(const Model& model, const Sources& sources,
                                        const ResolvedSizing& sizing);

/// Tell how many sizes of the user lie beyond hmin and hmax; none if there are
/// none. Sizes of fields are not known.
///
/// Cost     an evaluation of the surface for each row of a table
/// Throws   InvalidInput for a size or metric that is none
std::optional<Notice> clamp_notice(const Model& model, const Sources& sources,
                                   const SizeBounds& bounds);

}  // namespace surfmesh
