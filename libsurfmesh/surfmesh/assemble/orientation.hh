// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Which patches must be turned over so that neighbours are oriented alike.
struct PatchOrientation {
  std::vector<char> is_turned;  ///< by patch
  /// Contours along which two patches cannot be oriented alike (a Möbius band is cut there).
  std::vector<int> cut_contours;
};

/// Spread the orientation of the first patch of each component to its neighbours over the contours
/// along which they are joined (joined_uses). If patches of the component are marked as reversed,
/// it is turned over where most of the marks want it.
///
/// Cost     O(contour uses)
PatchOrientation orient_patches(const Model& model);

}  // namespace surfmesh
