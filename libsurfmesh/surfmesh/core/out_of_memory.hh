// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <new>
#include <string>

#include "surfmesh/core/error.hh"

namespace surfmesh {

/// For the handler of std::bad_alloc of a call, in which what the call had taken is free again:
/// enough for a text.
///
/// Throws   Limit, "out of memory " and how far the call came
[[noreturn]] inline void fail_without_memory(const std::string& reached) {
  throw Error(ErrorCode::Limit, "out of memory " + reached);
}

/// Run `body`. Where memory runs out in it, `reached()` says how far it came.
///
/// Returns  what `body` returns
/// Throws   Limit, "out of memory " and the text of `reached`, in place of std::bad_alloc
template <class Body, class Reached>
auto tell_out_of_memory(Body body, Reached reached) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    fail_without_memory(std::string(reached()));
  }
}

}  // namespace surfmesh
