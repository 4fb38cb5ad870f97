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
    bool is_seen = false;
    /// True where a patch has no tangent plane, at a pole: sizes are carried without direction.
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
/// Where a use runs along a side of its domain, these are the nodes of the lattice there. Elsewhere
/// the patch gets nodes of a row, at most one unit apart as sizes are
/// when the row is made.
class ContourRows {
 public:
  /// Model and spaces must outlive it.
  ContourRows(const Model& model, std::size_t contour,
              const std::vector<std::unique_ptr<ControlSpace>>& spaces);

  /// Add the rows of the uses that are not on a side.
  void make_rows();

  /// Take in the nodes that cells have got since the last time.
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
  std::optional<ContourFrame> frame_at(const Use& use, double t, const FirstFormFactor& form) const;
  double t_on(const Use& from, double t, const Use& to, const Vec3& point) const;
  void add_stations(double from, double to, int halvings, std::vector<double>& stations) const;
  double units_between(double from, double to) const;
  void make_row(Use& use, const std::vector<double>& stations);
  SizeTensor row_size(const Use& use, double t) const;

  const Model& model_;
  const Contour& contour_;
  std::vector<Use> uses_;
};

}  // namespace surfmesh::detail
