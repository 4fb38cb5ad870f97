// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>

#include "surfmesh/sizes/sizing.hh"

namespace surfmesh::python {

/// Sizes that are asked for beside those of the model's file.
struct HeldSources {
  Sources sources;
  std::set<int> along;  ///< contours along which sizes are asked for: they stay in the mesh
};

}  // namespace surfmesh::python
