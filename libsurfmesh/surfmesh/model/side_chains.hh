// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// A contour use as a part of a side or of a loop.
struct ChainLink {
  LoopEntry entry;
  bool is_along = true;  ///< the contour runs in the direction of the chain
};

/// Contour uses end to end.
using Chain = std::vector<ChainLink>;

/// The contour uses of sides in the direction of the growing parameter, by the name of the side.
using SideChains = std::map<std::string, Chain>;

}  // namespace surfmesh
