// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/sizes/resolved_sizing.hh"
#include "surfmesh/sizes/ring_sizes.hh"
#include "surfmesh/sizes/size_bounds.hh"
#include "surfmesh/sizes/sizing.hh"
#include "surfmesh/sizes/source_tree.hh"

namespace surfmesh {

/// What has a say in the sizes of one patch besides its curvature.
struct PatchSources {
  std::vector<EverywhereSource> everywhere;
  std::vector<AtSource> at;
  std::vector<AlongSource> along = {};
  std::vector<InsideSource> inside = {};
  std::vector<FieldSource> fields = {};
  std::vector<TableSource> tables = {};
  std::vector<TableSource> sag = {};  ///< in place of what the curvature asks for; one at most
  /// Sizes around places in space, perhaps shared with other patches: `near`, contours.
  std::vector<std::shared_ptr<const SourceTree>> trees = {};
  std::vector<Ring> rings = {};  ///< short ones, around which hmin does not hold

  /// The least precision that a source asks for itself.
  std::optional<double> precision() const;
};

/// The sources that belong to one patch of a model. `near` belongs to all and is not among them.
PatchSources sources_of_patch(const Sources& sources, int patch);

/// The sizes of `near` of all patches; null if there is none.
///
/// Throws   InvalidInput for a size or radius that is none, a line without points, or without a
///          radius where gradation is off
std::shared_ptr<const SourceTree> near_tree(const Sources& sources, const ResolvedSizing& sizing);

/// Number of sizes of the user beyond hmin and hmax, without those of fields and tables.
///
/// Whole patches with one and the same size count once: a group is one source for each of its
/// patches.
/// Throws   InvalidInput for a size that is none
std::size_t count_clamped(const Sources& sources, const SizeBounds& bounds);

}  // namespace surfmesh
