// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/find_breaks.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "surfmesh/formula/critical_value.hh"
#include "surfmesh/formula/formula_bounds.hh"

namespace surfmesh {
namespace {

/// The box is halved so often before points are followed: 256 cells show where breaks may be.
constexpr int kCoarseHalvings = 8;

/// So many points of an operation are followed, each in at most so many steps. Without turning back
/// a point takes 80.
constexpr std::size_t kMostDescents = 8;
constexpr int kMostSteps = 600;

constexpr std::size_t kMostBounds = 8192;

/// A cell of this share of the box is a point.
constexpr double kPoint = 0x1p-44;

/// Distance of the two sides of a jump from it, as a share of the box: far above the error of the
/// point, and so near that no slope makes a difference.
constexpr double kBeside = 0x1p-30;

/// Distances at which results are infinite if they go on growing: above those at which rounding
/// makes quotients such as (1−cos(u))/u² noisy.
constexpr std::array kApproach = {0x1p-12, 0x1p-16, 0x1p-20, 0x1p-24};

/// Each of these steps is no less than this share of the one before, which is 1 for a logarithm.
constexpr double kStillGrowing = 0.9;

/// Shares of the size that count: of a jump, as contours that meet to 1e-6 count as joined, and of
/// the first step to infinity.
constexpr double kLeastJump = 1e-6;
constexpr double kLeastGrowth = 1e-2;

/// Far from the origin, what differs by less may do so by rounding, as a share of the results.
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();

/// Greatest difference of a jump as seen from its sides and at the least distance.
constexpr double kJumpChange = 0.25;

/// A segment across a jump is divided so often, by some 2^-15 in all, and not in its middle: at the
/// very point, a sign is 0, and 0/0 is no number.
constexpr double kDivision = 0.45;
constexpr int kDivisions = 16;

/// Directions are turned against the axes, along which most breaks go.
constexpr double kTurn = 0.3;
constexpr int kDirections = 8;

/// Distance along a line of constant u or v at which it is tested.
constexpr double kAlongLine = 0x1p-6;

/// Steps along the line of a jump at whose ends its height is compared, and what counts as higher.
constexpr int kStepsOnLine = 32;
constexpr double kHigher = 0x1p-20;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// The width of a side of a cell, in units of the width at which it is a point.
double breadth(const Interval& x, double span) {
  const double least = std::max(kPoint * span, 4 * kEpsilon * abs(x).upper);
  return x.width() > 0 ? x.width() / least : 0;
}

/// An operation that may break, and the cells where it may.
struct Hazard {
  const Instruction* step = nullptr;
  std::vector<UvBox> cells = {};
  bool is_settled = false;
  bool has_lines = false;         ///< it breaks along lines of constant u or v
  std::vector<Uv> harmless = {};  ///< points where it does not break, though its bounds let it
};

class Search {
 public:
  Search(const FormulaProgram& program, const BreakSearch& task);

  std::vector<FormulaBreak> run();

 private:
  void bound_cell(const UvBox& cell);
  void divide();
  bool may_break_in(const UvBox& cell);
  void follow(Hazard& hazard, std::size_t descent);
  std::optional<Uv> descend(const Hazard& hazard, const UvBox& cell);
  std::optional<double> rank(const Hazard& hazard, const UvBox& cell);
  void judge(Hazard& hazard, Uv point);

  Vec3 value(Uv uv) const;
  Uv moved(Uv from, int direction, double share) const;
  bool is_inside(Uv uv) const { return !task_.is_inside || task_.is_inside(uv); }
  bool grows_along(Uv point, int direction) const;
  bool is_infinite_at(Uv point) const;
  double jump_between(Uv a, Uv b) const;
  double jump_at(Uv point) const;
  template <class Test>
  BreakLine line_through(Uv point, Test is_break) const;
  void look_along_line(FormulaBreak& found) const;

  bool may_be_more() const;
  bool is_point(const UvBox& cell) const;
  bool is_partly_inside(const UvBox& cell) const;
  std::pair<UvBox, UvBox> halves(const UvBox& cell) const;
  bool is_on_known_line(const UvBox& cell) const;
  bool is_done() const {
    return bounds_ >= kMostBounds || found_.size() >= kMostBreaks ||
           (!found_.empty() && found_.back().is_infinite);
  }

  const FormulaProgram& program_;
  const BreakSearch& task_;
  Uv span_;  ///< of the box
  std::vector<Hazard> hazards_;
  std::vector<Interval> registers_;
  std::size_t bounds_ = 0;  ///< so many cells were bounded
  std::vector<FormulaBreak> found_;
};

Search::Search(const FormulaProgram& program, const BreakSearch& task)
    : program_(program),
      task_(task),
      span_{task.box.u.width(), task.box.v.width()},
      registers_(program.variable_count() + program.instructions().size()) {
  for (const Instruction& step : program.instructions()) {
    if (may_break(program, step)) hazards_.push_back({&step});
  }
  // A comparison often keeps a point of infinity away, and is not its cause.
  std::stable_partition(hazards_.begin(), hazards_.end(),
                        [](const Hazard& hazard) { return may_be_infinite(*hazard.step); });
}

std::vector<FormulaBreak> Search::run() {
  if (hazards_.empty()) return {};
  divide();
  for (std::size_t descent = 0; descent < kMostDescents; ++descent) {
    for (Hazard& hazard : hazards_) {
      if (is_done()) break;
      if (!hazard.is_settled) follow(hazard, descent);
    }
  }
  if (!found_.empty()) found_.back().may_be_more = may_be_more();
  return std::move(found_);
}

/// True if an operation that breaks along lines may do so along others, too.
bool Search::may_be_more() const {
  return std::ranges::any_of(hazards_, [&](const Hazard& hazard) {
    const auto is_seen = [&](const UvBox& cell) {
      return is_on_known_line(cell) || std::ranges::any_of(hazard.harmless, [&](Uv point) {
               return cell.u.contains(point.u) || cell.v.contains(point.v);
             });
    };
    return hazard.has_lines && !std::ranges::all_of(hazard.cells, is_seen);
  });
}

/// Bound all registers for parameters in a cell.
void Search::bound_cell(const UvBox& cell) {
  const std::array variables = {cell.u, cell.v};
  bound_registers(program_, std::span(variables).first(program_.variable_count()), registers_);
  ++bounds_;
}

bool Search::may_break_in(const UvBox& cell) {
  bound_cell(cell);
  return std::ranges::any_of(hazards_, [&](const Hazard& hazard) {
    return critical_value(*hazard.step, registers_).has_value();
  });
}

/// Find the cells in which operations may break.
void Search::divide() {
  std::vector<UvBox> cells{task_.box};
  for (int halving = 0; halving < kCoarseHalvings; ++halving) {
    std::vector<UvBox> smaller;
    for (const UvBox& cell : cells) {
      if (!may_break_in(cell)) continue;
      const auto [low, high] = halves(cell);
      smaller.insert(smaller.end(), {low, high});
    }
    cells = std::move(smaller);
  }
  for (const UvBox& cell : cells) {
    if (!is_partly_inside(cell)) continue;
    bound_cell(cell);
    for (Hazard& hazard : hazards_) {
      if (critical_value(*hazard.step, registers_)) hazard.cells.push_back(cell);
    }
  }
}

/// Two halves of a cell, across its broader side.
std::pair<UvBox, UvBox> Search::halves(const UvBox& cell) const {
  std::pair result(cell, cell);
  if (breadth(cell.u, span_.u) >= breadth(cell.v, span_.v)) {
    result.first.u.upper = result.second.u.lower = cell.u.middle();
  } else {
    result.first.v.upper = result.second.v.lower = cell.v.middle();
  }
  return result;
}

bool Search::is_point(const UvBox& cell) const {
  return breadth(cell.u, span_.u) <= 1 && breadth(cell.v, span_.v) <= 1;
}

/// True if the middle or a corner of a cell is inside.
bool Search::is_partly_inside(const UvBox& cell) const {
  const auto [u, v] = cell;
  return is_inside({u.middle(), v.middle()}) || is_inside({u.lower, v.lower}) ||
         is_inside({u.upper, v.lower}) || is_inside({u.upper, v.upper}) ||
         is_inside({u.lower, v.upper});
}

bool Search::is_on_known_line(const UvBox& cell) const {
  const auto reaches = [](const Interval& x, double at, double slack) {
    return x.lower - slack <= at && at <= x.upper + slack;
  };
  return std::ranges::any_of(found_, [&](const FormulaBreak& known) {
    return (known.line == BreakLine::ConstantU && reaches(cell.u, known.at.u, kBeside * span_.u)) ||
           (known.line == BreakLine::ConstantV && reaches(cell.v, known.at.v, kBeside * span_.v));
  });
}

/// Look for a break in one of the cells of an operation, which are taken from all over the box,
/// beginning in the middle.
void Search::follow(Hazard& hazard, std::size_t descent) {
  const std::size_t count = hazard.cells.size();
  if (count <= descent) return;
  const std::size_t step = std::max<std::size_t>(1, count / kMostDescents);
  const UvBox& cell = hazard.cells[(count / 2 + descent * step) % count];
  if (is_on_known_line(cell)) return;
  if (const auto point = descend(hazard, cell)) judge(hazard, *point);
}

/// A point of a cell where an operation may break for all that bounds tell.
std::optional<Uv> Search::descend(const Hazard& hazard, const UvBox& cell) {
  std::vector<UvBox> open{cell};
  for (int step = 0; step < kMostSteps && !open.empty(); ++step) {
    const UvBox box = open.back();
    open.pop_back();
    if (is_point(box)) return Uv{box.u.middle(), box.v.middle()};
    const auto [low, high] = halves(box);
    const auto rank_low = rank(hazard, low), rank_high = rank(hazard, high);
    // Equal ones by turns in each direction, which leads to the inside of the cell.
    const bool is_low_better = rank_low == rank_high ? step % 4 < 2 : rank_low < rank_high;
    if (rank_low && !is_low_better) open.push_back(low);
    if (rank_high) open.push_back(high);
    if (rank_low && is_low_better) open.push_back(low);
  }
  return {};
}

/// How far the critical value is from having its 0 in the middle; nothing if it has none.
std::optional<double> Search::rank(const Hazard& hazard, const UvBox& cell) {
  bound_cell(cell);
  const auto value = critical_value(*hazard.step, registers_);
  if (!value) return {};
  if (!std::isfinite(value->width()) || value->width() == 0) return 1;
  return std::abs(value->middle()) / value->width();
}

/// Decide by values whether there is a break at a point.
void Search::judge(Hazard& hazard, Uv point) {
  const auto is_jump = [this](Uv uv) { return jump_at(uv) > 0; };
  const auto is_infinite = [this](Uv uv) { return is_infinite_at(uv); };
  FormulaBreak found{.operation = hazard.step->operation, .at = point};
  if (is_infinite_at(point)) {
    found.is_infinite = true;
    found.line = line_through(point, is_infinite);
  } else {
    found.height = jump_at(point);
    if (found.height == 0) return hazard.harmless.push_back(point);
    found.line = line_through(point, is_jump);
    look_along_line(found);
    found.beside = moved(found.at, 0, kBeside);
  }
  hazard.is_settled = found.line == BreakLine::Other;
  hazard.has_lines |= !hazard.is_settled;
  found_.push_back(found);
}

/// The results, which may not be finite; those that do not exist are 0.
Vec3 Search::value(Uv uv) const {
  const std::array variables = {JetNumber<0>(uv.u), JetNumber<0>(uv.v)};
  std::array<JetNumber<0>, 3> results = {0.0, 0.0, 0.0};
  program_.evaluate<0>(std::span(variables).first(program_.variable_count()),
                       std::span(results).first(program_.result_count()));
  return {results[0].value(), results[1].value(), results[2].value()};
}

/// A point of the box at a share of its sides from another one.
Uv Search::moved(Uv from, int direction, double share) const {
  const double angle = kTurn + 2 * std::numbers::pi * direction / kDirections;
  const auto move = [&](double x, double part, double span, const Interval& range) {
    const double distance = std::max(share * span, 64 * kEpsilon * std::abs(x));
    return std::clamp(x + part * distance, range.lower, range.upper);
  };
  return {move(from.u, std::cos(angle), span_.u, task_.box.u),
          move(from.v, std::sin(angle), span_.v, task_.box.v)};
}

/// True if the results go on growing on the way to a point.
bool Search::grows_along(Uv point, int direction) const {
  std::array<Vec3, kApproach.size()> values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = value(moved(point, direction, kApproach[i]));
    if (values[i].hasNaN()) return false;
    if (!values[i].allFinite()) return is_inside(moved(point, direction, kApproach[i]));
  }
  Vec3 before = values[1] - values[0];
  if (!(before.norm() >= kLeastGrowth * task_.size)) return false;
  for (std::size_t i = 2; i < values.size(); ++i) {
    const Vec3 step = values[i] - values[i - 1];
    const double least = kStillGrowing * before.norm();
    if (!(step.norm() >= least && step.dot(before) >= least * before.norm())) return false;
    before = step;
  }
  return is_inside(moved(point, direction, kApproach.back()));
}

bool Search::is_infinite_at(Uv point) const {
  int count = 0;
  for (int direction = 0; direction < kDirections; ++direction) {
    if (grows_along(point, direction)) ++count;
  }
  return count >= 2;
}

/// The height of a jump between two points, found by dividing the segment; 0 if there is none.
double Search::jump_between(Uv a, Uv b) const {
  Vec3 low = value(a), high = value(b);
  const Vec3 whole = high - low;
  const double least = kLeastJump * task_.size + kRounding * low.lpNorm<Eigen::Infinity>();
  if (!(whole.norm() > least) || !is_inside(a) || !is_inside(b)) return 0;
  for (int division = 0; division < kDivisions; ++division) {
    const Uv inner = lerp(a, b, kDivision);
    const Vec3 between = value(inner);
    if (inner == a || inner == b || !between.allFinite()) break;
    const bool is_lower = (between - low).norm() > (high - between).norm();
    (is_lower ? b : a) = inner;
    (is_lower ? high : low) = between;
  }
  const double height = (high - low).norm();
  return (whole - (high - low)).norm() <= kJumpChange * height ? height : 0;
}

/// The height of a jump at a point, which has to be there in two directions; 0 if there is none.
double Search::jump_at(Uv point) const {
  int count = 0;
  double greatest = 0;
  for (int direction = 0; direction < kDirections / 2; ++direction) {
    const double height = jump_between(moved(point, direction, kBeside),
                                       moved(point, direction + kDirections / 2, kBeside));
    if (height > 0) ++count;
    greatest = std::max(greatest, height);
  }
  return count >= 2 ? greatest : 0;
}

/// The line along which a break goes on.
template <class Test>
BreakLine Search::line_through(Uv point, Test is_break) const {
  const auto goes_on = [&](double u, double v) {
    const auto is_break_at = [&](double s) {
      const Uv uv{point.u + s * u * span_.u, point.v + s * v * span_.v};
      return task_.box.u.contains(uv.u) && task_.box.v.contains(uv.v) && is_break(uv);
    };
    return is_break_at(kAlongLine) || is_break_at(-kAlongLine);
  };
  if (goes_on(0, 1)) return BreakLine::ConstantU;
  return goes_on(1, 0) ? BreakLine::ConstantV : BreakLine::Other;
}

/// Take the place where a jump is highest, of some along its line.
void Search::look_along_line(FormulaBreak& found) const {
  if (found.line == BreakLine::Other) return;
  const bool is_along_v = found.line == BreakLine::ConstantU;
  const Interval& range = is_along_v ? task_.box.v : task_.box.u;
  for (int i = 0; i <= kStepsOnLine; ++i) {
    const double s = range.lower + range.width() * i / kStepsOnLine;
    const Uv at = is_along_v ? Uv{found.at.u, s} : Uv{s, found.at.v};
    const double height = jump_at(at);
    if (height > (1 + kHigher) * found.height) {
      found.at = at;
      found.height = height;
      found.is_greatest = true;
    }
  }
}

}  // namespace

std::vector<FormulaBreak> find_breaks(const FormulaProgram& program, const BreakSearch& search) {
  return Search(program, search).run();
}

}  // namespace surfmesh
