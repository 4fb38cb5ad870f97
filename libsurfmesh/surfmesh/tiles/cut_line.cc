// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/tiles/cut_line.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/boundary/segment_counts.hh"
#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/predicates.hh"

namespace surfmesh::detail {
namespace {

/// Segments of a cut at least: none joins two nodes that something else joins.
constexpr int kLeastSegments = 3;

/// Least metric length of a cut: with so many segments, shorter ones would be too fine for the
/// triangles beside them.
constexpr double kLeastLength = 2.5;

/// Least metric distance of a node from a cut: triangles between them are still well shaped.
constexpr double kLeastDistance = 0.6;

/// Least angle between a cut and the sides at its ends, radians (39°): two neighbours of a node a
/// unit away under this angle are as far from each other as kLeastDistance asks for.
constexpr double kLeastAngle = 0.68;

/// A metric along a cut.
struct Station {
  double share;  ///< of the cut
  Metric metric;
};

/// A cut, and its length in the metric.
class MeasuredCut {
 public:
  MeasuredCut(TileCut cut, Uv from, Uv to, const CutRules& rules)
      : cut_(std::move(cut)), line_(from, to), rules_(rules), arc_(line_, rules.field) {
    queries_ = arc_.queries();
    const SegmentBounds bounds{kLeastSegments, 1, rules.sag};
    const int wanted = rules.sag > 0 ? segments_for_sag(rules.surface, line_, arc_, bounds)
                                     : static_cast<int>(std::lround(arc_.length()));
    count_ = std::max(kLeastSegments, wanted);
    QueryHint hint;
    for (int i = 0; i <= count_; ++i) {
      const double share = share_of(i);
      stations_.push_back({share, rules.field.at(line_.evaluate(share), hint)});
    }
    queries_ += hint.answers;
  }

  TileCut& cut() { return cut_; }
  const TileCut& cut() const { return cut_; }
  const QueryCounts& queries() const { return queries_; }
  Uv from() const { return line_.evaluate(0); }
  Uv to() const { return line_.evaluate(1); }
  const Metric& metric_at_start() const { return stations_.front().metric; }
  const Metric& metric_at_end() const { return stations_.back().metric; }

  /// Squared metric distance of a point.
  double squared_distance(Uv point) const {
    const Uv along = to() - from(), offset = point - from();
    const double first = share_below(along, offset, {1, 0, 1});
    const double share = share_below(along, offset, metric_at(first));
    return squared_length(metric_at(share), offset - share * along);
  }

  /// Make the number of segments odd or even, the nearer one to the length.
  void set_parity(int parity) {
    if (count_ % 2 == parity) return;
    const bool is_fewer = rules_.sag == 0 && arc_.length() < count_ && count_ > kLeastSegments;
    count_ += is_fewer ? -1 : 1;
  }

  int count() const { return count_; }
  double length() const { return arc_.length(); }

  std::vector<Uv> inner_nodes() const {
    std::vector<Uv> nodes;
    for (int i = 1; i < count_; ++i) nodes.push_back(line_.evaluate(share_of(i)));
    return nodes;
  }

 private:
  double share_of(int i) const {
    return i == 0 ? 0.0 : i == count_ ? 1.0 : arc_.parameter(i * arc_.length() / count_);
  }

  static double share_below(Uv along, Uv offset, const Metric& m) {
    return std::clamp(inner_product(m, along, offset) / squared_length(m, along), 0.0, 1.0);
  }

  const Metric& metric_at(double share) const {
    const auto behind =
        std::partition_point(stations_.begin(), stations_.end(),
                             [share](const Station& station) { return station.share < share; });
    return behind == stations_.end() ? stations_.back().metric : behind->metric;
  }

  TileCut cut_;
  SegmentCurve line_;
  const CutRules& rules_;
  MetricArc arc_;
  int count_ = 0;
  std::vector<Station> stations_;
  QueryCounts queries_;
};

/// Finds the cuts along one line and looks whether they are good.
class LineCut {
 public:
  LineCut(const TilePolygon& polygon, std::vector<TileNode>& nodes, const CutRules& rules,
          QueryCounts& queries)
      : polygon_(polygon), nodes_(nodes), rules_(rules), queries_(queries) {}

  std::vector<TilePolygon> run(int axis, double value) {
    if (!collect(axis, value) || !are_apart() || !have_good_angles()) return {};
    if (!keep_their_distance() || has_crossing()) return {};
    CutPolygons divided = divide(polygon_, nodes_, plain_cuts());
    const bool is_divided = std::all_of(divided.beside.begin(), divided.beside.end(),
                                        [](const auto& pair) { return pair.first != pair.second; });
    if (divided.parts.empty() || !is_divided) return {};
    if (rules_.multiple == 2) even_out(divided);
    add_nodes();
    return divide(polygon_, nodes_, plain_cuts()).parts;
  }

 private:
  Uv uv(SidePlace place) const { return node(place).uv; }
  const TileNode& node(SidePlace place) const {
    return nodes_[static_cast<std::size_t>(at(polygon_, place).node)];
  }

  /// Cuts between the nodes nearest to where the line enters and leaves the polygon.
  /// Returns  false if there are none, or one is too short or has no end
  bool collect(int axis, double value) {
    const auto ends = crossings(polygon_, nodes_, axis, value);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      const auto from = nearest_end(ends[i]), to = nearest_end(ends[i + 1]);
      if (!from || !to) return false;
      const bool are_neighbours =
          *from == *to || next(polygon_, *from) == *to || next(polygon_, *to) == *from;
      if (are_neighbours) continue;
      cuts_.emplace_back(TileCut{*from, *to}, uv(*from), uv(*to), rules_);
      queries_ += cuts_.back().queries();
      if (cuts_.back().length() < kLeastLength) return false;
    }
    return !cuts_.empty();
  }

  std::optional<SidePlace> nearest_end(const LineCrossing& crossing) const {
    SidePlace near = crossing.side, far = next(polygon_, crossing.side);
    if (crossing.share > 0.5) std::swap(near, far);
    if (node(near).can_end_cut) return near;
    return node(far).can_end_cut ? std::optional(far) : std::nullopt;
  }

  /// True if no two cuts end in one node.
  bool are_apart() const {
    std::vector<int> ends;
    for (const MeasuredCut& cut : cuts_) {
      ends.push_back(at(polygon_, cut.cut().from).node);
      ends.push_back(at(polygon_, cut.cut().to).node);
    }
    std::sort(ends.begin(), ends.end());
    return std::adjacent_find(ends.begin(), ends.end()) == ends.end();
  }

  bool have_good_angles() const {
    return std::all_of(cuts_.begin(), cuts_.end(), [this](const MeasuredCut& cut) {
      return is_inside_sector(cut.cut().from, cut.to(), cut.metric_at_start()) &&
             is_inside_sector(cut.cut().to, cut.from(), cut.metric_at_end());
    });
  }

  /// True if a cut leads from a node into the polygon, away from both sides there.
  bool is_inside_sector(SidePlace place, Uv to, const Metric& metric) const {
    const Uv centre = uv(place);
    const Uv ahead = uv(next(polygon_, place)) - centre;
    const Uv behind = uv(previous(polygon_, place)) - centre;
    return angle_between(ahead, to - centre, metric) >= kLeastAngle &&
           angle_between(to - centre, behind, metric) >= kLeastAngle &&
           angle_between(ahead, to - centre, metric) < angle_between(ahead, behind, metric);
  }

  /// The angle by which one direction is turned to the left against another in a metric, from 0
  /// to 2π; of equal ones 2π.
  static double angle_between(Uv from, Uv to, const Metric& m) {
    const double angle = std::atan2(std::sqrt(std::max(0.0, determinant(m))) * cross(from, to),
                                    inner_product(m, from, to));
    return angle > 0 ? angle : angle + 2 * std::numbers::pi;
  }

  bool keep_their_distance() const {
    bool is_good = true;
    for_each_side(polygon_, [&](SidePlace place) {
      if (!is_good) return;
      is_good = std::all_of(cuts_.begin(), cuts_.end(), [&](const MeasuredCut& cut) {
        return is_at_end(place, cut.cut()) ||
               cut.squared_distance(uv(place)) >= kLeastDistance * kLeastDistance;
      });
    });
    return is_good;
  }

  /// True for the nodes at the ends of a cut, and those beside them, which the angles keep away.
  bool is_at_end(SidePlace place, const TileCut& cut) const {
    for (const SidePlace end : {cut.from, cut.to}) {
      if (place == end || place == next(polygon_, end) || next(polygon_, place) == end) return true;
    }
    return false;
  }

  bool has_crossing() const {
    bool is_any = false;
    for_each_side(polygon_, [&](SidePlace place) {
      const Uv a = uv(place), b = uv(next(polygon_, place));
      for (const MeasuredCut& cut : cuts_) is_any = is_any || cross_strictly(a, b, cut);
    });
    for (std::size_t i = 1; i < cuts_.size() && !is_any; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        is_any = is_any || cross_strictly(cuts_[j].from(), cuts_[j].to(), cuts_[i]);
      }
    }
    return is_any;
  }

  static bool cross_strictly(Uv a, Uv b, const MeasuredCut& cut) {
    const Uv from = cut.from(), to = cut.to();
    return orient2d(from, to, a) * orient2d(from, to, b) < 0 &&
           orient2d(a, b, from) * orient2d(a, b, to) < 0;
  }

  std::vector<TileCut> plain_cuts() const {
    std::vector<TileCut> cuts;
    for (const MeasuredCut& cut : cuts_) cuts.push_back(cut.cut());
    return cuts;
  }

  /// A cut, and the part beyond it as seen from the part from which it was reached.
  struct Branch {
    std::size_t cut, beyond;
  };

  /// Cuts that lead from the first part to all others, each after those that lead to it.
  std::vector<Branch> tree_of_parts(const CutPolygons& divided) const {
    std::vector<char> is_reached(divided.parts.size(), 0);
    std::vector<Branch> tree;
    is_reached[0] = 1;
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t c = 0; c < cuts_.size(); ++c) {
        const auto [a, b] = divided.beside[c];
        if (is_reached[a] == is_reached[b]) continue;
        const std::size_t beyond = is_reached[a] != 0 ? b : a;
        is_reached[beyond] = 1;
        tree.push_back({c, beyond});
        grows = true;
      }
    }
    return tree;
  }

  /// Give every part an even number of sides, from the leaves of a tree of parts on. The root is
  /// even because all together are.
  void even_out(const CutPolygons& divided) {
    std::vector<int> parity;
    // Each cut is one side still.
    for (const TilePolygon& part : divided.parts) {
      parity.push_back(static_cast<int>(part.side_count() % 2));
    }
    const std::vector<Branch> tree = tree_of_parts(divided);
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      const bool is_in_tree = std::any_of(tree.begin(), tree.end(),
                                          [c](const Branch& branch) { return branch.cut == c; });
      if (!is_in_tree) count_segments(divided, c, parity);
    }
    for (auto branch = tree.rbegin(); branch != tree.rend(); ++branch) {
      // The side that the cut counts as is replaced by its segments.
      cuts_[branch->cut].set_parity(parity[branch->beyond] == 0 ? 1 : 0);
      count_segments(divided, branch->cut, parity);
    }
  }

  /// Count the segments of a cut among the sides of both parts beside it, in place of one side.
  void count_segments(const CutPolygons& divided, std::size_t c, std::vector<int>& parity) const {
    const auto [a, b] = divided.beside[c];
    for (const std::size_t part : {a, b}) parity[part] = (parity[part] + cuts_[c].count() - 1) % 2;
  }

  void add_nodes() {
    for (MeasuredCut& cut : cuts_) {
      for (const Uv uv : cut.inner_nodes()) {
        cut.cut().inner.push_back(static_cast<int>(nodes_.size()));
        nodes_.push_back({uv});
      }
    }
  }

  const TilePolygon& polygon_;
  std::vector<TileNode>& nodes_;
  const CutRules& rules_;
  QueryCounts& queries_;
  std::vector<MeasuredCut> cuts_;
};

}  // namespace

std::vector<TilePolygon> divide_at(const TilePolygon& polygon, std::vector<TileNode>& nodes,
                                   int axis, double value, const CutRules& rules,
                                   QueryCounts& queries) {
  return LineCut(polygon, nodes, rules, queries).run(axis, value);
}

}  // namespace surfmesh::detail
