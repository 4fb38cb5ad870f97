// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "surfmesh/control/control_nodes.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/delaunay/locate.hh"

namespace surfmesh {

/// The sizes of one patch: a triangulation of its control nodes, asked for the metric anywhere.
///
/// Immutable after construction; queries are const and may come from several threads, each with a
/// hint of its own.
class ControlSpace {
 public:
  /// What a caller keeps from one query of a control space to the next, so that near points are
  /// found fast.
  struct Hint {
    int triangle = -1;
    RandomBits random;
  };

  /// Triangulate the nodes in the parameter plane, scaled so that it is not distorted, over the
  /// bounding rectangle of the domain; nodes nearer to each other than a tenth of the size wanted
  /// become one with the minimum of both; then sizes are graded.
  ///
  /// Writes   surf:uv, surf:size, point() of the control mesh
  /// Cost     O(n log n), about 3 µs a node
  /// Pre      the corners of the rectangle are among the nodes
  /// Throws   InvalidInput for a node outside the rectangle, naming its (u,v)
  /// Source   paper, section 3.2
  ControlSpace(const Domain& domain, const std::vector<ControlNode>& nodes, double grade);

  /// Interpolate the sizes at a point with V_t and turn them into the metric there.
  ///
  /// Weights are 1/d² with distances through M_p at the point asked for (paper, eq. (4), (5)). A
  /// point outside the rectangle gets the sizes of its nearest triangle.
  ///
  /// Cost     about 40 ns near the point asked for last, 60 ns elsewhere while the control space
  ///          fits into the cache (136 B a triangle); 70 and 330 ns with 80,000 triangles
  Metric metric(Uv uv, const FirstFormFactor& form, Hint& hint) const;

  /// The sizes alone.
  SizeTensor size(Uv uv, const FirstFormFactor& form, Hint& hint) const;

  /// The control mesh with surf:uv, surf:size and positions in space.
  const TriMesh& mesh() const { return mesh_; }

 private:
  /// All that a query reads of one triangle, so that it lies in one place of the memory.
  struct Triangle {
    std::array<Uv, 3> corners;
    /// Behind the side from corner i to i + 1; -1 if it is open.
    std::array<int, 3> neighbours = {-1, -1, -1};
    std::array<SizeTensor, 3> sizes;
  };

  /// A regular grid of triangles to start from.
  struct SeedGrid {
    Uv lower;
    double cells_per_u = 0;
    double cells_per_v = 0;
    int side = 0;                ///< number of cells along u, and along v
    std::vector<int> triangles;  ///< the one at the middle of each cell, rows along u

    std::size_t cell(Uv uv) const;
    bool are_near(Uv a, Uv b) const;
  };

  void triangulate(const Domain& domain, const std::vector<ControlNode>& nodes);
  void grade_sizes(double grade);
  void collect_triangles();
  void make_seed_grid(const Domain& domain);
  int exit_towards(Uv uv, int triangle, int entered_from, RandomBits& random) const;
  int walk(Uv uv, int start, RandomBits& random) const;
  const Triangle& find_triangle(Uv uv, Hint& hint) const;

  TriMesh mesh_;
  decltype(keys::vertex_uv)::Handle uv_;
  decltype(keys::vertex_size)::Handle size_;
  std::vector<FirstFormFactor> forms_;
  std::vector<Triangle> triangles_;
  SeedGrid seeds_;
};

}  // namespace surfmesh
