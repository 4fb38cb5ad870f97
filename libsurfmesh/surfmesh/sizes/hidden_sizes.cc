// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/hidden_sizes.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "surfmesh/sizes/field_size.hh"

namespace surfmesh {
namespace {

/// Sample i lies at the shares i/n and (i g/n mod 1). Of the lattices with about as many points,
/// this one is nearly the densest, and its lines have none of the directions that users choose:
/// they rise by −67°, 52° and −7°. Steps of the index along them are those to the six neighbours,
/// modulo n.
constexpr int kSamples = 15'001;
constexpr int kGenerator = 6298;
constexpr std::array<int, 3> kNeighbours = {50, 81, 131};

/// Ratio of sizes below which something is hidden.
constexpr double kHiddenRatio = 0.7;

/// Starts of descents, at most one in each cell of a coarse grid, and evaluations from each.
constexpr int kDescents = 16;
constexpr int kDescentCells = 16;
constexpr int kDescentRounds = 20;

/// Logarithm of a ratio of sizes below which a sample is as low as those beside: rounding.
constexpr double kLevel = 1e-9;

/// Cells of which the lowest point is kept.
constexpr int kKeptCells = 64;

/// A sample in shares of the bounding rectangle.
struct Sample {
  double s;
  double t;
  double log_length;
  double excess = 0;  ///< of the logarithms beside over this one
};

std::pair<int, int> cell_of(const Sample& sample, int count) {
  const auto index = [count](double share) {
    return std::clamp(static_cast<int>(share * count), 0, count - 1);
  };
  return {index(sample.s), index(sample.t)};
}

/// The search in one field.
class Scan {
 public:
  Scan(const Surface& surface, const FieldSource& field)
      : surface_(surface), domain_(surface.domain()), field_(field) {}

  std::vector<Uv> hidden();

 private:
  Uv at(double s, double t) const { return domain_.fold(domain_.at(s, t)); }
  Sample sample(double s, double t) const;
  void take_samples();
  const Sample* neighbour(std::size_t index, int steps) const;
  double continued(std::size_t index, int steps) const;
  double beside(std::size_t index) const;
  std::vector<Sample> starts() const;
  Sample descend(const Sample& start) const;
  void keep(const Sample& sample);

  const Surface& surface_;
  Domain domain_;
  const FieldSource& field_;
  std::vector<Sample> samples_;
  std::map<std::pair<int, int>, Sample> kept_;
};

Sample Scan::sample(double s, double t) const {
  return {s, t, std::log(least_length(field_, surface_, at(s, t)))};
}

void Scan::take_samples() {
  for (int i = 0; i < kSamples; ++i) {
    const double whole = 0.5 + static_cast<double>((static_cast<long>(i) * kGenerator) % kSamples);
    samples_.push_back(sample((0.5 + i) / kSamples, whole / kSamples));
  }
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    samples_[i].excess = beside(i) - samples_[i].log_length;
  }
}

/// The sample `steps` of the index farther; none beyond the border of the domain.
const Sample* Scan::neighbour(std::size_t index, int steps) const {
  const auto there = (static_cast<long>(index) + steps) % kSamples;
  const Sample& sample = samples_[static_cast<std::size_t>(there < 0 ? there + kSamples : there)];
  const Sample& here = samples_[index];
  const bool is_far = std::abs(sample.s - here.s) > 0.5 || std::abs(sample.t - here.t) > 0.5;
  return is_far ? nullptr : &sample;
}

/// The logarithm that two samples on one side let expect: theirs continued, but not above the next.
double Scan::continued(std::size_t index, int steps) const {
  const Sample* next = neighbour(index, steps);
  const Sample* second = neighbour(index, 2 * steps);
  if (!next || !second) return samples_[index].log_length;
  return std::min(next->log_length, 2 * next->log_length - second->log_length);
}

/// The mean of the logarithms on both sides, in the direction in which it is greatest.
double Scan::beside(std::size_t index) const {
  double greatest = samples_[index].log_length;
  for (const int step : kNeighbours) {
    const Sample* before = neighbour(index, -step);
    const Sample* after = neighbour(index, step);
    const double expected = before && after ? 0.5 * (before->log_length + after->log_length)
                            : after         ? continued(index, step)
                                            : continued(index, -step);
    greatest = std::max(greatest, expected);
  }
  return greatest;
}

/// The samples that are lowest against those beside, without being hidden sizes themselves.
std::vector<Sample> Scan::starts() const {
  std::map<std::pair<int, int>, Sample> lowest;
  for (const Sample& sample : samples_) {
    if (!(sample.excess > kLevel) || sample.excess > -std::log(kHiddenRatio)) continue;
    const auto [entry, is_new] = lowest.emplace(cell_of(sample, kDescentCells), sample);
    if (!is_new && sample.excess > entry->second.excess) entry->second = sample;
  }
  std::vector<Sample> result;
  for (const auto& [cell, sample] : lowest) result.push_back(sample);
  std::ranges::stable_sort(result, std::ranges::greater{}, &Sample::excess);
  result.resize(std::min<std::size_t>(result.size(), kDescents));
  return result;
}

/// Go to the lowest of four points around as long as that leads downwards, then nearer, but no
/// farther than the next samples are.
Sample Scan::descend(const Sample& start) const {
  const double reach = 1 / std::sqrt(kSamples);
  const auto near = [reach](double share, double from) {
    return std::clamp(share, std::max(0.0, from - reach), std::min(1.0, from + reach));
  };
  Sample lowest = start;
  double step = 0.5 * reach;
  for (int round = 0; round < kDescentRounds; ++round) {
    const Sample from = lowest;
    for (const auto& [ds, dt] : {std::pair(step, 0.0), {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
      const Sample there = sample(near(from.s + ds, start.s), near(from.t + dt, start.t));
      if (there.log_length < lowest.log_length) lowest = there;
    }
    if (lowest.log_length == from.log_length) step *= 0.5;
  }
  lowest.excess = start.log_length - lowest.log_length;
  return lowest;
}

void Scan::keep(const Sample& sample) {
  if (sample.excess <= -std::log(kHiddenRatio)) return;
  const auto [entry, is_new] = kept_.emplace(cell_of(sample, kKeptCells), sample);
  if (!is_new && sample.log_length < entry->second.log_length) entry->second = sample;
}

std::vector<Uv> Scan::hidden() {
  take_samples();
  for (const Sample& sample : samples_) keep(sample);
  for (const Sample& start : starts()) keep(descend(start));
  std::vector<Uv> points;
  for (const auto& [cell, sample] : kept_) points.push_back(at(sample.s, sample.t));
  return points;
}

}  // namespace

std::vector<Uv> find_hidden(const SizeField& field) {
  std::vector<Uv> points;
  for (const FieldSource& source : field.fields()) {
    if (source.has_bounds()) continue;
    for (const Uv uv : Scan(field.surface(), source).hidden()) points.push_back(uv);
  }
  return points;
}

}  // namespace surfmesh
