// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace surfmesh {

/// Degree of splines through samples. An odd one, so that knots are at samples. For smooth
/// functions degree 5 takes a tenth of the samples that degree 3 takes, in each direction.
inline constexpr int kSplineDegree = 5;

/// Basis functions that are not 0 in a cell.
inline constexpr std::size_t kSplineOrder = kSplineDegree + 1;

/// Cells that a spline needs at least: with these it is one polynomial.
inline constexpr std::size_t kLeastSplineCells = kSplineDegree;

/// Makes splines through samples at equal steps. The ends are "not a knot": the two samples next to
/// each end are no knots, which keeps the order of the error, steps⁶, up to the ends.
///
/// Source   de Boor, A practical guide to splines (1978)
class UniformSpline {
 public:
  /// Samples are one more than cells.
  /// Pre      cells >= kLeastSplineCells
  /// Cost     O(cells)
  explicit UniformSpline(std::size_t cells);

  /// Factors of the basis functions: kSplineDegree - 1 more than samples. Basis function i is not 0
  /// in the cells i - kSplineDegree to i.
  std::size_t control_count() const { return cells_ + kSplineDegree; }

  /// Turn rows of samples into rows of factors, in place. The first two rows and the last two come
  /// in unset; the samples stand between them.
  /// Cost     O(cells · width), 12 multiplications each
  void solve(double* rows, std::size_t width) const;

 private:
  static constexpr std::size_t kBand = 6;  ///< of the matrix, to either side

  double& entry(std::size_t row, std::size_t column) { return matrix_[row][kBand + column - row]; }
  void fill();
  void factorise();

  std::size_t cells_;
  /// LU factors. No pivots are exchanged: the rows of samples are totally positive, and a test
  /// bounds the growth with those of the ends.
  std::vector<std::array<double, 2 * kBand + 1>> matrix_;
};

/// The basis functions that are not 0 in a cell, and their derivatives, at s in [0,1] of the cell;
/// derivatives are with respect to s.
struct SplineBasis {
  std::array<double, kSplineOrder> value;
  std::array<double, kSplineOrder> first;
  std::array<double, kSplineOrder> second;
};

SplineBasis spline_basis(double s);

}  // namespace surfmesh
