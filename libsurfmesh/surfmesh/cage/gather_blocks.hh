// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// A face in a block, and how it lies there.
struct BlockFace {
  int face = -1;
  int rotation = 0;  ///< the corner of the face that is at the lower left of its place
};

/// A rectangle of faces; a face that is no quad is a block of its own.
struct Block {
  int columns = 1;
  int rows = 1;
  std::vector<BlockFace> faces;  ///< row by row from below, each from the left
};

/// The face with the least index.
int first_face(const Block& block);

/// Gather the faces of a refiner's base level into rectangles as large as can be, largest first.
///
/// Blocks end at creases of any sharpness, at boundaries, at edges of more than two faces, and
/// where neighbours pass their edge in the same direction. The vertices inside a block are regular:
/// four faces, no sharpness; those of more than 8 faces (4 at a boundary) are at corners only, for
/// their narrow faces would make a hairpin of a side. So are those where two faces would fill less
/// than 45° of the cage, or leave less than 45° to others (around a fan of narrow faces). By
/// Chaikin's rule, under which the surfaces of faces beside a crease may differ (see
/// model_from_cage), blocks end at edges from semi-sharp creases, too. Two opposite sides of a
/// block may be the same edges (a ring). The blocks are in the order of their first faces.
///
/// `sets` has a number for each face: faces of different sets come into different blocks, those of
/// the set -1 into none. `points` are those of the cage.
/// Cost     O(f) for f faces where blocks are large, up to O(f √f) where few faces fit together
std::vector<Block> gather_blocks(const OpenSubdiv::Far::TopologyRefiner& refiner,
                                 const std::vector<int>& sets, const std::vector<Vec3>& points);

/// Make each face a block of its own, but for those of the set -1.
std::vector<Block> single_faces(const std::vector<int>& sets);

}  // namespace surfmesh
