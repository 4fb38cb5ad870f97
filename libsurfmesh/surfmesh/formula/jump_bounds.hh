// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/core/interval.hh"

/// Bounds of the operations of formulas that jump. They hold the values on both sides of a jump.
namespace surfmesh {

/// −1, 0 or 1, as the sign.
Interval sign(const Interval& x);

Interval floor(const Interval& x);
Interval ceil(const Interval& x);

/// The whole number floor(a/b), if it is the same in the whole box; exactly so where b is one
/// number, else nothing also where a jump is near.
std::optional<double> whole_periods(const Interval& a, const Interval& b);

/// floored_mod(a, b); the greatest range of all values where it may jump.
Interval mod(const Interval& a, const Interval& b);

/// 1 where a < b, else 0.
Interval is_less(const Interval& a, const Interval& b);
/// 1 where a ≤ b, else 0.
Interval is_less_equal(const Interval& a, const Interval& b);
/// 1 where a = b, else 0.
Interval is_equal(const Interval& a, const Interval& b);

/// `a` where the condition is not 0, else `b`.
Interval select(const Interval& condition, const Interval& a, const Interval& b);

}  // namespace surfmesh
