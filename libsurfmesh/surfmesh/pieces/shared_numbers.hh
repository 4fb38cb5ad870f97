// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surfmesh/boundary/contour_nodes.hh"
#include "surfmesh/boundary/patch_boundary.hh"
#include "surfmesh/pieces/mesh_piece.hh"

namespace surfmesh {

/// Where the vertices that several tiles may have lie, and in which pieces: known from the
/// boundaries of all tiles alone.
class SharedNumbers {
 public:
  /// `boundaries` and `piece_of` are by tile, `rank_of_piece` is by piece; some of these may have
  /// no tiles.
  /// Cost     O(n log n) for the nodes on all boundaries
  SharedNumbers(const Model& model, const std::vector<ContourNodes>& nodes,
                const NodeNumbers& numbers, const std::vector<const PatchBoundary*>& boundaries,
                const std::vector<int>& piece_of, const std::vector<int>& rank_of_piece);

  /// How many of them are vertices of the mesh: those that no tile has are left out.
  std::int64_t count() const { return count_; }

  /// How many of them several pieces have, and several ranks.
  std::size_t of_several_pieces() const { return of_several_pieces_; }
  std::size_t of_several_ranks() const { return of_several_ranks_; }

  /// The id of one of them in the mesh, by its number.
  std::int64_t id(int number) const { return ids_[static_cast<std::size_t>(number)]; }

  /// Its position: on contours the one that all patches see alike.
  /// Pre      it is a vertex of the model or a node of a contour
  bool is_on_contour(int number) const { return number < static_cast<int>(points_.size()); }
  const Vec3& point(int number) const { return points_[static_cast<std::size_t>(number)]; }

  /// The pieces that have a vertex in common with a piece, and the numbers of these vertices.
  const std::vector<SharedWithPiece>& neighbours(int piece) const {
    return neighbours_[static_cast<std::size_t>(piece)];
  }

 private:
  /// A vertex, by its number, in a piece.
  struct Place {
    int number;
    int piece;
    friend auto operator<=>(const Place&, const Place&) = default;
  };

  void collect_neighbours(const std::vector<Place>& places, const std::vector<int>& rank_of_piece);

  std::int64_t count_ = 0;
  std::size_t of_several_pieces_ = 0, of_several_ranks_ = 0;
  std::vector<std::int64_t> ids_;                         ///< by number; -1 for those left out
  std::vector<Vec3> points_;                              ///< of those on contours
  std::vector<std::vector<SharedWithPiece>> neighbours_;  ///< by piece, with numbers
};

}  // namespace surfmesh
