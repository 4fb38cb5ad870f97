// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "surfmesh/boundary/contour_memory.hh"
#include "surfmesh/control/control_space.hh"
#include "surfmesh/patch/mesh_patch.hh"

namespace surfmesh::detail {

/// Keeps the mesh of each patch of a model, and how its contours were divided, for another run of
/// it, in which few patches differ.
///
/// Different patches may be asked for and kept by several threads at once.
class PatchCache {
 public:
  explicit PatchCache(std::size_t patch_count) : patches_(patch_count) {}

  /// The mesh that was kept of a patch, with its place in the numbers of the new boundary; nothing
  /// unless it was made from the same sizes, boundary nodes and corrected sag. It took no time.
  ///
  /// Cost     O(nodes of the control space + vertices)
  std::optional<PatchResult> find(std::size_t patch, const PolyMesh& control,
                                  const PatchTask& task) const;

  /// True if a mesh was kept of a patch that had the same sizes.
  bool has_sizes(std::size_t patch, const PolyMesh& control) const {
    return patches_[patch] && patches_[patch]->nodes == nodes_of(control);
  }

  /// How the contours were divided.
  ContourMemory& contours() { return contours_; }

  /// Keep a copy of the mesh of a patch.
  void keep(std::size_t patch, const PolyMesh& control, double corrected_sag,
            const PatchResult& result);

 private:
  /// A node of a control space.
  struct Node {
    Uv uv;
    SizeTensor size;
    friend bool operator==(const Node&, const Node&) = default;
  };

  struct Kept {
    std::vector<Node> nodes;
    double corrected_sag = 0;
    PatchResult result;
  };

  static std::vector<Node> nodes_of(const PolyMesh& control);

  std::vector<std::optional<Kept>> patches_;
  ContourMemory contours_;
};

}  // namespace surfmesh::detail
