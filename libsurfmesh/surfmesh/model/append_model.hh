// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Add all patches, contours, vertices and groups of another model after those of a model.
///
/// `prefix` is put before the names of the added patches and contours, and before their warnings.
/// The two parts are not joined. A warning is given where open contours of both run along each
/// other within 1e-4 of the diagonal.
///
/// Cost     O(n m) box comparisons for n and m open contours
void append(Model& model, Model added, const std::string& prefix = "");

}  // namespace surfmesh
