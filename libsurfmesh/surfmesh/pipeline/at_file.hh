// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/core/at_location.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh::detail {

/// Call `body`, and put the location in a file in front of its errors. What is wrong with an option
/// is so in the file.
template <class Body>
void at_file(const std::string& location, Body body) {
  try {
    at_location(location, body);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidOption) throw;
    throw Error(ErrorCode::InvalidInput, error.what());
  }
}

}  // namespace surfmesh::detail
