// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/sizes/resolved_sizing.hh"
#include "surfmesh/sizes/ring_sizes.hh"
#include "surfmesh/sizes/size_bounds.hh"
#include "surfmesh/sizes/sizing.hh"
#include "surfmesh/sizes/source_tree.hh"
#include "surfmesh/sizes/wide_fans.hh"

namespace surfmesh {

/// The sources of sizes of one patch, apart from its curvature.
struct PatchSources {
  std::vector<EverywhereSource> everywhere;
  std::vector<AtSource> at;
  std::vector<AlongSource> along = {};
  std::vector<InsideSource> inside = {};
  std::vector<FieldSource> fields = {};
  std::vector<TableSource> tables = {};
  /// Sizes around points and lines in space, possibly shared with other patches: `near`, contours.
  std::vector<std::shared_ptr<const SourceTree>> trees = {};
  std::vector<WideFan> fans = {};  ///< wide ones, around which ripples do not count
  std::vector<Ring> rings = {};    ///< short ones, around which hmin does not apply

  std::optional<SizeBounds> bounds = {};  ///< of this patch, where they are not those of the model

  /// The least precision that a source gives of its own.
  std::optional<double> precision() const;
};

/// The sources that belong to each of so many patches of a model. Sizes near places and in boxes
/// that apply to the same patches share a tree.
///
/// Pre      each source names these patches only
/// Cost     O(n log² n) for n sources, and O(n) for patches
/// Throws   InvalidInput for an invalid size or radius of `near` or a box, a line without points,
///          no radius while gradation is off, or an empty box
std::vector<PatchSources> sources_by_patch(const Sources& sources, const ResolvedSizing& sizing,
                                           std::size_t patches);

/// The number of user-requested sizes outside hmin and hmax, without those of fields and tables.
///
/// The same size in several whole patches counts once, because a group becomes a source for each of
/// its patches.
/// Throws   InvalidInput for an invalid size
std::size_t count_clamped(const Sources& sources, const SizeBounds& bounds);

}  // namespace surfmesh
