// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/across/region_work.hh"

namespace surfmesh {

/// Find what the faces of a region that has been worked on are in the parameters of patches, by
/// their number. Those that are as they were in the result keep their values.
///
/// Cost     about 0.1 µs a face, 1 µs one that has changed
std::vector<FaceInPatch> faces_in_patches(const RegionInput& input, const RegionWork& work,
                                          const ChartMaker& maker);

/// How good faces are in (u,v), as the mesh goes around their patches.
struct RegionQuality {
  double least = 1;  ///< quality of the triangles
  double mean = 0;   ///< quality of triangles, least scaled Jacobian of quads
  std::size_t inverted = 0;
};

/// The quality of the faces that a region was made of.
RegionQuality quality_before(const RegionInput& input, const RegionWork& work,
                             const ChartMaker& maker);

/// The quality of the faces of a region, as `work.faces` has them.
RegionQuality quality_now(const RegionWork& work, const ChartMaker& maker);

/// The faces of the piece that a region was made of without those around where triangles, as
/// `work.faces` has them, are flat or turned over, or quads concave; all of them if none are.
/// Triangles are flat below a quality of 0.4, or below the least one before.
FacePiece without_spoilt(const RegionInput& input, const RegionWork& work, const ChartMaker& maker);

}  // namespace surfmesh
