// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/piece_tree.hh"

#include <cstddef>

namespace surfmesh::detail {
namespace {

/// Far above the rounding of cosines, far below any angle that matters.
constexpr double kCosineRounding = 1e-9;

/// Rounding of a distance as a share of the extent of the box that it is taken from.
constexpr double kDistanceRounding = 1e-14;

double greatest_product(const Vec3& direction, const Vec3& low, const Vec3& high) {
  return direction.cwiseProduct(low).cwiseMax(direction.cwiseProduct(high)).sum();
}

void extend(PieceVolume& volume, const PieceVolume& other) {
  volume.chords.extend(other.chords);
  volume.inward.extend(other.inward);
}

}  // namespace

bool may_face(const PieceVolume& volume, const Facing& facing, const Vec3& point) {
  const double least_cosine =
      -greatest_product(-facing.inward, volume.inward.min(), volume.inward.max());
  if (least_cosine > facing.opposite + kCosineRounding) return false;
  const double distance = volume.chords.exteriorDistance(point);
  const double ahead =
      greatest_product(facing.inward, volume.chords.min() - point, volume.chords.max() - point);
  const double rounding = kDistanceRounding * volume.chords.sizes().sum();
  return ahead + rounding >= (facing.ahead - kCosineRounding) * distance;
}

PieceTree::PieceTree(const std::vector<PieceVolume>& pieces) {
  std::vector<int> numbers;
  std::vector<Eigen::AlignedBox3d> chords;
  for (const PieceVolume& piece : pieces) {
    numbers.push_back(static_cast<int>(numbers.size()));
    chords.push_back(piece.chords);
  }
  boxes_.init(numbers.begin(), numbers.end(), chords.begin(), chords.end());
  // Children come before their parents, the root last.
  for (Index index = 0; index <= boxes_.getRootIndex(); ++index) {
    volumes_.push_back(volume_of(index, pieces));
  }
}

PieceTree::Volume PieceTree::volume_of(Index index, const std::vector<PieceVolume>& pieces) const {
  VolumeIterator volume = nullptr, last_volume = nullptr;
  ObjectIterator piece = nullptr, last_piece = nullptr;
  boxes_.getChildren(index, volume, last_volume, piece, last_piece);
  Volume all;
  for (; volume != last_volume; ++volume) extend(all, getVolume(*volume));
  for (; piece != last_piece; ++piece) extend(all, pieces[static_cast<std::size_t>(*piece)]);
  return all;
}

}  // namespace surfmesh::detail
