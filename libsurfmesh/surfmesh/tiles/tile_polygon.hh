// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "surfmesh/boundary/patch_boundary.hh"

/// The boundary of a patch as polygons in its parameters, while it is cut into tiles.
namespace surfmesh::detail {

/// A node of the boundary of a patch, or of a cut.
struct TileNode {
  Uv uv;
  int vertex = -1;          ///< of the result; -1 for one of the patch's own
  bool can_end_cut = true;  ///< false within a quad at a pole
};

/// A side from its node to that of the next side.
struct TileSide {
  int node = -1;
  int contour = -1;  ///< -1 on rings around poles and on cuts
  int fan = -1;      ///< the pole whose ring it is on
  int step = 0;      ///< its place in the ring
};

/// Sides in order: counter-clockwise along the outer loop, clockwise around holes.
using TileLoop = std::vector<TileSide>;

/// A part of a patch. The first loop is the outer one.
struct TilePolygon {
  std::vector<TileLoop> loops;

  std::size_t side_count() const;
};

/// A place in the loops of a polygon.
struct SidePlace {
  std::size_t loop = 0, side = 0;

  friend bool operator==(const SidePlace&, const SidePlace&) = default;
};

/// The place of the next side of its loop.
inline SidePlace next(const TilePolygon& polygon, SidePlace place) {
  const std::size_t count = polygon.loops[place.loop].size();
  return {place.loop, place.side + 1 == count ? 0 : place.side + 1};
}

inline SidePlace previous(const TilePolygon& polygon, SidePlace place) {
  const std::size_t count = polygon.loops[place.loop].size();
  return {place.loop, (place.side == 0 ? count : place.side) - 1};
}

inline const TileSide& at(const TilePolygon& polygon, SidePlace place) {
  return polygon.loops[place.loop][place.side];
}

/// Call `visit(place)` for every side of a polygon.
template <class Visit>
void for_each_side(const TilePolygon& polygon, Visit visit) {
  for (std::size_t loop = 0; loop < polygon.loops.size(); ++loop) {
    for (std::size_t side = 0; side < polygon.loops[loop].size(); ++side) {
      visit(SidePlace{loop, side});
    }
  }
}

/// The box of some nodes in the parameters.
struct UvBox {
  Uv lower, upper;

  bool contains(Uv uv) const {
    return uv.u >= lower.u && uv.u <= upper.u && uv.v >= lower.v && uv.v <= upper.v;
  }
};

/// The polygon of a boundary. Its nodes are appended in the order of the boundary's list.
TilePolygon polygon_of(const PatchBoundary& boundary, std::vector<TileNode>& nodes);

UvBox box_of(const TilePolygon& polygon, const std::vector<TileNode>& nodes);

/// Where the sides of a polygon cross the line on which coordinate 0 (u) or 1 (v) has a value:
/// their other coordinates, ascending, each with its side. The line lies inside between the first
/// and the second, the third and the fourth, and so on.
struct LineCrossing {
  double along;
  SidePlace side;
  double share;  ///< of the side, from its node
};
std::vector<LineCrossing> crossings(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                                    int axis, double value);

/// A straight cut from one node of a polygon to another, through its inside.
struct TileCut {
  SidePlace from, to;           ///< sides that begin at its ends
  std::vector<int> inner = {};  ///< nodes between its ends
};

/// The polygons that cuts divide a polygon into, outer loops first, with the numbers of the two on
/// the left and on the right of each cut.
struct CutPolygons {
  std::vector<TilePolygon> parts;
  std::vector<std::pair<std::size_t, std::size_t>> beside;  ///< by cut
};

/// Divide a polygon along cuts, no two of which have an end in common.
///
/// Cost     O(sides × holes)
CutPolygons divide(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                   const std::vector<TileCut>& cuts);

/// The boundary of a tile, with the fans of poles that its rings belong to, or parts of them.
PatchBoundary boundary_of(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                          const PatchBoundary& of_patch);

}  // namespace surfmesh::detail
