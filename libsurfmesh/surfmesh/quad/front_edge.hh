// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/quad/front_mesh.hh"
#include "surfmesh/quad/root_frame.hh"

namespace surfmesh {

/// One end of a front edge.
struct FrontEnd {
  VertexHandle vertex;
  VertexHandle beyond;  ///< the other end of the front edge there
  double angle = 0;     ///< between both front edges, over the triangles, in (0, 2π]
  int quads = 1;        ///< that fit best there

  /// True if the front edge there is a good side of a quad.
  bool has_side() const { return quads == 1; }
};

/// A front edge, the base of a quad to be made, with what the metric at its middle says.
struct FrontEdge {
  HalfedgeHandle base;
  RootFrame frame;    ///< of the metric at the middle of the base
  double length = 0;  ///< of the base
  FrontEnd from, to;

  int good_sides() const { return (from.has_side() ? 1 : 0) + (to.has_side() ? 1 : 0); }
};

/// Measure a front edge.
/// Cost     a metric query
FrontEdge measure_front(FrontMesh& mesh, HalfedgeHandle base);

}  // namespace surfmesh
