// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.hh"

/// How numbers stand in the tables of the comparison.
namespace surfmesh::compare {

inline constexpr const char* kNone = "–";

/// "43,123".
std::string with_commas(std::size_t number);

/// The median; `kNone` without any.
std::string seconds_text(const std::vector<double>& seconds);

/// "0.30 [0.29, 0.33]".
std::string spread_text(const std::optional<Spread>& spread);

}  // namespace surfmesh::compare
