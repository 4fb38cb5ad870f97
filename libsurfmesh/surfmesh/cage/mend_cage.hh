// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/core/length.hh"
#include "surfmesh/core/notice.hh"

namespace surfmesh {

namespace ranges {

/// Alone it welds what differs by the rounding of coordinates with seven digits.
inline constexpr LengthRange kWeld = {"weld", true, 1e-6};

}  // namespace ranges

/// What to mend in a cage.
struct MendOptions {
  double weld = 0;      ///< vertices become one within this distance, in model units; 0 is off
  bool orient = false;  ///< turn faces to agree with their neighbours
};

/// A cage as it was mended.
struct MendedCage {
  Cage cage;
  std::vector<int> parent_faces;  ///< for each of its faces, the face of the original cage
  /// For each face of the original cage, the one that stands for it: itself, or that of which it is
  /// a copy; -1 if it is left out.
  std::vector<int> stand_ins;
  std::vector<char> is_turned;  ///< for each of its faces, 1 if it was turned
  Notices notices;
};

/// Tell where a cage is not what it seems, and mend what the options ask for.
///
/// A face that is given again is always left out; the first one is then in the groups of both.
/// The following are reported, and mended only on request: open edges that lie on others but have
/// vertices of their own, faces of closed surfaces that do so, faces that are turned against their
/// neighbours, and faces with sides without length. Of each kind there is one notice, with the
/// number and the first place. A tolerance is advised only if it makes points of no sides that have
/// a length. Points keep their numbers; a welded vertex is where the first one was.
///
/// Throws   InvalidInput as check_ranges; InvalidOption for a tolerance that is negative or not
///          finite, or that leaves no face of the cage
/// Cost     O(n log n) for n face corners, about 1 µs a face
MendedCage mend_cage(const Cage& cage, const MendOptions& options = {});

}  // namespace surfmesh
