// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/cage/face_neighbours.hh"
#include "surfmesh/cage/gather_regions.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// A model of regions, and which these are.
struct RegionModel {
  Model model;
  std::vector<FaceRegion> regions;  ///< by patch
};

/// Make a model whose patches are the regions: vertices, contours, and patches with surfaces and
/// loops, in the order of the regions. Patches have no names yet, and no cage_faces.
///
/// A contour between charts that is where it is only because the regions are is a smooth curve near
/// the edges of the cage; others run along these. Charts whose contours cross each other even so,
/// or that miss their own faces, are taken to single faces.
/// Cost     a few evaluations of a chart for each edge between regions; all of it again where
///          charts are taken apart
/// Error    uses of a contour agree to 1e-8 of the diagonal (test RegionModel.UsesOfAContourAgree)
RegionModel model_of_regions(const FaceNeighbours& neighbours,
                             const std::vector<std::shared_ptr<const Surface>>& surfaces,
                             std::vector<FaceRegion> regions);

}  // namespace surfmesh
