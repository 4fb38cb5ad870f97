// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/cage/chart_surface.hh"
#include "surfmesh/cage/face_neighbours.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Greatest angle between the normals of a region and that of its plane, degrees. Elements are
/// stretched in the plane by up to 1/cos of it, 2.1, which the metric makes up for.
inline constexpr double kMostTurnOfRegion = 62;

/// The same for small regions that become parts of others, and for the margin around a region.
inline constexpr double kMostTurnOfMargin = 69;

/// Connected faces over which the surface is a graph over a plane, or a single face.
struct FaceRegion {
  std::vector<int> faces;  ///< ascending
  bool is_chart = false;   ///< false for a face by itself, whose surface is as it is
  ChartFrame frame = {};   ///< of a chart
  /// Of a chart: the faces around, of other regions, that lie over the plane as well.
  std::vector<int> margin = {};
};

/// Divide the faces of a cage into regions, round and of about the same number of faces.
///
/// Regions end where faces are not neighbours. Within one, normals stay within 62° of that of its
/// plane (within 69° in the few faces that would be regions of their own otherwise), the faces do
/// not cover each other, and no two of them meet in an edge where they are not neighbours. Faces
/// that turn farther themselves, or have no normals, are single.
///
/// The result does not depend on the number of threads. Regions are in the order of their first
/// faces.
/// Cost     7 evaluations a face, and O(n log n) for n faces ten times or so, 40 at most: 4 µs a
///          face (regions_bench)
/// Source   Cohen-Steiner, Alliez, Desbrun, Variational shape approximation (2004), for the way of
///          moving seeds; the cost is of distances, with a share for turned normals
std::vector<FaceRegion> gather_regions(const FaceNeighbours& neighbours,
                                       const std::vector<std::shared_ptr<const Surface>>& surfaces);

}  // namespace surfmesh
