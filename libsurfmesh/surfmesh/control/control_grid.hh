// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/geometry/domain.hh"

namespace surfmesh {

/// A control space of regular nodes in the bounding rectangle of a domain, with bilinear
/// interpolation: exact to second order, a query is a look-up.
/// Source   paper, section 1, the regular grid
class ControlGrid : public ControlSpace {
 public:
  /// Take side × side regular nodes, in rows along u from the lower corner. Each further node
  /// lowers the sizes at the corners of its cell. Then sizes are graded.
  ///
  /// Cost     about 0.2 µs per node
  /// Throws   InvalidInput if the number of nodes is not a square of at least 4, or for a node
  ///          outside the rectangle, naming its (u,v); InvalidOption
  ControlGrid(const Domain& domain, std::vector<ControlNode> regular,
              const std::vector<ControlNode>& others, const ControlSpaceOptions& options);

  /// Each cell cut along its rising diagonal.
  const PolyMesh& mesh() const override { return mesh_; }

 protected:
  /// Cost     below 20 ns with the metric (tests/bench/control_bench.cc)
  SizeTensor interpolate(const SurfacePoint& at, QueryHint& hint) const override;

 private:
  /// The cell that contains a point, as the node at its lower corner, and the point's coordinates
  /// in it, each in [0,1].
  struct CellPoint {
    std::size_t node;
    double s;
    double t;
  };

  CellPoint find_cell(Uv uv) const;
  std::array<std::size_t, 4> corners_of(const CellPoint& place) const;
  void lower_cell(std::vector<ControlNode>& nodes, const ControlNode& other) const;
  void make_mesh(const std::vector<ControlNode>& nodes);

  Domain domain_;
  std::size_t side_;
  double cells_per_u_;
  double cells_per_v_;
  std::vector<SizeTensor> values_;  ///< H or log H
  PolyMesh mesh_;
};

}  // namespace surfmesh
