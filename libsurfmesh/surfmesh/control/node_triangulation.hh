// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/control/regular_rows.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/geometry/domain.hh"

namespace surfmesh {

/// The diagonal metric in which the parameter plane is distorted least: mean squared speeds.
Metric plane_metric(const std::vector<ControlNode>& nodes);

/// Control nodes triangulated in the bounding rectangle of their domain.
///
/// The metric of a vertex is the spacing of its node, which shapes the triangles around; for nodes
/// that come alone it is that of the triangle they fall into, and at first plane_metric().
class NodeTriangulation {
 public:
  /// Insert the nodes: first those with a spacing, then those that come alone. One of the latter
  /// that is nearer to another node than a tenth of the size wanted there is merged with it, with
  /// the minimum of both; the corners of the rectangle stay.
  ///
  /// Regular rows at the front of the list (find_regular_rows) are triangulated as a whole.
  ///
  /// Cost     O(n log n), about 1 µs per node; 0.2 µs per node of regular rows
  /// Pre      the corners of the rectangle are among the nodes
  /// Throws   InvalidInput for a node outside the rectangle, naming its (u,v)
  /// Source   paper, section 3.2, steps 1 and 2
  /// Differs: by the metric, which in the paper is the identity; see libsurfmesh/DECISIONS.md,
  ///          control
  NodeTriangulation(const Domain& domain, const std::vector<ControlNode>& nodes);

  /// Add nodes until no triangle is badly shaped: circumcentres, or the middles of edges of the
  /// rectangle that are in their way. Returns their positions.
  ///
  /// Error    circumradius at most √2 times the shortest edge where the spacing is the same all
  ///          over; at most eight new nodes for each given one (test InnerNodes.*)
  /// Cost     O(n log n)
  /// Source   paper, section 3.2, step 3; Ruppert, A Delaunay refinement algorithm for quality
  ///          2-dimensional mesh generation (1995)
  std::vector<Uv> add_inner_nodes();

  const Domain& domain() const { return domain_; }

  /// The triangles without surplus elements.
  const PolyMesh& mesh() const { return delaunay_.mesh(); }
  DelaunayMesh::UvHandle uv_handle() const { return delaunay_.uv_handle(); }
  DelaunayMesh::MetricHandle metric_handle() const { return delaunay_.metric_handle(); }

  /// Node i is vertex i; inner nodes have none.
  const std::vector<ControlNode>& nodes() const { return nodes_; }

  /// Hand out the nodes, and the mesh with its properties; nothing else may be called after that.
  std::vector<ControlNode> release_nodes() { return std::move(nodes_); }
  std::unique_ptr<PolyMesh> release() { return delaunay_.release(); }

 private:
  NodeTriangulation(const Domain& domain, const std::vector<ControlNode>& nodes,
                    const RegularRows& rows);

  void insert_all(std::span<const ControlNode> nodes);
  void insert(const ControlNode& node);
  FaceHandle face_at(VertexHandle vh) const;
  Metric around(FaceHandle fh) const;
  bool merge_with_neighbour(const ControlNode& node, FaceHandle fh);
  bool merge_with(const ControlNode& node, VertexHandle vh);
  bool is_tiny(const std::array<Uv, 3>& triangle) const;
  VertexHandle improve(FaceHandle fh);
  VertexHandle insert_alone(Uv uv, FaceHandle fh);

  Domain domain_;
  DelaunayMesh delaunay_;
  TriangleMetricRule rule_;
  std::vector<ControlNode> nodes_;
  FaceHandle hint_ = FaceHandle(0);
};

}  // namespace surfmesh
