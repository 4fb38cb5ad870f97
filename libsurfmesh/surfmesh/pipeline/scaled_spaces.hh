// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/sampling/size_factors.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh::detail {

/// The control spaces of a model, made again and again with scaled sizes: cells and nodes are
/// chosen once, then only the sizes at the nodes change.
class ScaledSpaces {
 public:
  /// Model and context must outlive it.
  ///
  /// Throws   as make_control_spaces
  ScaledSpaces(const Model& model, const Sources& sources, const ResolvedSizing& sizing,
               const ControlOptions& options, const RunContext& context);

  /// False for a triangulation of nodes, whose sizes stay as they are.
  bool can_scale() const { return !factors_.empty(); }

  /// The factors of the sizes from curvature in a patch.
  /// Pre      can_scale()
  SizeFactors& factors(std::size_t patch) { return *factors_[patch]; }

  /// The control spaces with the sizes from curvature times the factors, within their bounds. Sizes
  /// of the user's sources stay as they are. All are graded.
  ///
  /// Throws   as make_control_spaces
  ControlSpaces make();

 private:
  /// Sizes times factors, graded within the patch, but not finished.
  struct Graded {
    std::unique_ptr<LatticeSpace> space;
    int changes = 0;  ///< of the factors
  };

  std::unique_ptr<ControlSpace> scaled(std::size_t patch);
  const LatticeSpace& graded(std::size_t patch);

  const Model& model_;
  const RunContext& context_;
  SizeBounds bounds_;
  ControlBases bases_;
  std::vector<const LatticeSpace*> lattices_;  ///< of the bases; none of a triangulation
  std::vector<std::shared_ptr<SizeFactors>> factors_;
  std::vector<Graded> graded_;  ///< for the next time that factors are as they were
  std::vector<std::shared_ptr<const SizeField>> wishes_;  ///< what is not scaled; null for nothing
};

}  // namespace surfmesh::detail
