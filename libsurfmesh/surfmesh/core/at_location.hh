// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/core/error.hh"

namespace surfmesh {

/// Run `body`. Its errors get the location as a prefix: "location: reason".
///
/// Returns  what `body` returns
template <class Body>
auto at_location(const std::string& location, Body body) {
  try {
    return body();
  } catch (const Error& error) {
    throw Error(error.code(), location + ": " + error.what());
  }
}

}  // namespace surfmesh
