// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh::detail {

/// A side of a patch's domain that is one point in space, and the nodes next to it, in the
/// direction of the loop. The ring that cuts the pole off runs straight from the first to the last
/// of them.
struct PoleSide {
  Uv before;
  Uv from;
  Uv to;
  Uv after;
};

/// True if a segment comes within one and a half times the distance of the ring from the pole:
/// there would be no room for elements between them, or the ring would cross it.
///
/// Exact, but for the rounding of the one and a half times.
bool is_in_the_way(const PoleSide& pole, Uv a, Uv b);

}  // namespace surfmesh::detail
