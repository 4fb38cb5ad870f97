// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/jump_bounds.hh"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surfmesh/formula/floored_mod.hh"

namespace surfmesh {
namespace {

/// Several roundings, as a share.
constexpr double kJumpMargin = 8 * std::numeric_limits<double>::epsilon();

double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

bool is_single(const Interval& x) { return x.lower == x.upper; }

/// The truth of what holds in the whole box, or nowhere in it.
Interval truth(bool is_everywhere, bool is_nowhere) {
  return {is_everywhere ? 1.0 : 0.0, is_nowhere ? 0.0 : 1.0};
}

/// True if floor(a/period) is the same for both ends: the rest grows by as much as a does. Behind a
/// jump it would be less by a period, which the margin tells from roundings.
bool is_in_one_period(const Interval& a, double period) {
  if (is_single(a)) return true;
  return a.width() < (1 - kJumpMargin) * std::abs(period) &&
         floored_mod(a.lower, period) <= floored_mod(a.upper, period);
}

}  // namespace

Interval sign(const Interval& x) { return {sign(x.lower), sign(x.upper)}; }

Interval floor(const Interval& x) { return {std::floor(x.lower), std::floor(x.upper)}; }

Interval ceil(const Interval& x) { return {std::ceil(x.lower), std::ceil(x.upper)}; }

std::optional<double> whole_periods(const Interval& a, const Interval& b) {
  if (b.contains(0) || !std::isfinite(a.width()) || !std::isfinite(b.width())) return {};
  if (is_single(b)) {
    if (!is_in_one_period(a, b.lower)) return {};
    return std::round((a.lower - floored_mod(a.lower, b.lower)) / b.lower);
  }
  const Interval quotient = a / b;
  const double slack = kJumpMargin * (1 + abs(quotient).upper);
  const double first = std::floor(quotient.lower - slack);
  const double last = std::floor(quotient.upper + slack);
  if (first != last) return {};
  return first;
}

Interval mod(const Interval& a, const Interval& b) {
  if (b == Interval{0, 0}) return {};
  const Interval all = {std::min(b.lower, 0.0), std::max(b.upper, 0.0)};
  const auto periods = whole_periods(a, b);
  if (!periods) return all;
  if (is_single(b)) return {floored_mod(a.lower, b.lower), floored_mod(a.upper, b.lower)};
  const Interval rest = a - Interval::of(*periods) * b;
  const double error = kJumpMargin * abs(a).upper;
  return {std::clamp(rest.lower - error, all.lower, all.upper),
          std::clamp(rest.upper + error, all.lower, all.upper)};
}

Interval is_less(const Interval& a, const Interval& b) {
  return truth(a.upper < b.lower, a.lower >= b.upper);
}

Interval is_less_equal(const Interval& a, const Interval& b) {
  return truth(a.upper <= b.lower, a.lower > b.upper);
}

Interval is_equal(const Interval& a, const Interval& b) {
  return truth(is_single(a) && a == b, a.upper < b.lower || b.upper < a.lower);
}

Interval select(const Interval& condition, const Interval& a, const Interval& b) {
  if (!condition.contains(0)) return a;
  return condition == Interval{0, 0} ? b : hull(a, b);
}

}  // namespace surfmesh
