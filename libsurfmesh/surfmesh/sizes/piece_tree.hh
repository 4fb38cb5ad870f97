// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/BVH>

#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh::detail {

/// Pieces of a boundary as a search sees them, one or several.
struct PieceVolume {
  Eigen::AlignedBox3d chords;
  Eigen::AlignedBox3d inward;  ///< of the unit vectors into the patch
};

/// What a search asks of a piece that it looks for from a point.
struct Facing {
  Vec3 inward;          ///< unit vector into the patch at the point
  double opposite = 0;  ///< greatest cosine between this and the inward vector of the piece
  double ahead = -1;    ///< least cosine between this and the way to the piece
};

/// False if no piece in a volume is as a search from a point asks, which bounds tell; they hold
/// up to rounding.
bool may_face(const PieceVolume& volume, const Facing& facing, const Vec3& point);

/// A hierarchy of pieces, in the form that Eigen's searches take. Pieces that face away are left
/// out whole branches at a time: along a boundary with nothing opposite, a search by distance alone
/// would look at every piece within its reach.
class PieceTree {
 public:
  using Boxes = Eigen::KdBVH<double, 3, int>;
  using Index = Boxes::Index;
  using Volume = PieceVolume;
  using Object = int;  ///< number of a piece
  using VolumeIterator = Boxes::VolumeIterator;
  using ObjectIterator = Boxes::ObjectIterator;

  PieceTree() = default;
  explicit PieceTree(const std::vector<PieceVolume>& pieces);

  Index getRootIndex() const { return boxes_.getRootIndex(); }
  const Volume& getVolume(Index index) const { return volumes_[static_cast<std::size_t>(index)]; }
  void getChildren(Index index, VolumeIterator& first_volume, VolumeIterator& last_volume,
                   ObjectIterator& first_object, ObjectIterator& last_object) const {
    boxes_.getChildren(index, first_volume, last_volume, first_object, last_object);
  }

 private:
  Volume volume_of(Index index, const std::vector<PieceVolume>& pieces) const;

  Boxes boxes_;
  std::vector<Volume> volumes_;  ///< by index of an inner node of `boxes_`
};

}  // namespace surfmesh::detail
