// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/ring_sizes.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>

namespace surfmesh {
namespace {

/// How many chords measure a line. Formulas may hold more than a cell of a cage.
struct Chords {
  int around;    ///< at least, over all patches
  int per_cell;  ///< at least
};

constexpr Chords kMeasured{32, 8};

/// Enough to see that a line is long.
constexpr Chords kFew{8, 1};

constexpr int kLinesPerCell = 4;
constexpr int kLeastLines = 32;

/// Patches around a tube that are helped: more have a segment each, and are not flat together.
constexpr std::size_t kMostPatchesAround = 8;

/// Least size around a ring as a share of hmin: where a tube is pinched to a point, longer elements
/// could not be told from degenerate ones.
constexpr double kLeastShare = 1e-7;

/// A line shorter than this share of the longest one is a point.
constexpr double kRingPoleShare = 1e-6;

/// Near a pole the length of lines is like that of a V, or flatter. A line between two others that
/// is longer than this share of their sum is near none.
constexpr double kShareBesidePole = 0.3;
constexpr int kBisections = 50;

/// Sizes of up to this share of its radius leave a round tube eight elements around.
constexpr double kRoundFactor = std::numbers::pi / 4;

/// A size from sag is √(8 sag r) on a tube of radius r: eight elements are around where a quarter
/// of the ring is at least this many sags long.
constexpr double kRoundSags = 20;

/// Tubes that are not round have sides with larger sizes.
constexpr double kOvalMargin = 2;

/// A patch that lines run across, from one contour to the one on the opposite side.
struct Crossing {
  const Surface* surface;
  bool is_along_u;
  const ContourUse* entry;
  const ContourUse* exit;
};

struct Side {
  Uv start;
  Uv end;
};

Side side_of(const ContourUse& use) { return {use.curve->evaluate(0), use.curve->evaluate(1)}; }

/// The coordinate across lines, at t on a side.
double across(const ContourUse& use, double t, bool is_along_u) {
  const Side side = side_of(use);
  return is_along_u ? (1 - t) * side.start.v + t * side.end.v
                    : (1 - t) * side.start.u + t * side.end.u;
}

/// The t at which a side has this coordinate.
double parameter(const ContourUse& use, double coordinate, bool is_along_u) {
  const double start = across(use, 0, is_along_u), end = across(use, 1, is_along_u);
  return (coordinate - start) / (end - start);
}

/// True if two uses lie on opposite sides, across from each other; `is_along_u` if lines of
/// constant v run between them.
bool are_opposite(const Domain& domain, const ContourUse& a, const ContourUse& b, bool is_along_u) {
  const Side on_a = side_of(a), on_b = side_of(b);
  const auto along = [&](Uv uv) { return is_along_u ? uv.u : uv.v; };
  const double low = is_along_u ? domain.u0 : domain.v0, high = is_along_u ? domain.u1 : domain.v1;
  const double of_a = along(on_a.start), of_b = along(on_b.start);
  if (along(on_a.end) != of_a || along(on_b.end) != of_b) return false;
  if (std::min(of_a, of_b) != low || std::max(of_a, of_b) != high) return false;
  const auto range = [&](const ContourUse& use) {
    return std::minmax({across(use, 0, is_along_u), across(use, 1, is_along_u)});
  };
  return range(a) == range(b);
}

std::optional<Crossing> crossing_between(const Model& model, const ContourUse& a,
                                         const ContourUse& b) {
  const Surface& surface = model.surface(a);
  if (surface.domain().shape == Domain::Shape::Triangle) return std::nullopt;
  for (const bool is_along_u : {true, false}) {
    if (are_opposite(surface.domain(), a, b, is_along_u)) {
      return Crossing{&surface, is_along_u, &a, &b};
    }
  }
  return std::nullopt;
}

/// Length of the part of a line in one patch.
double length_across(const Crossing& crossing, double coordinate, int chords) {
  const Domain domain = crossing.surface->domain();
  const auto point = [&](int i) {
    const Uv on = domain.at(double(i) / chords, double(i) / chords);
    const Uv uv = crossing.is_along_u ? Uv{on.u, coordinate} : Uv{coordinate, on.v};
    return crossing.surface->evaluate(uv, Order::Position).point;
  };
  double length = 0;
  Vec3 last = point(0);
  for (int i = 1; i <= chords; ++i) {
    const Vec3 next = point(i);
    length += (next - last).norm();
    last = next;
  }
  return length;
}

/// The value at a fractional index.
double interpolate(const std::vector<double>& values, double at) {
  const double last = static_cast<double>(values.size() - 1);
  const auto i = static_cast<std::size_t>(std::clamp(at, 0.0, last - 1));
  const double share = at - static_cast<double>(i);
  return (1 - share) * values[i] + share * values[i + 1];
}

/// True if the lines around this one may meet in a point beside it.
bool is_near_pole(const std::vector<double>& lengths, std::size_t i) {
  const double before = lengths[i - 1], after = lengths[i + 1];
  return lengths[i] <= std::min(before, after) && lengths[i] != after &&
         lengths[i] <= kShareBesidePole * (before + after);
}

/// The fractional index at which growing values reach `value`.
double find(const std::vector<double>& values, double value) {
  const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, value);
  const double low = *(above - 1), high = *above;
  const double share = high > low ? (value - low) / (high - low) : 0;
  return static_cast<double>(above - 1 - values.begin()) + share;
}

bool has_several_cells(const std::vector<Crossing>& crossings) {
  return std::any_of(crossings.begin(), crossings.end(), [](const Crossing& c) {
    return c.surface->cells().u * c.surface->cells().v > 1;
  });
}

/// Finds the patches around a tube, and measures its rings.
class Tube {
 public:
  Tube(const Model& model, const LoopEntry& start) : model_(model) { follow(start); }

  /// True if lines through the contour of the start come back to it.
  bool is_closed() const { return is_closed_; }

  /// False if all lines are at least this long. Takes few evaluations.
  bool may_be_shorter_than(double length) const;

  Ring measure() const;

 private:
  std::optional<Crossing> cross(const LoopEntry& entry, LoopEntry& exit) const;
  void follow(const LoopEntry& start);
  double returned_parameter(double t) const;
  double line_length(double t, const Chords& chords) const;
  Ring lines() const;
  double parameter_at(const Ring& ring, double line) const;
  void find_poles(Ring& ring) const;

  const Model& model_;
  std::vector<Crossing> crossings_;
  bool is_closed_ = false;
};

/// Go on from a contour through the patch of its use to the opposite one.
std::optional<Crossing> Tube::cross(const LoopEntry& entry, LoopEntry& exit) const {
  const ContourUse& use = model_.use(entry);
  for (const LoopEntry& other : model_.patch(use).loops.front()) {
    if (other.contour == entry.contour && other.use == entry.use) continue;
    if (model_.contour(other).is_degenerate) continue;
    if (auto found = crossing_between(model_, use, model_.use(other))) {
      exit = other;
      return found;
    }
  }
  return std::nullopt;
}

void Tube::follow(const LoopEntry& start) {
  LoopEntry entry = start;
  while (crossings_.size() < kMostPatchesAround) {
    if (model_.contour(entry).uses.size() != 2) return;
    LoopEntry exit;
    const auto crossing = cross(entry, exit);
    if (!crossing) return;
    crossings_.push_back(*crossing);
    // Measuring the tubes of all blocks of a cage takes more evaluations than meshing it.
    if (crossings_.size() > 1 && has_several_cells(crossings_)) return;
    entry = {exit.contour, 1 - exit.use};
    if (entry.contour != start.contour) continue;
    // Lines around a Möbius band come back elsewhere.
    is_closed_ = entry.use == start.use && returned_parameter(0) < 0.5;
    return;
  }
}

/// The t at which a line comes back that starts at this t of the first contour.
double Tube::returned_parameter(double t) const {
  for (const Crossing& c : crossings_) {
    t = parameter(*c.exit, across(*c.entry, t, c.is_along_u), c.is_along_u);
  }
  return t;
}

/// Length of the closed line that starts at this t of the first contour.
double Tube::line_length(double t, const Chords& chords) const {
  const int patches = static_cast<int>(crossings_.size());
  double length = 0;
  for (const Crossing& c : crossings_) {
    const double coordinate = across(*c.entry, t, c.is_along_u);
    const CellCount cells = c.surface->cells();
    const int of_cells = chords.per_cell * (c.is_along_u ? cells.u : cells.v);
    length += length_across(c, coordinate, std::max(chords.around / patches, of_cells));
    t = parameter(*c.exit, coordinate, c.is_along_u);
  }
  return length;
}

/// The t of the first contour at a fractional index of a ring's lines.
double Tube::parameter_at(const Ring& ring, double line) const {
  const Crossing& first = crossings_.front();
  const double share = line / static_cast<double>(ring.lengths.size() - 1);
  return parameter(*first.entry, (1 - share) * ring.from + share * ring.to, first.is_along_u);
}

/// The lines to be measured.
Ring Tube::lines() const {
  const Crossing& first = crossings_.front();
  const double a = across(*first.entry, 0, first.is_along_u);
  const double b = across(*first.entry, 1, first.is_along_u);
  const CellCount cells = first.surface->cells();
  const int lines = std::max(kLeastLines, kLinesPerCell * (first.is_along_u ? cells.v : cells.u));
  Ring ring{first.is_along_u, std::min(a, b), std::max(a, b), {}};
  ring.lengths.resize(static_cast<std::size_t>(lines) + 1);
  return ring;
}

bool Tube::may_be_shorter_than(double length) const {
  Ring ring = lines();
  auto& lengths = ring.lengths;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    lengths[i] = line_length(parameter_at(ring, static_cast<double>(i)), kFew);
    if (lengths[i] < length) return true;
    if (i > 1 && is_near_pole(lengths, i - 1)) return true;
  }
  return false;
}

Ring Tube::measure() const {
  const Crossing& first = crossings_.front();
  Ring ring = lines();
  double distance = 0;
  Vec3 last = model_.point(*first.entry, parameter_at(ring, 0));
  for (std::size_t i = 0; i < ring.lengths.size(); ++i) {
    const double t = parameter_at(ring, static_cast<double>(i));
    const Vec3 point = model_.point(*first.entry, t);
    distance += (point - last).norm();
    last = point;
    ring.lengths[i] = line_length(t, kMeasured);
    ring.distances.push_back(distance);
  }
  find_poles(ring);
  return ring;
}

/// Find the lines that are points among those of least length.
void Tube::find_poles(Ring& ring) const {
  const auto& lengths = ring.lengths;
  const double small = kRingPoleShare * *std::max_element(lengths.begin(), lengths.end());
  const std::size_t last = lengths.size() - 1;
  const auto length_at = [&](double line) {
    return line_length(parameter_at(ring, line), kMeasured);
  };
  if (lengths[0] <= small) ring.poles.push_back(0);
  for (std::size_t i = 1; i < last; ++i) {
    if (!is_near_pole(lengths, i)) continue;
    double low = static_cast<double>(i - 1), high = static_cast<double>(i + 1);
    for (int k = 0; k < kBisections; ++k) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      const bool is_first = length_at(a) < length_at(b);
      (is_first ? high : low) = is_first ? b : a;
    }
    const double line = 0.5 * (low + high);
    if (length_at(line) > small) continue;
    ring.poles.push_back(interpolate(ring.distances, line));
  }
  if (lengths[last] <= small) ring.poles.push_back(ring.distances.back());
}

}  // namespace

double Ring::length_at(Uv uv, double element_length) const {
  const double coordinate = is_along_u ? uv.v : uv.u;
  if (coordinate < from || coordinate > to) return std::numeric_limits<double>::infinity();
  double at = (coordinate - from) / (to - from) * static_cast<double>(lengths.size() - 1);
  if (!poles.empty()) {
    const double whole = distances.back();
    const double reach = std::min(element_length, 0.5 * whole);
    double distance = interpolate(distances, at);
    for (const double pole : poles) {
      if (std::abs(distance - pole) >= reach) continue;
      const bool is_after = distance > pole || pole == 0;
      distance = std::clamp(is_after ? pole + reach : pole - reach, 0.0, whole);
    }
    at = find(distances, distance);
  }
  return interpolate(lengths, at);
}

double greatest_ring(const ResolvedSizing& sizing) {
  double greatest = sizing.bounds.hmax;
  if (sizing.curvature > 0 && sizing.curvature <= kRoundFactor) {
    greatest = std::min(greatest, kOvalMargin * sizing.bounds.hmin);
  }
  if (sizing.sag > 0) {
    greatest =
        std::min(greatest, std::max(kOvalMargin * sizing.bounds.hmin, kRoundSags * sizing.sag));
  }
  return kUnitsAround * greatest;
}

std::vector<Ring> short_rings(const Model& model, int patch, double greatest) {
  const Patch& own = model.patch(patch);
  std::vector<Ring> rings;
  for (const LoopEntry& entry : own.loops.front()) {
    if (model.contour(entry).is_degenerate) continue;
    const Tube tube(model, entry);
    if (!tube.is_closed() || !tube.may_be_shorter_than(greatest)) continue;
    Ring ring = tube.measure();
    // A line across is met at both of its ends.
    const auto is_same = [&](const Ring& other) {
      return other.is_along_u == ring.is_along_u && other.from == ring.from && other.to == ring.to;
    };
    if (std::any_of(rings.begin(), rings.end(), is_same)) continue;
    const double least = *std::min_element(ring.lengths.begin(), ring.lengths.end());
    if (least >= greatest && ring.poles.empty()) continue;
    rings.push_back(std::move(ring));
  }
  return rings;
}

double size_around(double ring_length, const SizeBounds& bounds) {
  return std::clamp(ring_length / kUnitsAround, kLeastShare * bounds.hmin, bounds.hmax);
}

}  // namespace surfmesh
