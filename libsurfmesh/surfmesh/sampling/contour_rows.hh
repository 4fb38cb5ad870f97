// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/control/lattice_space.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sampling/contour_frame.hh"

namespace surfmesh::detail {

/// A node of a patch on a contour, and where the other uses of the contour see it.
struct ContourNode {
  /// The same point on another use.
  struct Sight {
    /// True where a patch has no tangent plane, nor has it beside: sizes are carried without
    /// direction.
    bool is_isotropic = false;
    double t = 0;  ///< on that use
    SurfacePoint at = {};
    ContourFrame frame = {};
    int cell = -1;  ///< where that patch was asked last
  };

  int node = -1;
  double t = 0;  ///< on its own use
  ContourFrame frame = {};
  std::vector<Sight> sights = {};  ///< by use; of its own only the cell counts
};

/// The nodes of the patches of one contour along it.
///
/// Where a use runs along a side of its domain, from one node of the lattice to another, these are
/// the nodes of the lattice there. Elsewhere the patch gets nodes of a row, about one unit apart.
class ContourRows {
 public:
  /// Model and spaces must outlive it.
  ContourRows(const Model& model, std::size_t contour,
              const std::vector<std::unique_ptr<ControlSpace>>& spaces);

  /// Add the rows of the uses that are not on a side.
  void make_rows();

  /// Add nodes to the rows of a use where sizes have come down until two nodes are more than two
  /// units apart. Returns them.
  std::vector<int> extend_rows(std::size_t use);

  /// Take in the nodes that cells and rows have got since the last time.
  void update();

  std::size_t use_count() const { return uses_.size(); }
  int patch(std::size_t use) const { return uses_[use].use->patch; }
  LatticeSpace& space(std::size_t use) const { return *uses_[use].space; }
  std::vector<ContourNode>& nodes(std::size_t use) { return uses_[use].nodes; }

  /// The side that a use runs along, if it does.
  std::optional<DomainSide> side(std::size_t use) const { return uses_[use].side; }

  /// The size of a use at a node of another one, in the frame of the contour as that one sees it.
  SizeTensor size_seen(std::size_t from, std::size_t to, ContourNode& node) const;

  /// True if two uses lie on the same side of the contour in their parameters.
  bool is_mirrored(std::size_t a, std::size_t b) const {
    return uses_[a].use->is_forward == uses_[b].use->is_forward;
  }

 private:
  struct Use {
    const ContourUse* use;
    const Surface* surface;
    LatticeSpace* space;
    std::optional<DomainSide> side;
    std::vector<ContourNode> nodes;  ///< by t
  };

  std::optional<DomainSide> find_side(const Use& use) const;
  std::optional<double> parameter_on_side(const Use& use, Uv uv) const;
  void update_side(std::size_t use);
  ContourNode seen(std::size_t use, int node, double t) const;
  ContourNode::Sight sight_of(const Use& from, double t, const Use& to, const Vec3& point) const;
  double t_on(const Use& from, double t, const Use& to, const Vec3& point) const;
  /// A point of the first use, and the least of the sizes along the contour there; infinite where
  /// no use has a direction.
  struct Station {
    double t;
    Vec3 point;
    double size;
  };

  bool ends_at_nodes(const Use& use, DomainSide side) const;
  std::optional<DomainSide> side_along(const Use& use) const;
  Station station_at(double t) const;
  void add_stations(const Station& from, const Station& to, int halvings,
                    std::vector<Station>& stations) const;
  void make_row(Use& use, const std::vector<Station>& stations);
  ControlNode row_node_at(const Use& use, double t) const;
  static bool is_long(const Use& use, const ContourNode& a, const ContourNode& b);
  SizeTensor row_size(const Use& use, double t) const;

  const Model& model_;
  const Contour& contour_;
  std::vector<Use> uses_;
};

}  // namespace surfmesh::detail
