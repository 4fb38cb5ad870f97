// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/knot_spans.hh"

#include <algorithm>

#include "surfmesh/nurbs/full_knots.hh"

namespace surfmesh {

KnotSpans::KnotSpans(const FullKnots& knots, double from, double to)
    : lines_{from, to}, period_(knots.period), middle_((from + to) / 2) {
  if (period_ == 0) {
    add_spans(knots, 0);
  } else {
    reach_ = period_ / 2 + knots.rounding();
    // One period lies in two of the base, or touches three by rounding.
    const double first = std::floor((from - knots.from()) / period_) - 1;
    for (int turn = 0; turn < 4; ++turn) add_spans(knots, (first + turn) * period_);
  }
  per_line_ = count() / (to - from);
  is_even_ = has_even_lines();
}

/// Add the spans that overlap the range where the knots are moved.
void KnotSpans::add_spans(const FullKnots& knots, double shift) {
  const double from = lines_.front(), to = lines_.back();
  const int last = static_cast<int>(knots.knots.size()) - 1 - knots.degree;
  for (int i = knots.degree; i < last; ++i) {
    const double begin = knots[i] + shift, end = knots[i + 1] + shift;
    if (!(knots[i + 1] > knots[i])) continue;
    if (end <= from + knots.rounding() || begin >= to - knots.rounding()) continue;
    if (!spans_.empty()) lines_.insert(lines_.end() - 1, begin);
    spans_.push_back({(begin + end) / 2, 2 / (end - begin), i});
  }
}

bool KnotSpans::has_even_lines() const {
  for (int i = 0; i <= count(); ++i) {
    const double share = (lines_[static_cast<std::size_t>(i)] - lines_.front()) * per_line_ - i;
    if (!(std::abs(share) < 0.5)) return false;
  }
  return true;
}

int KnotSpans::index(double x) const {
  const auto end = std::upper_bound(lines_.begin() + 1, lines_.end() - 1, x);
  return static_cast<int>(end - lines_.begin()) - 1;
}

}  // namespace surfmesh
