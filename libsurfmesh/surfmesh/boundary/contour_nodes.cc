// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/contour_nodes.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/quality/triangle_distance_detail.hh"

namespace surfmesh {
namespace {

/// Longest segment in the metric of a patch that did not place the nodes.
constexpr double kLongestSegment = std::numbers::sqrt2;

/// Shortest segment, in the metric of the patch that placed the nodes, that is halved for another.
constexpr double kShortestHalved = 0.02;

/// Numbers of segments that are tried for the sag, as shares of the metric length.
constexpr double kFewest = 0.71, kMost = 4;

/// Samples of a segment, and the share of the sag they may have: the greatest lies between them.
constexpr int kSagSteps = 4;
constexpr double kSagShare = 0.95;

const Patch& patch_of(const Model& model, const ContourUse& use) {
  return model.patches[static_cast<std::size_t>(use.patch)];
}

/// The least number of segments with which the contour can be part of a proper mesh.
class LeastSegments {
 public:
  explicit LeastSegments(const Model& model) : poles_(model.vertices.size(), false) {
    for (const Contour& contour : model.contours) {
      if (contour.is_degenerate) {
        poles_[static_cast<std::size_t>(contour.start)] = true;
      } else {
        ++count_[std::minmax(contour.start, contour.end)];
      }
    }
  }

  int operator()(const Contour& contour) const {
    const bool starts_at_pole = poles_[static_cast<std::size_t>(contour.start)];
    const bool ends_at_pole = poles_[static_cast<std::size_t>(contour.end)];
    int least = contour.start == contour.end                                   ? 3
                : count_.at(std::minmax(contour.start, contour.end)) > 1 ? 2
                                                                               : 1;
    return std::max(least, 1 + (starts_at_pole ? 1 : 0) + (ends_at_pole ? 1 : 0));
  }

 private:
  std::vector<bool> poles_;
  std::map<std::pair<int, int>, int> count_;
};

/// One contour while its nodes are placed: the t of each node on each use.
class ContourDivision {
 public:
  ContourDivision(const Model& model, const Contour& contour,
                  const std::vector<const MetricField*>& fields)
      : model_(model), contour_(contour) {
    for (const ContourUse& use : contour.uses) {
      measure(use, *fields[static_cast<std::size_t>(use.patch)]);
      if (arcs_.back().length() > arcs_[selected_].length()) selected_ = arcs_.size() - 1;
    }
    parameters_.resize(contour.uses.size());
  }

  void divide(int least, const BoundaryOptions& options) {
    const double length = arcs_[selected_].length();
    const int multiple = options.multiple;
    const int wanted = static_cast<int>(std::lround(length / multiple)) * multiple;
    const int rounded_least = (least + multiple - 1) / multiple * multiple;
    const int count = options.sag ? count_for_sag(rounded_least, options)
                                  : std::max(wanted, rounded_least);
    for (int i = 0; i <= count; ++i) {
      const double t = i == 0 ? 0.0 : i == count ? 1.0
                                                 : arcs_[selected_].parameter(i * length / count);
      for (std::size_t use = 0; use < parameters_.size(); ++use) {
        parameters_[use].push_back(on_use(use, t));
      }
    }
  }

  void halve_long_segments() {
    for (std::size_t i = 0; i + 1 < parameters_[selected_].size();) {
      if (longest(i) > kLongestSegment && can_halve(i)) {
        halve(i);
      } else {
        ++i;
      }
    }
  }

  void round_up_to(int multiple) {
    while ((parameters_[selected_].size() - 1) % static_cast<std::size_t>(multiple) != 0) {
      std::size_t worst = 0;
      for (std::size_t i = 1; i + 1 < parameters_[selected_].size(); ++i) {
        if (longest(i) > longest(worst)) worst = i;
      }
      halve(worst);
    }
  }

  /// Queries of the metric fields so far.
  QueryCounts queries() const {
    QueryCounts count;
    for (const MetricArc& arc : arcs_) count += arc.queries();
    return count;
  }

  ContourNodes nodes() const {
    ContourNodes result;
    result.uv.resize(contour_.uses.size());
    const ContourUse& owner = contour_.uses[selected_];
    const std::size_t last = parameters_[selected_].size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      for (std::size_t use = 0; use < contour_.uses.size(); ++use) {
        result.uv[use].push_back(contour_.uses[use].curve->evaluate(parameters_[use][i]));
      }
      const Surface& surface = *patch_of(model_, owner).surface;
      result.points.push_back(i == 0      ? vertex(contour_.start)
                              : i == last ? vertex(contour_.end)
                                          : surface.evaluate(result.uv[selected_][i],
                                                             Order::Position).point);
    }
    return result;
  }

 private:
  void measure(const ContourUse& use, const MetricField& field) {
    try {
      arcs_.emplace_back(*use.curve, field);
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("contour {} on patch {}: {}", contour_.name,
                                            patch_of(model_, use).name, error.what()));
    }
  }

  Vec3 vertex(int index) const { return model_.vertices[static_cast<std::size_t>(index)].position; }

  /// The least count, a multiple, with which all segments are near enough.
  int count_for_sag(int least, const BoundaryOptions& options) const {
    const double length = arcs_[selected_].length();
    const int step = options.multiple;
    int count = std::max(least, step * static_cast<int>(std::ceil(kFewest * length / step)));
    while (count < kMost * length && !holds(count, *options.sag)) count += step;
    return count;
  }

  /// True if none of so many segments is farther from the surface than the sag.
  bool holds(int count, double sag) const {
    const double length = arcs_[selected_].length();
    double from = 0;
    for (int i = 1; i <= count; ++i) {
      const double to = i == count ? 1.0 : arcs_[selected_].parameter(i * length / count);
      if (sag_between(from, to) > kSagShare * sag) return false;
      from = to;
    }
    return true;
  }

  /// The greatest distance of the segment between two t of the selected use from the contour.
  double sag_between(double from, double to) const {
    const Vec3 a = point_at(from), b = point_at(to);
    double sag = 0;
    for (int i = 1; i < kSagSteps; ++i) {
      const Vec3 point = point_at(from + (to - from) * i / kSagSteps);
      sag = std::max(sag, detail::segment_distance(point, a, b));
    }
    return sag;
  }

  Vec3 point_at(double t) const {
    const ContourUse& use = contour_.uses[selected_];
    return patch_of(model_, use)
        .surface->evaluate(use.curve->evaluate(t), Order::Position)
        .point;
  }

  /// The t on a use of the point at t of the selected use.
  double on_use(std::size_t use, double t) const {
    const ContourUse& from = contour_.uses[selected_];
    const ContourUse& to = contour_.uses[use];
    // Equal speed is told against the first use.
    if (use == selected_ || t == 0 || t == 1 || (from.is_same_speed && to.is_same_speed)) return t;
    const Vec3 point =
        patch_of(model_, from).surface->evaluate(from.curve->evaluate(t), Order::Position).point;
    return project_to_curve(*patch_of(model_, to).surface, *to.curve, point, t);
  }

  /// Greatest length of segment i over all uses.
  double longest(std::size_t i) const {
    double length = 0;
    for (std::size_t use = 0; use < parameters_.size(); ++use) {
      const auto& t = parameters_[use];
      length = std::max(length, arcs_[use].arc(t[i + 1]) - arcs_[use].arc(t[i]));
    }
    return length;
  }

  /// False where the selected patch sees nearly nothing of the segment, or another patch finds its
  /// middle at one of its ends: halving would not end there.
  bool can_halve(std::size_t i) const {
    const auto& selected = parameters_[selected_];
    const MetricArc& arc = arcs_[selected_];
    const double from = arc.arc(selected[i]), to = arc.arc(selected[i + 1]);
    if (to - from < kShortestHalved) return false;
    const double middle = arc.parameter(0.5 * (from + to));
    for (std::size_t use = 0; use < parameters_.size(); ++use) {
      const double t = on_use(use, middle);
      if (!(t > parameters_[use][i] && t < parameters_[use][i + 1])) return false;
    }
    return true;
  }

  void halve(std::size_t i) {
    const auto& selected = parameters_[selected_];
    const MetricArc& arc = arcs_[selected_];
    const double t = arc.parameter(0.5 * (arc.arc(selected[i]) + arc.arc(selected[i + 1])));
    for (std::size_t use = 0; use < parameters_.size(); ++use) {
      auto& list = parameters_[use];
      list.insert(list.begin() + static_cast<std::ptrdiff_t>(i + 1), on_use(use, t));
    }
  }

  const Model& model_;
  const Contour& contour_;
  std::vector<MetricArc> arcs_;
  std::size_t selected_ = 0;
  std::vector<std::vector<double>> parameters_;
};

ContourNodes degenerate_nodes(const Model& model, const Contour& contour) {
  ContourNodes nodes;
  nodes.points.assign(2, model.vertices[static_cast<std::size_t>(contour.start)].position);
  for (const ContourUse& use : contour.uses) {
    nodes.uv.push_back({use.curve->evaluate(0), use.curve->evaluate(1)});
  }
  return nodes;
}

}  // namespace

void check(const BoundaryOptions& options) {
  if (options.multiple < 1) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("multiple = {} is outside its range: 1 or above", options.multiple));
  }
  if (options.sag && !(*options.sag > 0)) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("sag = {} is outside its range: above 0", *options.sag));
  }
}

BoundaryNodes place_contour_nodes(const Model& model,
                                  const std::vector<const MetricField*>& fields,
                                  const BoundaryOptions& options) {
  check(options);
  const LeastSegments least(model);
  BoundaryNodes result;
  result.contours.resize(model.contours.size());
  std::vector<QueryCounts> queries(model.contours.size());
  share_indices(model.contours.size(), [&](std::size_t c) {
    const Contour& contour = model.contours[c];
    if (contour.uses.empty()) return;
    if (contour.is_degenerate) {
      result.contours[c] = degenerate_nodes(model, contour);
      return;
    }
    ContourDivision division(model, contour, fields);
    division.divide(least(contour), options);
    division.halve_long_segments();
    division.round_up_to(options.multiple);
    result.contours[c] = division.nodes();
    queries[c] = division.queries();
  });
  for (const QueryCounts& count : queries) result.report.queries += count;
  return result;
}

}  // namespace surfmesh
