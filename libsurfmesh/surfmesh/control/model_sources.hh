// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/patch_sources.hh"
#include "surfmesh/geometry/model.hh"

namespace surfmesh {

/// What has a say in the sizes of each patch of a model, by the index of the patch: the user's
/// sources.
///
/// Throws   InvalidInput for a size or radius of `near` that is none
std::vector<PatchSources> model_sources(const Model& model, const Sources& sources,
                                        const Sizing& sizing);

}  // namespace surfmesh
