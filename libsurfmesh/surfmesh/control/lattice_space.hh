// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/core/copy_mesh.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/geometry/domain.hh"

namespace surfmesh {

/// A side of a domain: of constant u or v at its lower or upper end, or the diagonal of a triangle.
enum class DomainSide { LowerU, UpperU, LowerV, UpperV, Diagonal };

/// A control space whose nodes are crossings of grid lines, with bilinear interpolation between
/// them.
///
/// The nodes are the vertices of a polygon mesh, and queries read their surf:size. While the space
/// is graded, also across contours, nodes may be added and lowered; finish() ends this.
///
/// A contour that does not run along a side of the domain has nodes of its own: loose ones, in rows
/// along the contour. Beside such a row a query also takes its sizes, grown by their distance.
class LatticeSpace : public ControlSpace {
 public:
  /// The cell that contains a point, and the nodes in it that the point is interpolated from, with
  /// their shares. A node may be -1, with the share 0.
  struct Support {
    int cell;
    std::array<int, 4> nodes;
    std::array<double, 4> weights;
  };

  /// The vertices of this mesh are the nodes. After finish(), its faces are the parts between them,
  /// with surf:class, and each node has surf:radius and surf:outer_radius.
  const PolyMesh& mesh() const override { return mesh_; }

  /// Gives a node another size than it has.
  using ChangeSize = std::function<SizeTensor(const ControlNode&)>;

  /// A copy in which every node has another size, also those that it gets later.
  ///
  /// Cost     that of `change` at each node; no node is sampled
  /// Pre      finish() has not been called
  virtual std::unique_ptr<LatticeSpace> changed_copy(const ChangeSize& change) const = 0;

  const Domain& domain() const { return domain_; }
  int node_count() const { return static_cast<int>(mesh_.n_vertices()); }
  Uv uv(int node) const { return mesh_.property(uv_, VertexHandle(node)); }
  // By value: nodes may be added while a caller holds the result.
  FirstFormFactor form(int node) const override { return forms_[static_cast<std::size_t>(node)]; }
  SizeTensor size(int node) const { return mesh_.property(size_, VertexHandle(node)); }
  using ControlSpace::size;
  SurfacePoint surface_point(int node) const;

  void set_size(int node, const SizeTensor& size) {
    mesh_.property(size_, VertexHandle(node)) = size;
  }

  /// Find what a point is interpolated from; fast if its cell is `near`.
  virtual Support support(Uv uv, int near) const = 0;

  /// Width and height of a cell in parameters.
  virtual Uv cell_extent(int cell) const = 0;

  /// Call `visit` for each node that gradation takes the size of a node to.
  template <class Visit>
  void for_each_neighbour(int node, Visit visit) const {
    for (const int other : neighbours(node)) visit(other);
    const auto row = row_neighbours_.find(node);
    if (row == row_neighbours_.end()) return;
    for (const int other : row->second) visit(other);
  }

  /// The nodes on a side of the domain, in one direction.
  virtual std::vector<int> nodes_on_side(DomainSide side) const = 0;

  /// Add nodes so that the cell of a point becomes shorter, if it is longer than a number of units
  /// in a metric. Returns the new nodes; none where it is short, or where cells cannot be divided.
  virtual std::vector<int> divide_cell(Uv uv, const Metric& metric, double units) = 0;

  /// Halve cells that give more than 1.1 times the size of a finer neighbour at a node on their
  /// common side, if they are longer along it than two of its units. Returns the new nodes.
  virtual std::vector<int> divide_beside_finer() { return {}; }

  /// Some nodes and those beside them, from where sizes reach them.
  std::vector<int> with_neighbours(const std::vector<int>& nodes) const;

  /// Add a node at the end of a row, after the node `before`, or -1 for a new row. Its sizes reach
  /// the nodes of its cell and those beside it in the row.
  int add_row_node(const ControlNode& node, int before);

  /// Add a node of a row between two neighbours in it.
  int insert_row_node(const ControlNode& node, int from, int to);

  /// Take in sizes at single points: as nodes of rows of one if sizes are graded, otherwise by the
  /// nodes around each point, in cells that are at most two of its units long if they can be
  /// divided.
  /// Returns  the nodes of the points; none if sizes are not graded
  /// Throws   InvalidInput for a point outside the rectangle, naming its (u,v)
  std::vector<int> hold_points(const std::vector<ControlNode>& points);

  /// Join nodes of rows that are less than two of their units apart, as points along a band of
  /// small sizes are: between them, sizes are interpolated.
  ///
  /// Cost     O(n²) at most, for n nodes in a band of constant u; more than 10,000 are not joined
  void join_row_nodes(std::vector<int> nodes);

  /// The size at a point between the nodes of the lattice, without rows and discs.
  SizeTensor lattice_size(Uv uv, int& near) const;

  /// Grade from some nodes, and from all rows.
  /// Throws   Cancelled
  void grade(const std::vector<int>& from, const RunContext& context);

  /// Grade from all nodes. Gradation makes sizes bend where those of the sources did not, so cells
  /// are halved beside finer ones (divide_beside_finer) until none is left that misses them.
  /// Throws   Cancelled
  void grade_all(const RunContext& context);

  /// Take all sizes as final: build the faces, and prepare for queries.
  void finish();

 protected:
  /// A list of nodes that is made anew for each question.
  struct Neighbours {
    std::array<int, 32> nodes;
    std::size_t count = 0;

    void add(int node) { nodes[count++] = node; }
    const int* begin() const { return nodes.data(); }
    const int* end() const { return nodes.data() + count; }
  };

  /// `discs` are nodes of extended forms, see ControlSpace.
  LatticeSpace(const Domain& domain, const ControlSpaceOptions& options,
               const std::vector<ControlNode>& discs);

  SizeTensor interpolate(const SurfacePoint& at, QueryHint& hint) const override;

  int add_node(const ControlNode& node);

  /// Change the sizes of all nodes.
  void change_sizes(const ChangeSize& change);

  /// The nodes from a number on.
  std::vector<int> nodes_from(int first) const;

  /// Called for a node that belongs to no cell.
  virtual void announce_loose_node() = 0;

  /// The nodes beside a node in the lattices of its cells.
  virtual Neighbours neighbours(int node) const = 0;

  virtual FaceList faces() const = 0;

 private:
  /// A part of a row between two nodes; twice the same node for a row of one.
  struct RowSegment {
    int from;
    int to;
  };

  void lower_around(const ControlNode& point);
  SizeTensor weighted(const Support& support) const;
  SizeTensor limited_by_rows(const SizeTensor& size, const SurfacePoint& at, int cell) const;
  SizeTensor limited_by(const RowSegment& segment, const SizeTensor& size,
                        const SurfacePoint& at) const;
  void link_rows();
  void assign_rows();
  void take_logarithms();

  Domain domain_;
  CopiedMesh mesh_;
  PropertyKey<VertexHandle, Uv>::Handle uv_;
  PropertyKey<VertexHandle, SizeTensor>::Handle size_;
  std::vector<FirstFormFactor> forms_;  ///< by node
  std::vector<SizeTensor> logarithms_;  ///< by node; empty without Blend::Logarithmic
  std::vector<RowSegment> segments_;
  std::unordered_map<int, std::vector<int>> segments_of_;     ///< by cell
  std::unordered_map<int, std::vector<int>> row_neighbours_;  ///< by node, in both directions
};

}  // namespace surfmesh
