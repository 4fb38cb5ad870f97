// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/contour_division.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "surfmesh/boundary/loop_steps.hh"
#include "surfmesh/boundary/segment_counts.hh"
#include "surfmesh/boundary/segment_shape.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// Shortest segment, in the metric of the patch that placed the nodes, that is halved for another
/// patch, and for a loop that crosses itself.
constexpr double kShortestHalved = 0.02;
constexpr double kShortestUncrossed = 1e-6;

}  // namespace

ContourDivision::ContourDivision(const Model& model, const Contour& contour,
                                 const std::vector<const MetricField*>& fields,
                                 const RunContext& context)
    : model_(model), contour_(contour), context_(context) {
  for (const ContourUse& use : contour.uses) {
    measure(use, *fields[static_cast<std::size_t>(use.patch)]);
    if (arcs_.back().length() > arcs_[selected_].length()) selected_ = arcs_.size() - 1;
  }
  parameters_.resize(contour.uses.size());
}

void ContourDivision::measure(const ContourUse& use, const MetricField& field) {
  try {
    arcs_.emplace_back(*use.curve, field, context_);
  } catch (const Error& error) {
    throw Error(error.code(), fmt::format("contour {} on patch {}: {}", contour_.name,
                                          model_.patch(use).name, error.what()));
  }
}

void ContourDivision::divide(int least, int multiple, std::optional<double> sag, double more) {
  const MetricArc& arc = arcs_[selected_];
  const int wanted = static_cast<int>(std::lround(arc.length() / multiple)) * multiple;
  const int rounded_least = rounded_up(least, multiple);
  const ContourUse& use = contour_.uses[selected_];
  const int count = sag ? segments_for_sag(model_.surface(use), *use.curve, arc,
                                           {rounded_least, multiple, *sag, more})
                        : std::max(wanted, rounded_least);
  for (int i = 0; i <= count; ++i) {
    append(i == 0 ? 0.0 : i == count ? 1.0 : arc.parameter(i * arc.length() / count));
  }
}

/// Halve segments, and their halves, as long as that is asked for and possible.
template <class IsHalved>
void ContourDivision::halve_where(IsHalved is_halved) {
  for (std::size_t i = 0; i < segment_count();) {
    step();
    if (is_halved(i) && can_halve(i, kShortestHalved)) {
      halve(i);
    } else {
      ++i;
    }
  }
}

bool ContourDivision::halve_long_segments() {
  const std::size_t before = segment_count();
  halve_where([this](std::size_t i) { return longest(i) > kLongestUnit; });
  return segment_count() > before;
}

void ContourDivision::even_out(int least, int multiple) {
  const std::size_t count = segment_count();
  const std::vector<double> sums = longest_sums();
  const long wanted =
      std::max<long>(rounded_up(least, multiple), multiple * std::lround(sums.back() / multiple));
  if (wanted >= static_cast<long>(count)) return;
  const Parameters before = parameters_;
  spread(sums, wanted);
  if (!is_increasing()) parameters_ = before;
  halve_long_segments();
  if (segment_count() > count) parameters_ = before;
}

void ContourDivision::halve_detours() {
  for (std::size_t use = 0; use < contour_.uses.size(); ++use) {
    if (!has_pole(model_, model_.patch(contour_.uses[use]))) continue;
    halve_where([this, use](std::size_t i) {
      return makes_detour(model_, contour_.uses[use], parameters_[use][i], parameters_[use][i + 1]);
    });
  }
}

bool ContourDivision::halve_crossing(std::size_t i) {
  if (!can_halve(i, kShortestUncrossed)) return false;
  halve(i);
  return true;
}

void ContourDivision::round_up_to(int multiple) {
  while (segment_count() % static_cast<std::size_t>(multiple) != 0) halve_longest();
}

void ContourDivision::change_count(int by) {
  const Parameters before = parameters_;
  spread(longest_sums(), static_cast<long>(segment_count()) + by);
  if (is_increasing()) return;
  parameters_ = before;
  halve_longest();
}

void ContourDivision::halve_longest() {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < segment_count(); ++i) {
    if (longest(i) > longest(worst)) worst = i;
  }
  halve(worst);
}

/// The sums of longest(i) up to each node.
std::vector<double> ContourDivision::longest_sums() const {
  std::vector<double> sums = {0};
  for (std::size_t i = 0; i < segment_count(); ++i) sums.push_back(sums.back() + longest(i));
  return sums;
}

ContourNodes ContourDivision::nodes() const {
  ContourNodes result;
  result.uv.resize(contour_.uses.size());
  const std::size_t last = segment_count();
  for (std::size_t use = 0; use < contour_.uses.size(); ++use) {
    for (std::size_t i = 0; i <= last; ++i) result.uv[use].push_back(uv(use, i));
  }
  const Surface& surface = model_.surface(contour_.uses[selected_]);
  for (std::size_t i = 0; i <= last; ++i) {
    result.points.push_back(i == 0 ? model_.position(contour_.start)
                            : i == last
                                ? model_.position(contour_.end)
                                : surface.evaluate(result.uv[selected_][i], Order::Position).point);
  }
  return result;
}

QueryCounts ContourDivision::queries() const {
  QueryCounts count;
  for (const MetricArc& arc : arcs_) count += arc.queries();
  return count;
}

/// One more segment was made or looked at.
void ContourDivision::step() {
  if (++steps_ % kSearchesBetweenCancellation == 0) context_.throw_if_cancelled();
}

/// The t on a use of the point at t of the selected use.
double ContourDivision::on_use(std::size_t use, double t) const {
  const ContourUse& from = contour_.uses[selected_];
  const ContourUse& to = contour_.uses[use];
  // Equal speed is told against the first use.
  if (use == selected_ || t == 0 || t == 1 || (from.is_same_speed && to.is_same_speed)) return t;
  return project_to_curve(model_.surface(to), *to.curve, model_.point(from, t), t);
}

/// Put a node at t of the selected use behind the last one.
void ContourDivision::append(double t) {
  step();
  for (std::size_t use = 0; use < parameters_.size(); ++use) {
    parameters_[use].push_back(on_use(use, t));
  }
}

/// Put `count` segments of equal parts of the last of `sums`, which are those of the segments so
/// far.
void ContourDivision::spread(const std::vector<double>& sums, long count) {
  const MetricArc& arc = arcs_[selected_];
  const std::vector<double> old = parameters_[selected_];
  for (auto& list : parameters_) list.assign(1, 0.0);
  std::size_t i = 0;
  for (long k = 1; k <= count; ++k) {
    const double place = static_cast<double>(k) / static_cast<double>(count) * sums.back();
    while (i + 2 < sums.size() && sums[i + 1] <= place) ++i;
    const double share = (place - sums[i]) / (sums[i + 1] - sums[i]);
    const double from = arc.arc(old[i]), to = arc.arc(old[i + 1]);
    append(k == count ? 1.0 : arc.parameter(from + share * (to - from)));
  }
}

/// True if the nodes follow each other on all uses.
bool ContourDivision::is_increasing() const {
  return std::all_of(parameters_.begin(), parameters_.end(), [](const auto& list) {
    return std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
  });
}

/// Greatest length of segment i over all uses.
double ContourDivision::longest(std::size_t i) const {
  double length = 0;
  for (std::size_t use = 0; use < parameters_.size(); ++use) {
    const auto& t = parameters_[use];
    length = std::max(length, arcs_[use].arc(t[i + 1]) - arcs_[use].arc(t[i]));
  }
  return length;
}

/// False where the selected patch sees nearly nothing of the segment, or another patch finds its
/// middle at one of its ends: halving would not end there.
bool ContourDivision::can_halve(std::size_t i, double shortest) const {
  const auto& selected = parameters_[selected_];
  const MetricArc& arc = arcs_[selected_];
  const double from = arc.arc(selected[i]), to = arc.arc(selected[i + 1]);
  if (to - from < shortest) return false;
  const double middle = arc.parameter(0.5 * (from + to));
  for (std::size_t use = 0; use < parameters_.size(); ++use) {
    const double t = on_use(use, middle);
    if (!(t > parameters_[use][i] && t < parameters_[use][i + 1])) return false;
  }
  return true;
}

void ContourDivision::halve(std::size_t i) {
  const auto& selected = parameters_[selected_];
  const MetricArc& arc = arcs_[selected_];
  const double t = arc.parameter(0.5 * (arc.arc(selected[i]) + arc.arc(selected[i + 1])));
  for (std::size_t use = 0; use < parameters_.size(); ++use) {
    auto& list = parameters_[use];
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(i + 1), on_use(use, t));
  }
}

}  // namespace surfmesh
