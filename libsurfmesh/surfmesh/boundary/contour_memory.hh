// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "surfmesh/boundary/uncrossing.hh"

namespace surfmesh {

/// Keeps how contours were divided, for another mesh of the same model in which few metrics differ.
/// The context of the mesh before must outlive it.
class ContourMemory {
 public:
  /// Forget the contours beside patches whose metric is not as it was.
  void forget_changed(const Model& model, const std::vector<char>& is_changed) {
    for (std::size_t c = 0; c < divisions_.size(); ++c) {
      for (const ContourUse& use : model.contours[c].uses) {
        if (is_changed[static_cast<std::size_t>(use.patch)] != 0) divisions_[c].reset();
      }
    }
  }

  /// The division of a contour before loops were uncrossed; null unless it is known and had the
  /// same factor of segments.
  const ContourDivision* find(std::size_t contour, double more_segments) const {
    if (divisions_.empty() || !divisions_[contour]) return nullptr;
    const double known = more_segments_.empty() ? 1 : more_segments_[contour];
    return known == more_segments ? &*divisions_[contour] : nullptr;
  }

  /// Keep those of a whole model, and forget all others.
  void keep(ContourDivisions divisions, std::vector<double> more_segments) {
    divisions_ = std::move(divisions);
    more_segments_ = std::move(more_segments);
  }

 private:
  ContourDivisions divisions_;         ///< by contour
  std::vector<double> more_segments_;  ///< by contour; empty for 1
};

}  // namespace surfmesh
