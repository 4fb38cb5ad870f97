// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/io/clean_text.hh"

namespace surfmesh::python {

/// Names as Python can have them: in files they may hold any bytes.
inline std::vector<std::string> clean_names(std::vector<std::string> names) {
  for (std::string& name : names) name = clean_text(name);
  return names;
}

}  // namespace surfmesh::python
