// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <new>
#include <string>

#include "surfmesh/core/error.hh"

namespace surfmesh {

/// Run `body`. Where memory runs out in it, `reached()` says how far it came.
///
/// Returns  what `body` returns
/// Throws   Limit, "out of memory " and the text of `reached`, in place of std::bad_alloc
template <class Body, class Reached>
auto tell_out_of_memory(Body body, Reached reached) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    // What the body had taken is free again, which is enough for a text.
    throw Error(ErrorCode::Limit, "out of memory " + std::string(reached()));
  }
}

}  // namespace surfmesh
