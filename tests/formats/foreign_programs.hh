// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

namespace surfmesh {

/// Debian's Python, which has the modules that `tools/setup.sh --readers` installs.
inline constexpr const char* kPython = "/usr/bin/python3";

/// True if a command line ends without an error.
inline bool runs(const std::string& line) {
  return std::system((line + " >/dev/null 2>&1").c_str()) == 0;
}

inline bool has_module(const std::string& name) {
  return runs(std::string(kPython) + " -c 'import " + name + "'");
}

}  // namespace surfmesh
