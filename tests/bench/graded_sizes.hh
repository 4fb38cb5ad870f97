// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "bench/patch_grid.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh::judge {

/// The exact sizes of the patches, in their order.
using SizeFields = std::vector<std::unique_ptr<SizeField>>;

/// The exact sizes of all patches of a model at the nodes of grids, graded within the patches and
/// across their contours.
///
/// Sizes of the surface outside of the loops of a trimmed patch count too.
class GradedSizes {
 public:
  /// Points of contours and the required points of the fields take part, besides the nodes. The
  /// fields must outlive the sizes.
  ///
  /// Pre      as many fields and grids as patches
  /// Cost     one query of a field and 10 to 20 µs for each node; 150 bytes for each until it
  /// returns
  GradedSizes(const Model& model, const SizeFields& fields, double grade,
              std::vector<PatchGrid> grids);

  /// The minimum of the graded sizes, bilinear in H between the nodes, and the exact size there.
  SizeTensor at(int patch, Uv uv) const;

  /// √det M, the metric area of a unit of area in (u,v), with these sizes.
  double density(int patch, Uv uv) const;

  /// Metric area of the whole domain of a patch.
  double metric_area(int patch) const;

  const PatchGrid& grid(int patch) const { return grids_[static_cast<std::size_t>(patch)]; }
  const std::vector<PatchGrid>& grids() const { return grids_; }

 private:
  const SizeFields* fields_;
  std::vector<PatchGrid> grids_;
  std::vector<std::vector<SizeTensor>> sizes_;  ///< by patch and node
};

/// The nodes of several grids together.
std::size_t node_count(const std::vector<PatchGrid>& grids);

}  // namespace surfmesh::judge
