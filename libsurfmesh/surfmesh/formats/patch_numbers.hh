// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Numbers of patches up to this one are read and written: memory grows with them, also where few
/// are used.
inline constexpr int kMostPatches = 10'000'000;

}  // namespace surfmesh
