// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "surfmesh/across/returning_region.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// Faces of a result that follow each other and are of one patch.
struct FaceRun {
  int patch = -1;
  std::size_t first = 0, end = 0;
  std::size_t count = 0;   ///< of them, those that were not taken
  std::size_t number = 0;  ///< the first of those gets this number
};

/// The numbers that faces of a result get when regions are put back: in the order of their patches,
/// those that were not taken first, then those of the regions, one region after the other.
class FaceOrder {
 public:
  /// `is_taken` is by face: 1 for those that regions were made of.
  /// Cost     O(faces), shared
  FaceOrder(const PolyMesh& result, const std::vector<char>& is_taken,
            std::span<const ReturningRegion> regions);

  const std::vector<FaceRun>& runs() const { return runs_; }

  /// The number of the first face of a region, by patch.
  const std::map<int, std::size_t>& numbers_of(std::size_t region) const {
    return numbers_[region];
  }

  /// The number of the first face of each patch, and at the end how many faces there are.
  const std::vector<std::size_t>& first_of_patches() const { return first_of_patches_; }
  std::size_t count() const { return first_of_patches_.back(); }

 private:
  void count_by_patch();
  void number();

  std::vector<FaceRun> runs_;
  std::vector<std::map<int, std::size_t>> numbers_;  ///< how many faces, until number()
  std::vector<std::size_t> first_of_patches_;
};

}  // namespace surfmesh
