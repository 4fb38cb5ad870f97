// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Where keys belong, for those that stand elsewhere: "hmin" in "sizing".
using KeyPlaces = std::map<std::string, std::string, std::less<>>;

}  // namespace surfmesh
