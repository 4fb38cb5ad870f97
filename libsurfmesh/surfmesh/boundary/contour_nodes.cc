// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/contour_nodes.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "surfmesh/boundary/crossing_segments.hh"
#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/boundary/pole_room.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/quality/triangle_distance.hh"

namespace surfmesh {
namespace {

/// Shortest segment, in the metric of the patch that placed the nodes, that is halved for another
/// patch, and for a loop that crosses itself.
constexpr double kShortestHalved = 0.02;
constexpr double kShortestUncrossed = 1e-6;

/// Greatest distance of a segment's line in the parameters from contour and chord, in its length.
constexpr double kMostAstray = 0.2;

/// Rounds of halving segments of loops that cross, and the most segments that these may become, as
/// a multiple and beyond: curves that do not cross, but overlap, would have no end.
constexpr int kMostUncrossings = 40;
constexpr std::size_t kMostGrowth = 4, kMostSurplus = 10'000;

/// Of two segments that cross the shorter is halved, too, if it is longer than this share.
constexpr double kShareHalvedToo = 0.6;

/// Numbers of segments that are tried for the sag, as shares of the metric length.
constexpr double kFewest = 0.71, kMost = 4;

/// Samples of a segment, and the share of the sag they may have: the greatest lies between them.
constexpr int kSagSteps = 4;
constexpr double kSagShare = 0.95;

const Patch& patch_of(const Model& model, const ContourUse& use) { return model.patch(use); }

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
    int least = contour.start == contour.end                             ? 3
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
  using Parameters = std::vector<std::vector<double>>;  ///< by use, then by node

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
    const int rounded_least = rounded_up(least, multiple);
    const int count =
        options.sag ? count_for_sag(rounded_least, options) : std::max(wanted, rounded_least);
    for (int i = 0; i <= count; ++i) {
      const double t = i == 0       ? 0.0
                       : i == count ? 1.0
                                    : arcs_[selected_].parameter(i * length / count);
      for (std::size_t use = 0; use < parameters_.size(); ++use) {
        parameters_[use].push_back(on_use(use, t));
      }
    }
  }

  /// Returns  true if there were any
  bool halve_long_segments() {
    const std::size_t before = segment_count();
    for (std::size_t i = 0; i < segment_count();) {
      if (longest(i) > kLongestUnit && can_halve(i, kShortestHalved)) {
        halve(i);
      } else {
        ++i;
      }
    }
    return segment_count() > before;
  }

  /// Spread the nodes evenly over what the finest patch wants at each place, if halving has made
  /// more segments than that takes.
  void even_out(int least, int multiple) {
    const std::size_t count = parameters_[selected_].size() - 1;
    std::vector<double> sums = {0};
    for (std::size_t i = 0; i < count; ++i) sums.push_back(sums.back() + longest(i));
    const long wanted =
        std::max<long>(rounded_up(least, multiple), multiple * std::lround(sums.back() / multiple));
    if (wanted >= static_cast<long>(count)) return;
    const auto before = parameters_;
    spread(sums, wanted);
    if (!is_increasing()) parameters_ = before;
    halve_long_segments();
    if (parameters_[selected_].size() > before[selected_].size()) parameters_ = before;
  }

  /// Halve segments whose straight line in the parameters of a patch with a pole is astray: near
  /// the pole it runs around it where the contour passes by.
  void halve_astray_segments() {
    for (std::size_t use = 0; use < contour_.uses.size(); ++use) {
      if (!has_pole(patch_of(model_, contour_.uses[use]))) continue;
      for (std::size_t i = 0; i < segment_count();) {
        if (is_astray(use, i) && can_halve(i, kShortestHalved)) {
          halve(i);
        } else {
          ++i;
        }
      }
    }
  }

  /// Halve a segment where that is possible.
  /// Returns  true if it was
  bool halve_crossing(std::size_t i) {
    if (!can_halve(i, kShortestUncrossed)) return false;
    halve(i);
    return true;
  }

  const Parameters& parameters() const { return parameters_; }
  void set_parameters(Parameters parameters) { parameters_ = std::move(parameters); }

  std::size_t segment_count() const { return parameters_[selected_].size() - 1; }

  /// The nodes as a use sees them.
  std::vector<Uv> uvs(std::size_t use) const {
    std::vector<Uv> result;
    for (const double t : parameters_[use]) {
      result.push_back(contour_.uses[use].curve->evaluate(t));
    }
    return result;
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
    for (std::size_t use = 0; use < contour_.uses.size(); ++use) result.uv[use] = uvs(use);
    for (std::size_t i = 0; i <= last; ++i) {
      const Surface& surface = *patch_of(model_, owner).surface;
      result.points.push_back(
          i == 0      ? vertex(contour_.start)
          : i == last ? vertex(contour_.end)
                      : surface.evaluate(result.uv[selected_][i], Order::Position).point);
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

  static int rounded_up(int count, int multiple) {
    return (count + multiple - 1) / multiple * multiple;
  }

  /// Put `count` segments of equal parts of the last of `sums`, which are those of the segments so
  /// far.
  void spread(const std::vector<double>& sums, long count) {
    const MetricArc& arc = arcs_[selected_];
    const std::vector<double> old = parameters_[selected_];
    for (auto& list : parameters_) list.assign(1, 0.0);
    std::size_t i = 0;
    for (long k = 1; k <= count; ++k) {
      const double place = static_cast<double>(k) / static_cast<double>(count) * sums.back();
      while (i + 2 < sums.size() && sums[i + 1] <= place) ++i;
      const double share = (place - sums[i]) / (sums[i + 1] - sums[i]);
      const double from = arc.arc(old[i]), to = arc.arc(old[i + 1]);
      const double t = k == count ? 1.0 : arc.parameter(from + share * (to - from));
      for (std::size_t use = 0; use < parameters_.size(); ++use) {
        parameters_[use].push_back(on_use(use, t));
      }
    }
  }

  /// True if the nodes follow each other on all uses.
  bool is_increasing() const {
    return std::all_of(parameters_.begin(), parameters_.end(), [](const auto& list) {
      return std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
    });
  }

  Vec3 vertex(int index) const { return model_.position(index); }

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
    return patch_of(model_, use).surface->evaluate(use.curve->evaluate(t), Order::Position).point;
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

  bool has_pole(const Patch& patch) const {
    for (const PatchLoop& loop : patch.loops) {
      for (const LoopEntry& entry : loop) {
        if (model_.contour(entry).is_degenerate) return true;
      }
    }
    return false;
  }

  /// True if the middle of the line in the parameters is far both from the contour and the chord.
  bool is_astray(std::size_t use, std::size_t i) const {
    const Surface& surface = *patch_of(model_, contour_.uses[use]).surface;
    const Curve& curve = *contour_.uses[use].curve;
    const double from = parameters_[use][i], to = parameters_[use][i + 1];
    const auto point = [&](Uv uv) { return surface.evaluate(uv, Order::Position).point; };
    const Uv uv_a = curve.evaluate(from), uv_b = curve.evaluate(to);
    const Vec3 a = point(uv_a), b = point(uv_b);
    const Vec3 middle = point(curve.evaluate(0.5 * (from + to)));
    const Vec3 line = point(lerp(uv_a, uv_b, 0.5));
    const double distance =
        std::min({detail::segment_distance(line, a, b), detail::segment_distance(line, a, middle),
                  detail::segment_distance(line, middle, b)});
    return distance > kMostAstray * (b - a).norm();
  }

  /// False where the selected patch sees nearly nothing of the segment, or another patch finds its
  /// middle at one of its ends: halving would not end there.
  bool can_halve(std::size_t i, double shortest) const {
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
  Parameters parameters_;
};

using ContourDivisions = std::vector<std::optional<ContourDivision>>;

/// A segment of a contour.
struct ContourSegment {
  int contour = -1;
  std::size_t segment = 0;

  friend auto operator<=>(const ContourSegment&, const ContourSegment&) = default;
};

/// Halves segments until the loops of a patch, whose curves do not cross, do not either, nor are in
/// the way of the rings that cut off its poles.
class Uncrossing {
 public:
  Uncrossing(const Model& model, ContourDivisions& divisions, int multiple)
      : model_(model), divisions_(divisions), multiple_(multiple), most_(kMostSurplus) {
    for (const auto& division : divisions_) {
      if (division) most_ += kMostGrowth * division->segment_count();
    }
  }

  /// Leaves the nodes as they are where that does not succeed: curves that touch are found later.
  void run() {
    std::vector<ContourDivision::Parameters> before;
    for (const auto& division : divisions_) {
      before.push_back(division ? division->parameters() : ContourDivision::Parameters{});
    }
    std::set<ContourSegment> segments = crossing_or_beside_poles();
    for (int round = 0; round < kMostUncrossings && uncross(segments); ++round) {
      segments = crossing_or_beside_poles();
    }
    // A ring without room may be meshed all the same.
    if (segments.empty() || crossing().empty()) return;
    for (std::size_t c = 0; c < divisions_.size(); ++c) {
      if (divisions_[c]) divisions_[c]->set_parameters(std::move(before[c]));
    }
  }

 private:
  struct Loops {
    std::vector<detail::NodeLoop> nodes;
    std::vector<std::vector<ContourSegment>> segments;  ///< after each node
  };

  /// Returns false if nothing crosses, or nothing can be done about it.
  bool uncross(const std::set<ContourSegment>& segments) {
    std::size_t halved = 0;
    // Backwards, for halving moves the segments behind.
    for (auto it = segments.rbegin(); it != segments.rend(); ++it) {
      ContourDivision& division = *divisions_[static_cast<std::size_t>(it->contour)];
      if (halved_ < most_ && division.halve_crossing(it->segment)) ++halved;
    }
    for (const ContourSegment& segment : segments) {
      divisions_[static_cast<std::size_t>(segment.contour)]->round_up_to(multiple_);
    }
    halved_ += halved;
    return halved > 0;
  }

  std::set<ContourSegment> crossing() const {
    std::set<ContourSegment> segments;
    for (const Patch& patch : model_.patches) {
      collect(loops_of(patch), segments);
    }
    return segments;
  }

  /// Those that cross, and those next to poles whose rings have no room.
  std::set<ContourSegment> crossing_or_beside_poles() const {
    std::set<ContourSegment> segments;
    for (const Patch& patch : model_.patches) {
      const Loops loops = loops_of(patch);
      collect(loops, segments);
      for (std::size_t l = 0; l < loops.nodes.size(); ++l) collect_at_poles(loops, l, segments);
    }
    return segments;
  }

  Loops loops_of(const Patch& patch) const {
    Loops loops;
    for (const PatchLoop& loop : patch.loops) {
      loops.nodes.emplace_back();
      loops.segments.emplace_back();
      for (const LoopEntry& entry : loop) append(entry, loops);
    }
    return loops;
  }

  /// Add the nodes of a use but its last one, which the next use has, too.
  void append(const LoopEntry& entry, Loops& loops) const {
    const Contour& contour = model_.contour(entry);
    const auto& division = divisions_[static_cast<std::size_t>(entry.contour)];
    const auto use = static_cast<std::size_t>(entry.use);
    const Curve& curve = *contour.uses[use].curve;
    std::vector<Uv> uvs =
        division ? division->uvs(use) : std::vector<Uv>{curve.evaluate(0), curve.evaluate(1)};
    const bool is_forward = contour.uses[use].is_forward;
    if (!is_forward) std::reverse(uvs.begin(), uvs.end());
    const std::size_t count = uvs.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      loops.nodes.back().push_back(uvs[i]);
      loops.segments.back().push_back({entry.contour, is_forward ? i : count - 1 - i});
    }
  }

  void collect(const Loops& loops, std::set<ContourSegment>& crossing) const {
    for (const auto& [p, q] : detail::crossing_segments(loops.nodes)) {
      const double length_p = length(loops, p), length_q = length(loops, q);
      if (length_p >= kShareHalvedToo * length_q) add(loops.segments[p.loop][p.node], crossing);
      if (length_q >= kShareHalvedToo * length_p) add(loops.segments[q.loop][q.node], crossing);
    }
  }

  /// Add the segments next to poles whose rings have no room.
  void collect_at_poles(const Loops& loops, std::size_t l,
                        std::set<ContourSegment>& crossing) const {
    const std::vector<ContourSegment>& segments = loops.segments[l];
    const detail::NodeLoop& nodes = loops.nodes[l];
    const std::size_t n = nodes.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (is_pole(segments[i]) || !is_pole(segments[(i + 1) % n])) continue;
      std::size_t last = i + 1;  // of the sides that are the pole
      while (is_pole(segments[(last + 1) % n])) ++last;
      const ContourSegment& to = segments[i];
      const ContourSegment& from = segments[(last + 1) % n];
      const detail::PoleSide pole{nodes[i], nodes[(i + 1) % n], nodes[(last + 1) % n],
                                  nodes[(last + 2) % n]};
      if (has_room(loops, pole, {to.contour, from.contour})) continue;
      add(to, crossing);
      add(from, crossing);
    }
  }

  bool is_pole(const ContourSegment& segment) const {
    return model_.contour(segment.contour).is_degenerate;
  }

  /// `seams` are the contours that lead to the pole.
  static bool has_room(const Loops& loops, const detail::PoleSide& pole,
                       const std::array<int, 2>& seams) {
    for (std::size_t l = 0; l < loops.nodes.size(); ++l) {
      const detail::NodeLoop& nodes = loops.nodes[l];
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const int contour = loops.segments[l][i].contour;
        if (contour == seams[0] || contour == seams[1]) continue;
        if (detail::is_in_the_way(pole, nodes[i], nodes[(i + 1) % nodes.size()])) return false;
      }
    }
    return true;
  }

  void add(const ContourSegment& segment, std::set<ContourSegment>& crossing) const {
    if (divisions_[static_cast<std::size_t>(segment.contour)]) crossing.insert(segment);
  }

  static double length(const Loops& loops, const detail::LoopSegment& segment) {
    const detail::NodeLoop& nodes = loops.nodes[segment.loop];
    const Uv step = nodes[(segment.node + 1) % nodes.size()] - nodes[segment.node];
    return std::hypot(step.u, step.v);
  }

  const Model& model_;
  ContourDivisions& divisions_;
  int multiple_;
  std::size_t most_;
  std::size_t halved_ = 0;
};

ContourNodes degenerate_nodes(const Model& model, const Contour& contour) {
  ContourNodes nodes;
  nodes.points.assign(2, model.position(contour.start));
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

BoundaryNodes place_contour_nodes(const Model& model, const std::vector<const MetricField*>& fields,
                                  const BoundaryOptions& options) {
  check(options);
  const LeastSegments least(model);
  ContourDivisions divisions(model.contours.size());
  share_indices(model.contours.size(), [&](std::size_t c) {
    const Contour& contour = model.contours[c];
    if (contour.uses.empty() || contour.is_degenerate) return;
    ContourDivision& division = divisions[c].emplace(model, contour, fields);
    division.divide(least(contour), options);
    if (division.halve_long_segments() && !options.sag) {
      division.even_out(least(contour), options.multiple);
    }
    division.halve_astray_segments();
    division.round_up_to(options.multiple);
  });
  Uncrossing(model, divisions, options.multiple).run();
  BoundaryNodes result;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    if (divisions[c]) {
      result.contours.push_back(divisions[c]->nodes());
      result.report.queries += divisions[c]->queries();
    } else if (model.contours[c].is_degenerate && !model.contours[c].uses.empty()) {
      result.contours.push_back(degenerate_nodes(model, model.contours[c]));
    } else {
      result.contours.emplace_back();
    }
  }
  return result;
}

}  // namespace surfmesh
