// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "surfmesh/boundary/contour_memory.hh"
#include "surfmesh/control/control_space.hh"
#include "surfmesh/patch/mesh_patch.hh"

namespace surfmesh::detail {

/// A tile, or a patch that is whole.
struct TilePlace {
  std::size_t patch = 0;
  std::size_t tile = 0;  ///< of the patch
};

/// Keeps the meshes of each patch of a model, and how its contours were divided, for another run of
/// it, in which few patches differ.
///
/// Several threads may ask for meshes and keep them at once.
class PatchCache {
 public:
  explicit PatchCache(std::size_t patch_count) : patches_(patch_count) {}

  /// Begin another mesh of a patch. What was kept of it is forgotten unless it has the same sizes.
  /// Pre      other threads are at other patches only
  /// Returns  true if it has
  /// Cost     O(nodes of the control space)
  bool begin(std::size_t patch, const PolyMesh& control);

  /// The mesh that was kept of a tile, with its place in the numbers of the new boundary; nothing
  /// unless it was made from the same boundary nodes and corrected sag. It took no time.
  ///
  /// Cost     O(vertices)
  std::optional<PatchResult> find(TilePlace place, const PatchTask& task) const;

  /// How the contours were divided.
  ContourMemory& contours() { return contours_; }

  /// Keep a copy of the mesh of a tile.
  void keep(TilePlace place, double corrected_sag, const PatchResult& result);

 private:
  /// A node of a control space.
  struct Node {
    Uv uv;
    SizeTensor size;
    friend bool operator==(const Node&, const Node&) = default;
  };

  struct Kept {
    double corrected_sag = 0;
    PatchResult result;
  };

  struct KeptPatch {
    std::vector<Node> nodes;
    std::map<std::size_t, Kept> tiles;
  };

  static std::vector<Node> nodes_of(const PolyMesh& control);

  mutable std::mutex mutex_;  ///< of the maps
  std::vector<KeptPatch> patches_;
  ContourMemory contours_;
};

}  // namespace surfmesh::detail
