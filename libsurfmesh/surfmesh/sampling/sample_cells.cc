// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/sample_cells.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "surfmesh/control/grade_sizes.hh"
#include "surfmesh/geometry/quasirandom.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/sampling/control_nodes.hh"
#include "surfmesh/sizes/field_search.hh"
#include "surfmesh/sizes/hidden_sizes.hh"

namespace surfmesh {
namespace {

/// Units of metric length below which a cell is not halved: its nodes are half of it apart.
constexpr double kLeastUnits = 2;

/// The precision for which that is enough. Finer ones halve cells further, to a length that goes
/// with the root of the precision, as the errors of an interpolation of second order do.
constexpr double kUsualPrecision = 0.1;

/// Units below which a cell is not halved although a place in it has far smaller sizes than the
/// cell gives. Such places become points of their own, and along a band they are to be near each
/// other.
constexpr double kUnitsAtPlaces = 1.25;

/// Share of the bend of three nodes that may be missed between them: a quarter on a smooth field,
/// more where the bend grows towards a side of the cell.
constexpr double kMissPerBend = 0.75;

/// Smaller bends tell no direction.
constexpr double kLeastBend = 0.08;

/// A bend that is a smaller share of the greatest one is not worth a halving in its place.
constexpr double kLesserBend = 0.25;

/// A point that misses the precision so many times is worth a halving in any direction.
constexpr double kGrossMiss = 3;

/// Cells along each side of a surface of one cell, unless they are short.
constexpr double kFirstSide = 4;

/// Where a field has a smaller size than all samples of a cell, one of this share is looked for
/// next.
constexpr double kNextSearch = 0.7;

/// Units above which a cell is halved whatever its samples say, for nodes can fall in step with a
/// periodic field.
constexpr double kLongestCell = 16;
/// Units above which a cell is looked at in several places.
constexpr double kManySamples = 4;

/// Shares of the width and height of a cell where it is looked at inside: irrational, so that a
/// periodic field does not hide, and different in cells beside each other.
constexpr std::array<std::array<double, 2>, 4> kGuardShares = {
    {{0.2817, 0.6473}, {0.7236, 0.3191}, {0.3587, 0.2229}, {0.6381, 0.7764}}};

/// Nodes in all: far more than sizes that elements can follow ever need in one patch.
constexpr double kMostNodes = 4e6;

/// Nodes for each point of the independent sample, and points at least.
constexpr int kNodesPerPoint = 20;
constexpr int kLeastPoints = 8;

/// Share of the points that may miss the precision: kinks of the sizes lie across cells.
constexpr double kMostOver = 0.02;
/// Standard deviations by which a sample of points may have more by chance.
constexpr double kDeviations = 3;

/// Squared lengths of a cell in units.
struct Lengths {
  double u = 0;
  double v = 0;

  void include(const Metric& metric, Uv extent) {
    u = std::max(u, metric.m11 * extent.u * extent.u);
    v = std::max(v, metric.m22 * extent.v * extent.v);
  }
};

/// How far the nodes of a cell are from linear.
struct Bends {
  double u = 0;
  double v = 0;

  double greatest() const { return std::max(u, v); }
};

/// What is known of a cell.
struct Look {
  Lengths lengths;
  Bends bends;
  double least;  ///< length of all sizes that were seen
  double miss = 0;
  /// Required and hidden points that ask for less than the cell gives, by more than the precision.
  std::vector<ControlNode> missed_places = {};
};

/// The field at a point.
struct FieldPoint {
  Uv uv;
  SizeField::Sample field;
};

/// A leaf that has not been examined, with the required points in it.
struct Waiting {
  int leaf;
  std::vector<std::size_t> points;
};

class CellSampler {
 public:
  CellSampler(const SizeField& field, ControlCells& cells, double precision)
      : field_(field),
        cells_(cells),
        tree_(cells.tree()),
        precision_(precision),
        least_units_(kLeastUnits * std::sqrt(std::min(1.0, precision / kUsualPrecision))),
        is_one_cell_(field.surface().cells().u * field.surface().cells().v == 1),
        search_(field),
        is_searched_(std::any_of(field.fields().begin(), field.fields().end(),
                                 [](const FieldSource& f) { return f.has_bounds(); })),
        first_nodes_(cells.node_count()) {}

  CellSampling run(const RunContext& context) {
    find_points();
    // Apart from the second pass, so that a finer precision begins with the same cells.
    empty_queue(context, [this](const Waiting& next) { return first_halving(next.leaf); });
    empty_queue(context, [this](const Waiting& next) { return halving(next); });
    sampling_.is_search_incomplete = is_searched_ && search_.is_exhausted();
    sampling_.precision = sample_precision(field_, cells_, precision_, least_units_, context);
    cells_.join_row_nodes(cells_.hold_points(missed_));
    return sampling_;
  }

 private:
  void find_points() {
    for (const Uv uv : field_.required_points()) points_.push_back({uv, field_.at(uv)});
    for (const Uv uv : find_hidden(field_)) points_.push_back({uv, field_.at(uv)});
  }

  /// Examine all leaves, and those that come of them.
  template <class Halving>
  void empty_queue(const RunContext& context, Halving halving) {
    std::vector<std::size_t> all(points_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<int> leaves;
    for (int index = 0; index < static_cast<int>(tree_.size()); ++index) {
      if (tree_.cell(index).is_leaf()) leaves.push_back(index);
    }
    add_waiting(leaves, all);
    for (std::size_t steps = 1; !waiting_.empty(); ++steps) {
      if (steps % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
      const Waiting next = std::move(waiting_.front());
      waiting_.pop_front();
      if (const std::optional<bool> along_u = halving(next)) halve(next, *along_u);
    }
  }

  /// Let the leaves wait, each with those of the points that lie in it.
  void add_waiting(const std::vector<int>& leaves, const std::vector<std::size_t>& points) {
    std::unordered_map<int, std::vector<std::size_t>> points_of;
    for (const std::size_t point : points) {
      points_of[tree_.find(points_[point].uv)].push_back(point);
    }
    for (const int leaf : leaves) {
      if (tree_.is_empty(tree_.cell(leaf))) continue;
      const auto found = points_of.find(leaf);
      waiting_.push_back(
          {leaf, found == points_of.end() ? std::vector<std::size_t>() : std::move(found->second)});
    }
  }

  void halve(const Waiting& cell, bool along_u) {
    if (is_full()) {
      sampling_.is_coarse = true;
      return;
    }
    cells_.halve(cell.leaf, along_u);
    std::vector<int> leaves;
    collect_leaves(cell.leaf, leaves);
    add_waiting(leaves, cell.points);
  }

  void collect_leaves(int index, std::vector<int>& leaves) const {
    const CellTree::Cell& cell = tree_.cell(index);
    if (cell.is_leaf()) {
      leaves.push_back(index);
      return;
    }
    collect_leaves(cell.first_half, leaves);
    collect_leaves(cell.first_half + 1, leaves);
  }

  /// Whether a cell is to be halved, and then if along u.
  std::optional<bool> halving(const Waiting& waiting) {
    const CellTree::Cell& cell = tree_.cell(waiting.leaf);
    Look look{lengths_of(cell), bends_of(cell), least_length(cell)};
    const bool is_more_u = look.bends.u >= look.bends.v;
    const bool is_bent = kMissPerBend * look.bends.greatest() > precision_;
    if (is_bent && is_long(waiting.leaf, look.lengths, is_more_u)) return is_more_u;
    look_inside(waiting, look);
    auto along_u = halving_by(waiting.leaf, look);
    // The search is the last thing to do: only where the cell is not halved for other reasons.
    double below = std::exp(-precision_) * look.least;
    while (!along_u && is_searched_) {
      const auto hidden = search_.find_smaller(box_of(cell), below);
      if (!hidden) break;
      look_at_place({*hidden, field_.at(*hidden)}, waiting.leaf, look);
      below = kNextSearch * std::min(below, look.least);
      along_u = halving_by(waiting.leaf, look);
    }
    if (!along_u) {
      missed_.insert(missed_.end(), look.missed_places.begin(), look.missed_places.end());
    }
    return along_u;
  }

  /// By what is known of a cell that is not long where it bends most.
  std::optional<bool> halving_by(int leaf, const Look& look) const {
    const Bends& bends = look.bends;
    if (std::max(kMissPerBend * bends.greatest(), look.miss) <= precision_) return std::nullopt;
    const bool is_first_u =
        bends.greatest() < kLeastBend ? look.lengths.u >= look.lengths.v : bends.u >= bends.v;
    const bool is_gross = look.miss > kGrossMiss * precision_;
    if (is_long(leaf, look.lengths, is_first_u)) return is_first_u;
    const bool is_worth = is_gross || std::min(bends.u, bends.v) >= kLesserBend * bends.greatest();
    if (is_worth && is_long(leaf, look.lengths, !is_first_u)) return !is_first_u;
    if (!is_gross || look.missed_places.empty()) return std::nullopt;
    const bool is_longer_u = look.lengths.u >= look.lengths.v;
    const bool is_long_here = is_longer(leaf, look.lengths, is_longer_u, kUnitsAtPlaces);
    return is_long_here ? std::optional(is_longer_u) : std::nullopt;
  }

  /// Cells of which too little is known are halved across their longer side.
  std::optional<bool> first_halving(int leaf) {
    const CellTree::Cell& cell = tree_.cell(leaf);
    const Lengths lengths = lengths_of(cell);
    const Domain domain = field_.surface().domain();
    const auto is_unknown = [&](bool along_u) {
      const double units = std::sqrt(along_u ? lengths.u : lengths.v);
      const Uv extent = tree_.extent(cell);
      const double share =
          along_u ? extent.u / (domain.u1 - domain.u0) : extent.v / (domain.v1 - domain.v0);
      const bool is_first = is_one_cell_ && kFirstSide * share > 1;
      return units > (is_first ? kLeastUnits : kLongestCell) && tree_.can_halve(leaf, along_u);
    };
    const bool is_longer_u = lengths.u >= lengths.v;
    if (is_unknown(is_longer_u)) return is_longer_u;
    if (is_unknown(!is_longer_u)) return !is_longer_u;
    return std::nullopt;
  }

  bool is_long(int leaf, const Lengths& lengths, bool along_u) const {
    return is_longer(leaf, lengths, along_u, least_units_);
  }

  bool is_longer(int leaf, const Lengths& lengths, bool along_u, double units) const {
    return (along_u ? lengths.u : lengths.v) > units * units && tree_.can_halve(leaf, along_u);
  }

  Lengths lengths_of(const CellTree::Cell& cell) {
    while (std::ssize(metrics_) < cells_.node_count()) {
      const int node = static_cast<int>(metrics_.size());
      metrics_.push_back(metric_from_size(cells_.form(node), cells_.size(node)));
    }
    Lengths lengths;
    for (const int node : cell.nodes) {
      if (node >= 0) lengths.include(metrics_[static_cast<std::size_t>(node)], tree_.extent(cell));
    }
    return lengths;
  }

  double bend(int from, int middle, int to) const {
    if (from < 0 || middle < 0 || to < 0) return 0;
    return log_conformity(cells_.size(middle), lerp(cells_.size(from), cells_.size(to), 0.5));
  }

  Bends bends_of(const CellTree::Cell& cell) const {
    Bends bends;
    for (std::size_t k = 0; k < CellTree::kLattice; ++k) {
      bends.u = std::max(bends.u, bend(cell.node(0, k), cell.node(1, k), cell.node(2, k)));
      bends.v = std::max(bends.v, bend(cell.node(k, 0), cell.node(k, 1), cell.node(k, 2)));
    }
    return bends;
  }

  /// Look at points inside a cell; their units count for its length.
  void look_inside(const Waiting& waiting, Look& look) const {
    const CellTree::Cell& cell = tree_.cell(waiting.leaf);
    const bool is_sampled_often =
        std::max(look.lengths.u, look.lengths.v) > kManySamples * kManySamples;
    for (std::size_t k = 0; k < (is_sampled_often ? kGuardShares.size() : 1); ++k) {
      const Uv guard = guard_of(cell, k);
      look_at({guard, field_.at(guard)}, waiting.leaf, look);
    }
    for (const std::size_t point : waiting.points) {
      look_at_place(points_[point], waiting.leaf, look);
    }
  }

  /// Returns the size that the cell gives there.
  SizeTensor look_at(const FieldPoint& point, int leaf, Look& look) const {
    const SizeField::Sample& exact = point.field;
    look.lengths.include(metric_from_size(exact.form, exact.size), tree_.extent(tree_.cell(leaf)));
    look.least = std::min(look.least, size_range(exact.size).least);
    const SizeTensor given = cells_.lattice_size(point.uv, leaf);
    look.miss = std::max(look.miss, log_conformity(exact.size, given));
    return given;
  }

  void look_at_place(const FieldPoint& point, int leaf, Look& look) const {
    const SizeTensor given = look_at(point, leaf, look);
    const SizeField::Sample& exact = point.field;
    if (std::log1p(greatest_growth(given, exact.size)) <= precision_) return;
    look.missed_places.push_back({point.uv, exact.point, exact.form, exact.size});
  }

  double least_length(const CellTree::Cell& cell) const {
    double least = std::numeric_limits<double>::infinity();
    for (const int node : cell.nodes) {
      if (node >= 0) least = std::min(least, size_range(cells_.size(node)).least);
    }
    return least;
  }

  UvBox box_of(const CellTree::Cell& cell) const {
    const Uv lower = tree_.at(cell, 0, 0), upper = tree_.at(cell, 1, 1);
    return {{lower.u, upper.u}, {lower.v, upper.v}};
  }

  Uv guard_of(const CellTree::Cell& cell, std::size_t k) const {
    const std::uint32_t column = cell.i0 / (cell.i1 - cell.i0), row = cell.j0 / (cell.j1 - cell.j0);
    auto [s, t] = kGuardShares[(column % 2 + 2 * (row % 2) + k) % kGuardShares.size()];
    // Below the diagonal of a cell that is cut.
    if (tree_.is_cut(cell) && s + t > 1) s = 1 - s, t = 1 - t;
    return tree_.at(cell, s, t);
  }

  /// Nodes of the cells that were there at first do not count. Metric area is measured anew when
  /// nodes have doubled.
  bool is_full() {
    const double nodes = cells_.node_count() - first_nodes_;
    if (nodes <= most_nodes_) return false;
    if (nodes < 2 * measured_at_) return true;
    measured_at_ = nodes;
    most_nodes_ = std::min(kMostNodes, surfmesh::most_nodes(metric_area()));
    return nodes > most_nodes_;
  }

  double metric_area() {
    double area = 0;
    for (int index = 0; index < static_cast<int>(tree_.size()); ++index) {
      const CellTree::Cell& cell = tree_.cell(index);
      if (!cell.is_leaf() || tree_.is_empty(cell)) continue;
      lengths_of(cell);
      const int middle = cell.node(1, 1) >= 0 ? cell.node(1, 1) : cell.node(0, 0);
      const Uv extent = tree_.extent(cell);
      area +=
          extent.u * extent.v * std::sqrt(determinant(metrics_[static_cast<std::size_t>(middle)]));
    }
    return area;
  }

  const SizeField& field_;
  ControlCells& cells_;
  const CellTree& tree_;
  double precision_;
  double least_units_;
  bool is_one_cell_;
  FieldSearch search_;
  bool is_searched_;                ///< false if no field has bounds
  std::vector<FieldPoint> points_;  ///< that cells must represent
  std::deque<Waiting> waiting_;
  std::vector<ControlNode> missed_;  ///< places that cells of the least length do not give
  std::vector<Metric> metrics_;      ///< by node
  int first_nodes_;
  double most_nodes_ = surfmesh::most_nodes(0);
  double measured_at_ = 0;  ///< nodes
  CellSampling sampling_;
};

}  // namespace

bool PrecisionSample::is_held() const {
  const double expected = kMostOver * static_cast<double>(points);
  return static_cast<double>(over) <= expected + kDeviations * std::sqrt(expected);
}

PrecisionSample& PrecisionSample::operator+=(const PrecisionSample& other) {
  asked = points == 0 ? other.asked : std::min(asked, other.asked);
  points += other.points;
  over += other.over;
  over_in_short_cells += other.over_in_short_cells;
  greatest = std::max(greatest, other.greatest);
  greatest_in_short_cells = std::max(greatest_in_short_cells, other.greatest_in_short_cells);
  return *this;
}

PrecisionSample sample_precision(const SizeField& field, const LatticeSpace& space,
                                 double precision, double short_units, const RunContext& context) {
  PrecisionSample sample;
  sample.asked = precision;
  const Domain domain = field.surface().domain();
  const int count = std::max(kLeastPoints, space.node_count() / kNodesPerPoint);
  for (int i = 1; i <= count; ++i) {
    if (static_cast<std::size_t>(i) % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
    const Uv uv = domain.fold(quasirandom_point(domain, i));
    const SizeField::Sample exact = field.at(uv);
    int cell = -1;
    const double miss = log_conformity(exact.size, space.lattice_size(uv, cell));
    Lengths lengths;
    lengths.include(metric_from_size(exact.form, exact.size), space.cell_extent(cell));
    const bool is_short = std::max(lengths.u, lengths.v) <= short_units * short_units;
    ++sample.points;
    (is_short ? sample.over_in_short_cells : sample.over) += miss > precision ? 1 : 0;
    double& greatest = is_short ? sample.greatest_in_short_cells : sample.greatest;
    greatest = std::max(greatest, miss);
  }
  return sample;
}

CellCount first_cells(const Surface& surface) {
  const CellCount cells = surface.cells();
  const CellCount first = {std::max(2, cells.u), std::max(2, cells.v)};
  if (surface.domain().shape == Domain::Shape::Rectangle) return first;
  return {std::max(first.u, first.v), std::max(first.u, first.v)};
}

CellSampling sample_cells(const SizeField& field, ControlCells& cells, double precision,
                          const RunContext& context) {
  return CellSampler(field, cells, precision).run(context);
}

}  // namespace surfmesh
