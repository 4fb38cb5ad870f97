// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/patch_sources.hh"

namespace surfmesh {

/// The sources of sizes of each patch of a model, by the index of the patch: those of the user and,
/// depending on the sizing, the curvature of contours, short contours and gaps.
///
/// The last three come from contours that are not smooth (true boundaries, creases, trims) and
/// apply to all patches that share the contour.
/// Cost     about 0.1 ms per contour that is not smooth, and proximity_sizes
/// Throws   InvalidInput for an invalid size or radius of a source in space
std::vector<PatchSources> model_sources(const Model& model, const Sources& sources,
                                        const ResolvedSizing& sizing);

/// A notice of how many user-requested sizes lie outside hmin and hmax; nothing if none do. Sizes
/// of fields are not known.
///
/// Cost     a surface evaluation for each row of a table
/// Throws   InvalidInput for an invalid size or metric
std::optional<Notice> clamp_notice(const Model& model, const Sources& sources,
                                   const SizeBounds& bounds);

}  // namespace surfmesh
