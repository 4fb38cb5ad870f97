// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Find faces that are given more than once: the same vertices in the same cycle, from any of them
/// on.
///
/// Of those in the same direction all but one are copies. Faces in opposite directions make a pair.
/// Pairs that share edges are one set, of which one side is a copy if
/// - an edge of the set has an odd number of three faces or more: they were given on a surface, or
/// - two pairs meet at an edge, and the set ends nowhere at faces that are not pairs: a surface was
///   given again, turned.
/// So two faces back to back by themselves are a closed surface, and a double wall between two
/// bodies stays.
///
/// A hole is never kept in place of a surface. Otherwise the face that is kept agrees as well as
/// any with the direction of its neighbours that are not pairs, and is the first of these. Returns
/// for each face the face that is kept in its place, itself if it is no copy Cost     O(n log n)
/// for n face corners
std::vector<int> find_copies(const Cage& cage);

}  // namespace surfmesh
