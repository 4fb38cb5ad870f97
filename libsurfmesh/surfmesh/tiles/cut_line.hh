// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/tiles/tile_polygon.hh"

namespace surfmesh::detail {

/// What the nodes of cuts are to hold.
struct CutRules {
  const Surface& surface;
  const MetricField& field;
  int multiple = 1;  ///< of the number of sides of every tile
  double sag = 0;    ///< greatest distance of a segment from the surface, model units; 0 is off
};

/// Divide a polygon where coordinate 0 (u) or 1 (v) has a value, along straight cuts between nodes
/// that are there. `queries` counts those of the field.
///
/// Nodes on cuts lie at equal metric arcs, three segments at least, so that no edge joins the two
/// ends of one; they are appended to `nodes`. Of quads, each part has an even number of sides.
///
/// Returns  the parts; none where a cut would be shorter than 2.5 units, come nearer than 0.6 units
///          to a node, cross a side, meet one under less than 39°, or end where another cut does,
///          and none if the line leaves the polygon whole
/// Cost     O(sides), and eight metric queries per unit of length
std::vector<TilePolygon> divide_at(const TilePolygon& polygon, std::vector<TileNode>& nodes,
                                   int axis, double value, const CutRules& rules,
                                   QueryCounts& queries);

}  // namespace surfmesh::detail
