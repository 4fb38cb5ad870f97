// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/boundary/patch_boundary.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// What determines the tiles of one patch.
struct TileTask {
  const Surface& surface;
  const MetricField& field;
  double triangles = 0;  ///< that the patch will have
  double most = 0;       ///< triangles of a tile, about; 0 leaves the patch whole
  int multiple = 1;      ///< of the number of nodes on the boundary of each: 2 for quads
  double sag = 0;        ///< greatest distance of a cut from the surface, model units; 0 is off
};

/// A part of a patch that is meshed by itself.
struct Tile {
  PatchBoundary boundary;
  double triangles = 0;  ///< that it will have, about
  /// Those of MetricField::required_points that may lie in it; none where the patch stays whole.
  std::vector<MetricCorner> required_points;
};

/// The tiles of a patch.
struct Tiles {
  std::vector<Tile> tiles;  ///< one at least
  int shared_nodes = 0;     ///< nodes with numbers of their own, see cut_into_tiles
  std::size_t refused = 0;  ///< tiles that stay larger than asked, for no line cuts them well
  QueryCounts queries;      ///< of the metric field
};

/// Cut the boundary of a patch into those of tiles, each of about a number of triangles.
///
/// A tile is halved along a straight line in the parameters, across the direction in which it is
/// longer in the metric, where the metric area on both sides is about equal. Cuts end in nodes that
/// are there, so neighbouring patches see nothing of them. See detail::divide_at for what cuts must
/// hold; lines up to 15 % of the extent away, and those in the other direction, are tried before a
/// tile stays larger. The tiles depend on the sizes alone, not on threads.
///
/// Nodes on rings around poles and on cuts, which tiles share, get vertex numbers from
/// `first_vertex` on. Fans of poles are divided among the tiles at their rings. A patch that stays
/// whole keeps its boundary as it is.
///
/// Cost     64 × 64 metric queries a cut, eight per unit of its length, and O(nodes) per line tried
Tiles cut_into_tiles(PatchBoundary boundary, const TileTask& task, int first_vertex);

/// Add to the numbers of all nodes that tiles share, those from `first_vertex` on.
void shift_shared_nodes(PatchBoundary& boundary, int first_vertex, int by);

}  // namespace surfmesh
