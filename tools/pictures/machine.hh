// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surfmesh {

/// The processor and its number of cores, for pages of measured times: "Intel Xeon, 2 cores".
std::string machine_name();

}  // namespace surfmesh
