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
  /// Take side × side nodes, rows along u, the first at the lower corner. A further node lowers the
  /// sizes at the corners of its cell. Then sizes are graded.
  ///
  /// Cost     about 0.2 µs a node
  /// Throws   InvalidInput for another number of nodes than side², at least 4, or a node outside
  ///          the rectangle, naming its (u,v); InvalidOption
  ControlGrid(const Domain& domain, std::vector<ControlNode> regular,
              const std::vector<ControlNode>& others, const ControlSpaceOptions& options);

  /// Each cell cut along its rising diagonal.
  const TriMesh& mesh() const override { return mesh_; }

 protected:
  /// Cost     below 20 ns with the metric (tests/bench/control_bench.cc)
  SizeTensor interpolate(const SurfacePoint& at, QueryHint& hint) const override;

 private:
  /// A cell by its lower corner's node, and where a point lies in it, each share in [0,1].
  struct Place {
    std::size_t node;
    double s;
    double t;
  };

  Place place_of(Uv uv) const;
  std::array<std::size_t, 4> corners_of(const Place& place) const;
  void lower_cell(std::vector<ControlNode>& nodes, const ControlNode& other) const;
  void make_mesh(const std::vector<ControlNode>& nodes);

  Domain domain_;
  std::size_t side_;
  double cells_per_u_;
  double cells_per_v_;
  std::vector<SizeTensor> values_;  ///< H or log H
  TriMesh mesh_;
};

}  // namespace surfmesh
