// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/assemble/piece.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh::detail {

/// The vertices of the result that several pieces may have, with the numbers that NodeNumbers gives
/// them, but for those that no face has.
class CommonVertices {
 public:
  /// Vertices that no face has (of cage faces without a surface) are dropped: all pieces get lower
  /// numbers then.
  ///
  /// Pre      survey_border has been called for all pieces
  CommonVertices(std::vector<Piece>& pieces, const NodeNumbers& numbers);

  int count() const { return static_cast<int>(owner_.size()); }

  /// Those of the model and on contours, which come first.
  int contour_count() const { return contour_count_; }

  /// True if a piece that has a vertex is the one that writes what the result holds of it: of
  /// several pieces the last one.
  bool is_written_by(int piece, int vertex) const {
    return vertex >= count() || owner_[static_cast<std::size_t>(vertex)] == piece;
  }

  /// True for vertices of the model and nodes of contours.
  bool is_on_contour(int vertex) const { return vertex < contour_count_; }

  /// Give those on contours their points.
  void set_points(const Model& model, const std::vector<ContourNodes>& nodes,
                  const NodeNumbers& numbers, std::vector<PolyMesh::Point>& points) const;

 private:
  void drop_unused(std::vector<Piece>& pieces);
  void set_point(int node, const Vec3& point, std::vector<PolyMesh::Point>& points) const;

  std::vector<int> owner_;   ///< by vertex, a piece
  std::vector<int> number_;  ///< by the number of NodeNumbers, -1 if dropped; empty if none is
  int contour_count_;
};

}  // namespace surfmesh::detail
