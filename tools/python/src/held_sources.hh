// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "surfmesh/sizes/sizing.hh"

namespace surfmesh::python {

/// Sizes that are asked for beside those of the model's file. Those that runs share are read and
/// changed with the GIL only.
struct HeldSources {
  Sources sources;
  std::set<int> along;  ///< contours along which sizes are asked for: they stay in the mesh
  /// Greatest relative errors of functions that became tables, and entries.
  std::vector<std::pair<double, std::size_t>> tabulations;
};

/// Add sizes after those of `all`.
void append(const Sources& more, Sources& all);

}  // namespace surfmesh::python
