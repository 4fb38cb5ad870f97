// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace surfmesh {

/// Knots nearer than this are one knot, as a share of the range of all knots: many times their
/// rounding, and far below any span that means something.
inline constexpr double kKnotRounding = 1e-12;

/// The knots of one direction with `degree` of them before the start and behind the end.
struct FullKnots {
  std::vector<double> knots;
  int degree = 1;
  int point_count = 0;  ///< of the points given; those of a periodic direction are used again
  double period = 0;    ///< 0 if there is none

  double from() const { return knots[static_cast<std::size_t>(degree)]; }
  double to() const { return knots[knots.size() - 1 - static_cast<std::size_t>(degree)]; }
  double operator[](int i) const { return knots[static_cast<std::size_t>(i)]; }
  double rounding() const { return kKnotRounding * (to() - from()); }

  /// The number of basis functions; as many as points, or more if periodic.
  int function_count() const { return static_cast<int>(knots.size()) - degree - 1; }

  /// How often a knot is there.
  int multiplicity(double knot) const;
};

/// Make equal what differs by rounding, and let a periodic direction go on beyond its ends.
///
/// Pre      the counts are right, and the knots ascend
FullKnots full_knots(const std::vector<double>& given, int degree, bool is_periodic);

/// The basis functions of a span as polynomials of s in [-1,1], which runs from one of its knots to
/// the other.
///
/// `knot` is the number of the last knot at the start of the span. Function r, of degree + 1, is
/// that of point knot - degree + r; its factor of s^k stands at [r * (degree + 1) + k].
/// Error    1e-16 times the greatest binomial of the degree
/// Cost     O(degree³)
std::vector<double> span_functions(const FullKnots& knots, int knot);

}  // namespace surfmesh
