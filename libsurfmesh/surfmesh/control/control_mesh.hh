// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/control/node_triangulation.hh"

namespace surfmesh {

/// A control space that is a triangulation of its nodes.
/// Source   paper, sections 3.2 and 4
class ControlMesh : public ControlSpace {
 public:
  /// Triangulate the nodes (NodeTriangulation), grade their sizes, and decide for each triangle how
  /// it interpolates.
  ///
  /// Writes   surf:uv, surf:size, surf:class, surf:inner_size, surf:radius, surf:outer_radius and
  ///          point() of the control mesh
  /// Cost     O(n log n), about 1.5 µs per node, 4 µs with classification; of regular rows 0.9 and
  ///          2 µs
  /// Pre      the corners of the bounding rectangle of the domain are among the nodes
  /// Throws   InvalidInput for a node outside the rectangle, naming its (u,v); InvalidOption
  ControlMesh(const Domain& domain, const std::vector<ControlNode>& nodes,
              const ControlSpaceOptions& options);

  /// The same from nodes that have been triangulated; takes the mesh.
  ///
  /// Pre      `nodes` are those that the triangulation was made from
  ControlMesh(NodeTriangulation&& triangulation, const std::vector<ControlNode>& nodes,
              const ControlSpaceOptions& options);

  const PolyMesh& mesh() const override { return *mesh_; }
  FirstFormFactor form(int node) const override { return forms_[static_cast<std::size_t>(node)]; }

 protected:
  void locate(Uv uv, QueryHint& hint) const override;

  /// Weights are barycentric, or 1/d² with distances through M_p at the point asked for (paper,
  /// eq. (4), (5)).
  ///
  /// Cost     with 80,000 triangles V_t about 50 ns near the last query, 140 ns elsewhere, V_o 140
  ///          and 390 ns (tests/bench/control_bench.cc)
  SizeTensor interpolate(const SurfacePoint& at, QueryHint& hint) const override;

  std::optional<SizeTensor> extended_size_by_vertices(const SurfacePoint& at,
                                                      const QueryHint& hint) const override;

 private:
  /// What a query reads of a node.
  struct Node {
    Uv uv;
    SizeTensor value;  ///< what is averaged: H or log H
  };

  struct Triangle {
    std::array<int, 3> nodes;       ///< counter-clockwise
    std::array<int, 3> neighbours;  ///< behind the side from node i to i + 1; -1 if it is open
    Interpolation interpolation = Interpolation::Linear;
  };

  /// A regular grid of triangles to start from. A quadtree was tried: with 80,000 triangles its
  /// descent alone costs as much as a whole query, and it gains nothing even where nodes are
  /// locally a thousand times denser.
  struct SeedGrid {
    Uv lower;
    double cells_per_u = 0;
    double cells_per_v = 0;
    int side = 0;                ///< number of cells along u, and along v
    std::vector<int> triangles;  ///< the one at the middle of each cell, rows along u

    std::size_t cell(Uv uv) const;
    bool are_near(Uv a, Uv b) const;
  };

  /// Where a walk ends.
  struct Walk {
    int triangle;
    int steps = 0;
  };

  /// A point where two interpolations are compared.
  struct Probe {
    Uv uv;
    FirstFormFactor form;
  };

  void collect_nodes(const std::vector<ControlNode>& nodes);
  void collect_triangles();
  void collect_circles();
  void write_nodes(const std::vector<ControlNode>& nodes);
  void make_seed_grid(const Domain& domain);
  void classify();
  Interpolation classify(int triangle, const std::array<FirstFormFactor, 3>& forms,
                         QueryHint& hint) const;
  void write_classes();

  const Node& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
  const Triangle& triangle(int i) const { return triangles_[static_cast<std::size_t>(i)]; }

  int exit_towards(Uv uv, int triangle, int entered_from, RandomBits& random) const;
  Walk walk(Uv uv, int start, RandomBits& random) const;
  SizeTensor linear(const Triangle& triangle, Uv uv) const;
  SizeTensor from_vertices(const Triangle& triangle, Uv uv, const FirstFormFactor& form) const;
  SizeTensor from_circles(int triangle, Uv uv, const FirstFormFactor& form, QueryHint& hint) const;
  bool is_in_circle(int triangle, Uv uv) const;
  int node_opposite(int triangle, int neighbour) const;
  void collect_cavity(int triangle, Uv uv, QueryHint& hint) const;
  SizeTensor size_of(const SizeTensor& value) const;

  std::unique_ptr<PolyMesh> mesh_;
  std::vector<FirstFormFactor> forms_;  ///< of each vertex
  std::vector<int> node_of_;            ///< of each vertex
  std::vector<int> face_of_;            ///< of each triangle
  std::vector<Node> nodes_;  ///< along a Hilbert curve, so that those near each other share memory
  std::vector<Triangle> triangles_;    ///< in the order of their nodes
  std::vector<MetricCircle> circles_;  ///< of the triangles, in `metrics_`; empty without V_o
  std::vector<Metric> metrics_;
  std::vector<ControlNode> extended_;  ///< nodes of extended forms, for the look-up by vertices
  std::vector<int> extended_of_;       ///< of each node its index in `extended_`, or -1
  SeedGrid seeds_;
};

}  // namespace surfmesh
