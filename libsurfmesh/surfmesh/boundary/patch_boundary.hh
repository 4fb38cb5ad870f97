// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "surfmesh/boundary/contour_nodes.hh"

namespace surfmesh {

/// Numbers of the result's vertices that several meshes share: first the vertices of the model,
/// then the inner nodes of each contour, then the nodes between the tiles of a patch.
class NodeNumbers {
 public:
  NodeNumbers(const Model& model, const std::vector<ContourNodes>& nodes);

  /// Vertex of the result for a node of a contour.
  int operator()(int contour, int node) const;

  /// Take numbers for nodes that the tiles of one patch share.
  /// Returns  the first of them
  int add(int nodes) {
    count_ += nodes;
    return count_ - nodes;
  }

  /// Total number of vertices and nodes.
  int count() const { return count_; }

  /// Number of those on contours: nodes between tiles have numbers from here on.
  int contour_count() const { return contour_count_; }

 private:
  struct Range {
    int start, end;  ///< model vertices
    int first_inner;
    int segments;
  };

  std::vector<Range> ranges_;
  int count_ = 0;
  int contour_count_ = 0;
};

/// A node of the boundary of a patch's domain.
struct BoundaryNode {
  Uv uv;
  int vertex = -1;   ///< of the result; -1 for a node of a ring around a pole, the patch's own
  int contour = -1;  ///< of the segment from here to the next node; -1 on such a ring
};

/// Nodes in order: counter-clockwise along the outer loop, clockwise around holes.
using BoundaryLoop = std::vector<BoundaryNode>;

/// The faces between a pole and the ring of nodes around it, which the domain mesh leaves out: a
/// triangle for each segment of the ring, or a quad for two of them.
struct PoleFan {
  int pole = -1;          ///< vertex of the result
  std::vector<Uv> sides;  ///< ends of the sides at the pole, in the direction of the loop
  /// Contours of the segments from the first node of the ring to the pole, and from the pole to the
  /// last one; -1 on the border of a tile.
  int contour_to = -1;
  int contour_from = -1;
  std::vector<int> ring;      ///< indices into the patch's list of boundary nodes
  int segments_per_face = 1;  ///< of the ring; their number is a multiple of it
  /// The part of the sides that is the fan's: all of them, but in a tile.
  double first_share = 0, last_share = 1;
};

/// The boundary that the mesh of one patch must have.
struct PatchBoundary {
  int patch = 0;  ///< index in Model::patches
  std::vector<BoundaryLoop> loops;
  std::vector<PoleFan> fans;
};

/// The point on the sides of a pole at a share of the fan's part of them, from 0 to 1.
Uv point_on_pole(const PoleFan& fan, double share);

/// Collect the boundary of one patch from the nodes of its contours.
///
/// A side that is one point (a pole), or several such sides in a row, is cut off: a ring of nodes
/// at equal metric distances joins the nodes next to it on both adjacent sides. The metric, which
/// is singular at a pole, is therefore never queried there. `segments_per_face` is that of the
/// fans: 1 for triangles, 2 for quads.
PatchBoundary collect_boundary(const Model& model, int patch,
                               const std::vector<ContourNodes>& nodes, const NodeNumbers& numbers,
                               const MetricField& field, int segments_per_face = 1);

}  // namespace surfmesh
