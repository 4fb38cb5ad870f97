// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

struct FullKnots;

/// The knot spans of one parameter that overlap a range, each with a coordinate s from -1 to 1.
class KnotSpans {
 public:
  /// A parameter in its span.
  struct Place {
    int span = 0;
    double s = 0;      ///< beyond -1 and 1 only for what is beyond the range
    double slope = 1;  ///< ds per step of the parameter
  };

  KnotSpans() = default;

  /// `from` to `to` lies within the knots, or is no longer than the period.
  KnotSpans(const FullKnots& knots, double from, double to);

  int count() const { return static_cast<int>(spans_.size()); }

  /// The range and the knots in it, ascending.
  const std::vector<double>& lines() const { return lines_; }

  /// The number of the last of the full knots at the start of a span.
  int knot(int span) const { return spans_[static_cast<std::size_t>(span)].knot; }

  /// The span of a parameter: the one behind it at a knot, at the end of the range the last one. If
  /// the knots are periodic, a parameter outside of the range is moved by whole periods.
  /// Cost     O(log spans), O(1) where knots are even
  Place place(double x) const {
    if (period_ > 0 && std::abs(x - middle_) > reach_) {
      x -= period_ * std::round((x - middle_) / period_);
    }
    const int i = is_even_ ? even_index(x) : index(x);
    const Span& span = spans_[static_cast<std::size_t>(i)];
    return {i, (x - span.middle) * span.slope, span.slope};
  }

 private:
  struct Span {
    double middle = 0;
    double slope = 1;
    int knot = 0;
  };

  void add_spans(const FullKnots& knots, double shift);
  bool has_even_lines() const;
  int index(double x) const;

  int even_index(double x) const {
    const double cell = (x - lines_.front()) * per_line_;
    const int last = count() - 1;
    int i = cell > 0 ? (cell < last ? static_cast<int>(cell) : last) : 0;
    if (i > 0 && x < lines_[static_cast<std::size_t>(i)]) --i;
    if (i < last && x >= lines_[static_cast<std::size_t>(i) + 1]) ++i;
    return i;
  }

  std::vector<double> lines_;
  std::vector<Span> spans_;
  bool is_even_ = true;
  double per_line_ = 1;  ///< spans per step of the parameter
  double period_ = 0;
  double middle_ = 0;  ///< of the range
  double reach_ = 0;   ///< what is farther from the middle is wrapped
};

}  // namespace surfmesh
