// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// All numbers from `lower` to `upper`, which may be infinite; unbounded until it is set.
///
/// An operation on intervals gives one that holds every result, as rounded, for operands inside.
/// Sums, products, quotients and square roots need no margin for that: rounding keeps the order, so
/// the extremes are at the ends. Operands without a result (0/0, √−1) are left out; if there are no
/// others, the result is unbounded. No result is NaN. A zero at the end of a divisor is taken to
/// have the sign of the rest of the divisor: a quotient by a zero of the other sign, which is
/// infinite, may lie outside.
struct Interval {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  static constexpr Interval of(double value) { return {value, value}; }

  double middle() const { return 0.5 * lower + 0.5 * upper; }
  double width() const { return upper - lower; }
  bool contains(double x) const { return lower <= x && x <= upper; }

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// A box in the parameters of a patch.
struct UvBox {
  Interval u;
  Interval v;
};

/// The interval itself; unbounded if an end is NaN or the ends are in the wrong order.
inline Interval defined(const Interval& x) { return x.lower <= x.upper ? x : Interval{}; }

/// The smallest interval with four values, of which those that are NaN do not count.
inline Interval hull(const std::array<double, 4>& values) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const double x : values) {
    lower = x < lower ? x : lower;  // false for NaN
    upper = x > upper ? x : upper;
  }
  return defined({lower, upper});
}

/// The smallest interval that holds both.
inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

/// @{
/// The results for all operands inside, as Interval tells.
inline Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }

inline Interval operator+(const Interval& a, const Interval& b) {
  return defined({a.lower + b.lower, a.upper + b.upper});
}

inline Interval operator-(const Interval& a, const Interval& b) {
  return defined({a.lower - b.upper, a.upper - b.lower});
}

inline Interval operator*(const Interval& a, const Interval& b) {
  return hull({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
}

inline Interval operator/(const Interval& a, const Interval& b) {
  if (b.lower < 0 && b.upper > 0) return {};
  if (b.lower == 0 && b.upper == 0) return {};
  const double least = b.lower == 0 ? 0.0 : b.lower, greatest = b.upper == 0 ? -0.0 : b.upper;
  return hull({a.lower / least, a.lower / greatest, a.upper / least, a.upper / greatest});
}

inline Interval min(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::min(a.upper, b.upper)};
}

inline Interval max(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::max(a.upper, b.upper)};
}

inline Interval abs(const Interval& a) {
  return {std::max({0.0, a.lower, -a.upper}), std::max(-a.lower, a.upper)};
}

/// @}

/// Tighter than a·a, whose factors are taken for independent.
inline Interval square(const Interval& a) {
  const Interval x = abs(a);
  return {x.lower * x.lower, x.upper * x.upper};
}

/// Of the part that has roots; unbounded if there is none.
inline Interval sqrt(const Interval& a) {
  if (a.upper < 0) return {};
  return {std::sqrt(std::max(a.lower, 0.0)), std::sqrt(a.upper)};
}

}  // namespace surfmesh
