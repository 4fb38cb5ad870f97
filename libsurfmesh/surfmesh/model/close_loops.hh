// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/model/loop_checks.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/model/named_contours.hh"
#include "surfmesh/model/side_chains.hh"

namespace surfmesh {

/// The words for a loop of a patch, for messages.
std::string loop_label(const PatchInput& patch, std::size_t loop);

[[noreturn]] void fail_loop(ErrorCode code, const PatchInput& patch, std::size_t loop,
                            const std::string& reason);

/// Checks the loops of patches and adds them to the model.
class LoopCloser {
 public:
  /// Contours in a loop are nearer than `reach` to the next one, model units.
  LoopCloser(Model& model, const std::vector<PatchInput>& patches, const NamedContours& contours,
             double reach)
      : model_(model), patches_(patches), contours_(contours), reach_(reach) {}

  /// Bring the loops of a patch in order, the outer one first, turn those that run the wrong way
  /// round, and add them to the patch.
  ///
  /// Throws   Geometry if a loop does not close, leaves the domain or is a point, or if loops cross
  ///          or are not one outer loop with holes
  void add_loops(int patch, std::vector<Chain> loops);

  /// Make one vertex of those that loops have found to be the same, and drop what is not used.
  void unite_vertices();

 private:
  const PatchInput& patch(int index) const { return patches_[static_cast<std::size_t>(index)]; }
  LoopCurves curves_of(const Chain& chain) const;
  std::vector<LoopCurves> curves_of_all(const std::vector<Chain>& loops) const;
  void close(const PatchInput& patch, std::size_t loop, const Chain& chain);
  void check_extent(const PatchInput& patch, std::size_t loop, const Chain& chain) const;
  void warn_of_near_parts(int index, const PatchInput& patch,
                          const std::vector<LoopCurves>& curves);
  void add(int patch, const Chain& chain, bool is_turned);

  Model& model_;
  const std::vector<PatchInput>& patches_;
  const NamedContours& contours_;
  double reach_;
  std::vector<std::pair<int, int>> equal_vertices_;
};

}  // namespace surfmesh
