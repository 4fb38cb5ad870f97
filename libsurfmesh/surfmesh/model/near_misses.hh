// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/matched_sides.hh"

namespace surfmesh {

/// Sides that were perhaps meant to be joined.
struct NearMiss {
  int a = -1;  ///< a curve of MatchedSides
  int b = -1;  ///< the one that runs along it; -1 if `a` only lies between ends of sides
  /// The greatest distance of the two, in model units; within JoinLengths::join if only their ends
  /// are not one. Without `b`, the length of `a`.
  double gap = 0;
};

/// Find curves that run along each other and yet are not one, and ends of sides that are nearly
/// one.
///
/// A quarter of a curve has to be within JoinLengths::near of the other. The stretch has to be some
/// times longer than the gap, so that small curves are not taken for near misses of their
/// neighbours. Pairs that are both shared have found their partners and are left out, as are the
/// two sides of a narrow patch.
///
/// Ends of sides on one side are nearly one if the piece between them is shorter than
/// JoinLengths::near and than 1 % of each side that it is a part of: sides that are short as a
/// whole, and those that they divide, are meant to be. Left out where they are ends of a pair that
/// is found anyway.
///
/// Returns  the pairs, then the ends
/// Cost     O(n log n) for n curves that are short against the model
std::vector<NearMiss> find_near_misses(const MatchedSides& matched, const JoinLengths& lengths);

}  // namespace surfmesh
