// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/lattice_space.hh"

namespace surfmesh {

/// Factors by which the sizes of one patch are multiplied, kept at the nodes of its lattice.
class SizeFactors {
 public:
  /// The logarithm of a factor that is wanted at a point of the patch.
  struct Wanted {
    Uv uv;
    double log_factor;
  };

  /// All factors are 1. The lattice must outlive this.
  explicit SizeFactors(const LatticeSpace& lattice);

  /// Multiply the factors by the geometric mean of those wanted around each node; nodes with none
  /// take those of their neighbours. Then factors are smoothed over neighbours, because a jump of
  /// sizes gives elements of poor shape.
  void multiply(const std::vector<Wanted>& wanted);

  /// Multiply the factors by the least one wanted around each node, if that is below 1. Factors
  /// that make the size of the node larger than `greatest`, where sizes are clamped, are lowered
  /// from where they reach it: otherwise nothing would change.
  void lower(const std::vector<Wanted>& wanted, double greatest);

  /// How often they have changed.
  int changes() const { return changes_; }

  /// The factor at a point; fast if its cell is `near`, which becomes that cell.
  double at(Uv uv, int& near) const;

 private:
  std::vector<double> mean_of(const std::vector<Wanted>& wanted) const;
  void spread(std::vector<double>& logs) const;
  void smooth(std::vector<double>& logs) const;

  const LatticeSpace& lattice_;
  std::vector<double> logs_;  ///< of the factors, by node
  int changes_ = 0;
};

}  // namespace surfmesh
