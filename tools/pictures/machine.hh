// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace surfmesh {

/// What times were taken on.
struct Machine {
  std::string processor;
  unsigned cores = 0;
  double load_before = 0;  ///< processes that wanted to run, mean of the last minute
  double load_after = 0;
  std::string day;  ///< 2026-11-29
};

/// With the load of now for both.
Machine this_machine();

/// Mean load of the last minute; 0 if unknown.
double load_now();

/// The first "model name" in the text of /proc/cpuinfo, or "unknown processor".
std::string processor_name(std::string_view cpuinfo);

}  // namespace surfmesh
