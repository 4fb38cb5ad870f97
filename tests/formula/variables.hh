// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace surfmesh {

/// The variables of formulas of surfaces.
inline const std::vector<std::string> kUv = {"u", "v"};

}  // namespace surfmesh
