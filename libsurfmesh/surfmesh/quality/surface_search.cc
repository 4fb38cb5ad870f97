// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/surface_search.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "surfmesh/model/loop_region.hh"
#include "surfmesh/model/patch_loops.hh"

namespace surfmesh {
namespace {

/// Samples along each curve of the border of a trimmed patch.
constexpr int kBorderSamples = 32;

/// Share of its domain from which on a patch counts as whole.
constexpr double kWholeShare = 1 - 1e-9;

/// The search ends when a step is below this share of the domain.
constexpr double kSmallestStep = 1e-12;
constexpr int kMostSteps = 40;

/// Damping of singular directions, as a share of the greater one: at a pole one parameter does not
/// move the point.
constexpr double kDamping = 1e-13;

/// Nearness to the border, in shares of the domain, that counts as lying on it.
constexpr double kBorder = 1e-12;

constexpr std::size_t kCandidates = 8;

/// Samples of a patch that are farther from each other than this share of its domain are near to a
/// point for reasons of their own: on both sides of a seam.
constexpr double kElsewhere = 0.25;
constexpr int kLeastSamples = 8, kMostSamples = 320;  // along a side of a cell of a patch
constexpr double kAllSamples = 1e5;

/// The half plane n·(s,t) ≤ c of shares of the domain.
struct Border {
  double s;
  double t;
  double c;
};

constexpr std::array<Border, 4> kRectangle = {{{-1, 0, 0}, {1, 0, 1}, {0, -1, 0}, {0, 1, 1}}};
constexpr std::array<Border, 3> kTriangle = {{{-1, 0, 0}, {0, -1, 0}, {1, 1, 1}}};

/// Descends on one surface, in shares (s,t) of its domain.
class Descent {
 public:
  Descent(const Surface& surface, const Vec3& point)
      : surface_(surface), point_(point), domain_(surface.domain()) {
    if (domain_.shape == Domain::Shape::Triangle) {
      borders_.assign(kTriangle.begin(), kTriangle.end());
    } else {
      borders_.assign(kRectangle.begin(), kRectangle.end());
    }
  }

  NearPoint run(Uv guess, const SearchEnd& end) {
    start(guess);
    double share = 1;
    for (int i = 0; i < kMostSteps && distance_ > end.enough; ++i) {
      const Step step = allowed_step();
      if (step.gain <= 2 * end.accuracy * distance_ * distance_) break;
      const Uv way = share * step.way;
      if (std::abs(way.u) + std::abs(way.v) < kSmallestStep) break;
      share = try_step(way) ? std::min(1.0, 4 * share) : 0.25 * share;
    }
    NearPoint result{-1, domain_.at(at_.u, at_.v), distance_, false};
    for (const Border& border : borders_) result.is_on_border |= is_on(border);
    return result;
  }

 private:
  bool is_on(const Border& border) const {
    return border.s * at_.u + border.t * at_.v >= border.c - kBorder;
  }

  void start(Uv guess) {
    at_ = {std::clamp((guess.u - domain_.u0) / (domain_.u1 - domain_.u0), 0.0, 1.0),
           std::clamp((guess.v - domain_.v0) / (domain_.v1 - domain_.v0), 0.0, 1.0)};
    const double sum = at_.u + at_.v;
    if (domain_.shape == Domain::Shape::Triangle && sum > 1) at_ = {at_.u / sum, at_.v / sum};
    jet_ = surface_.evaluate(domain_.at(at_.u, at_.v), Order::First);
    distance_ = (point_ - jet_.point).norm();
  }

  /// A step, and what it takes off the square of the distance from the tangent plane.
  struct Step {
    Uv way{0, 0};
    double gain = 0;
  };

  /// The step to the minimum of the distance from the tangent plane, along the border if the
  /// border is in the way; 0 in a corner.
  Step allowed_step() const {
    const Vec3 ds = (domain_.u1 - domain_.u0) * jet_.du, dt = (domain_.v1 - domain_.v0) * jet_.dv;
    const Vec3 way = point_ - jet_.point;
    const double gs = ds.dot(way), gt = dt.dot(way);
    const double damping = kDamping * (ds.squaredNorm() + dt.squaredNorm());
    const double a = ds.squaredNorm() + damping, b = ds.dot(dt), c = dt.squaredNorm() + damping;
    const double determinant = a * c - b * b;
    if (!(determinant > 0)) return {};
    Uv step{(c * gs - b * gt) / determinant, (a * gt - b * gs) / determinant};
    bool is_along = false;
    for (const Border& border : borders_) {
      if (!is_on(border) || border.s * step.u + border.t * step.v <= 0) continue;
      if (is_along) return {};
      const double p = -border.t, q = border.s;  // along the border
      const double length = (p * gs + q * gt) / (p * p * a + 2 * p * q * b + q * q * c);
      step = {length * p, length * q};
      is_along = true;
    }
    if (is_along && leaves(step)) return {};
    return {step, gs * step.u + gt * step.v};
  }

  bool leaves(Uv step) const {
    return std::any_of(borders_.begin(), borders_.end(), [&](const Border& border) {
      return is_on(border) && border.s * step.u + border.t * step.v > kBorder;
    });
  }

  /// Go, up to the border at most; back if it is not nearer.
  bool try_step(Uv step) {
    double share = 1;
    for (const Border& border : borders_) {
      const double slope = border.s * step.u + border.t * step.v;
      const double room = border.c - border.s * at_.u - border.t * at_.v;
      if (slope > 0 && slope * share > room) share = std::max(room, 0.0) / slope;
    }
    const Uv next{std::clamp(at_.u + share * step.u, 0.0, 1.0),
                  std::clamp(at_.v + share * step.v, 0.0, 1.0)};
    const Jet jet = surface_.evaluate(domain_.at(next.u, next.v), Order::First);
    const double distance = (point_ - jet.point).norm();
    if (!(distance < distance_)) return false;
    at_ = next;
    jet_ = jet;
    distance_ = distance;
    return true;
  }

  const Surface& surface_;
  const Vec3& point_;
  Domain domain_;
  std::vector<Border> borders_;
  Uv at_;
  Jet jet_;
  double distance_ = 0;
};

}  // namespace

NearPoint find_near_point(const Surface& surface, const Vec3& point, Uv guess,
                          const SearchEnd& end) {
  return Descent(surface, point).run(guess, end);
}

/// The samples that are nearest to a point, in order.
struct SurfaceSearch::Candidates {
  const Vec3& point;
  const std::vector<int>& patches;
  std::array<std::pair<double, const Sample*>, kCandidates> best;
  std::size_t count = 0;

  double reach() const {
    return count < kCandidates ? std::numeric_limits<double>::infinity() : best.back().first;
  }

  void offer(const Sample& sample) {
    if (!patches.empty() &&
        std::find(patches.begin(), patches.end(), sample.patch) == patches.end()) {
      return;
    }
    const double distance = (sample.point - point).squaredNorm();
    if (distance >= reach()) return;
    std::size_t i = count < kCandidates ? count++ : kCandidates - 1;
    for (; i > 0 && best[i - 1].first > distance; --i) best[i] = best[i - 1];
    best[i] = {distance, &sample};
  }
};

namespace {

/// The loops of a patch that cut something off its domain; none if they do not.
std::vector<LoopCurves> trimming_loops(const Model& model, int patch) {
  std::vector<LoopCurves> loops = loop_curves(model, model.patch(patch));
  if (loops.size() != 1) return loops;
  const Domain domain = model.surface(patch).domain();
  const double area = (domain.u1 - domain.u0) * (domain.v1 - domain.v0) *
                      (domain.shape == Domain::Shape::Triangle ? 0.5 : 1.0);
  const bool is_whole = std::abs(0.5 * signed_area(loops.front())) >= kWholeShare * area;
  return is_whole ? std::vector<LoopCurves>() : loops;
}

}  // namespace

SurfaceSearch::SurfaceSearch(const Model& model) : model_(model), beside_(model.patches.size()) {
  for (const Contour& contour : model.contours) {
    for (const ContourUse& own : contour.uses) {
      auto& beside = beside_[static_cast<std::size_t>(own.patch)];
      for (const ContourUse& use : contour.uses) beside.push_back(use.patch);
    }
  }
  double cell_count = 0;
  for (const Patch& patch : model.patches) {
    const CellCount cells = patch.surface->cells();
    cell_count += static_cast<double>(cells.u) * cells.v;
  }
  const double share = kAllSamples / std::max(1.0, cell_count);
  const int count = std::clamp(static_cast<int>(std::sqrt(share)), kLeastSamples, kMostSamples);
  for (std::size_t p = 0; p < model.patches.size(); ++p) add_samples(static_cast<int>(p), count);
  sort_tree(0, samples_.size(), 0);
}

void SurfaceSearch::add_samples(int patch, int count) {
  const Surface& surface = model_.surface(patch);
  const std::vector<LoopCurves> loops = trimming_loops(model_, patch);
  const LoopRegions regions(loops);
  if (!loops.empty()) add_border(patch);
  const bool is_triangle = surface.domain().shape == Domain::Shape::Triangle;
  const CellCount cells = surface.cells();
  const int columns = count * cells.u, rows = count * cells.v;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      if (is_triangle && i + j > count) continue;
      const Uv uv =
          surface.from_cells({static_cast<double>(i) / count, static_cast<double>(j) / count});
      if (!loops.empty() && !regions.is_in_material(uv)) continue;
      samples_.push_back({surface.evaluate(uv, Order::Position).point, uv, patch});
    }
  }
}

/// Narrow parts of a trimmed patch may have no sample inside.
void SurfaceSearch::add_border(int patch) {
  const Surface& surface = model_.surface(patch);
  const Domain domain = surface.domain();
  for (const PatchLoop& loop : model_.patch(patch).loops) {
    for (const LoopEntry& entry : loop) {
      const Curve& curve = *model_.use(entry).curve;
      for (int i = 0; i < kBorderSamples; ++i) {
        const Uv uv = domain.clamp(curve.evaluate(static_cast<double>(i) / kBorderSamples));
        samples_.push_back({surface.evaluate(uv, Order::Position).point, uv, patch});
      }
    }
  }
}

void SurfaceSearch::sort_tree(std::size_t first, std::size_t end, int axis) {
  if (end - first < 2) return;
  const std::size_t middle = (first + end) / 2;
  const auto begin = samples_.begin();
  std::nth_element(
      begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
      begin + static_cast<std::ptrdiff_t>(end),
      [axis](const Sample& a, const Sample& b) { return a.point[axis] < b.point[axis]; });
  sort_tree(first, middle, (axis + 1) % 3);
  sort_tree(middle + 1, end, (axis + 1) % 3);
}

void SurfaceSearch::search(std::size_t first, std::size_t end, int axis,
                           Candidates& candidates) const {
  if (first >= end) return;
  const std::size_t middle = (first + end) / 2;
  candidates.offer(samples_[middle]);
  const double beyond = candidates.point[axis] - samples_[middle].point[axis];
  const int next = (axis + 1) % 3;
  if (beyond < 0) {
    search(first, middle, next, candidates);
    if (beyond * beyond < candidates.reach()) search(middle + 1, end, next, candidates);
  } else {
    search(middle + 1, end, next, candidates);
    if (beyond * beyond < candidates.reach()) search(first, middle, next, candidates);
  }
}

bool SurfaceSearch::are_beside(const Sample& a, const Sample& b) const {
  if (a.patch != b.patch) return false;
  const Domain domain = model_.surface(a.patch).domain();
  return std::abs(a.uv.u - b.uv.u) < kElsewhere * (domain.u1 - domain.u0) &&
         std::abs(a.uv.v - b.uv.v) < kElsewhere * (domain.v1 - domain.v0);
}

NearPoint SurfaceSearch::descend(const Sample& from, const Vec3& point) const {
  NearPoint found = find_near_point(model_.surface(from.patch), point, from.uv);
  found.patch = from.patch;
  return found;
}

NearPoint SurfaceSearch::nearest(const Vec3& point, const std::vector<int>& patches) const {
  Candidates candidates{point, patches, {}};
  search(0, samples_.size(), 0, candidates);
  NearPoint best;
  for (std::size_t i = 0; i < candidates.count; ++i) {
    const Sample& sample = *candidates.best[i].second;
    const auto first = candidates.best.begin();
    const bool is_tried =
        std::any_of(first, first + static_cast<std::ptrdiff_t>(i),
                    [&](const auto& candidate) { return are_beside(*candidate.second, sample); });
    if (is_tried && i > 1) continue;
    const NearPoint found = descend(sample, point);
    if (found.distance < best.distance) best = found;
  }
  return best;
}

NearPoint SurfaceSearch::nearest_around(const Vec3& point, std::span<const int> patches,
                                        double enough) const {
  NearPoint best = nearest(point);
  if (best.distance <= enough) return best;
  std::set<int> tried = {best.patch};
  std::vector<int> from(patches.begin(), patches.end());
  from.push_back(best.patch);
  while (!from.empty() && best.distance > enough) {
    std::set<int> around(from.begin(), from.end());
    for (const int patch : from) {
      const auto& beside = beside_[static_cast<std::size_t>(patch)];
      around.insert(beside.begin(), beside.end());
    }
    from.clear();
    for (const int patch : around) {
      if (!tried.insert(patch).second) continue;
      const NearPoint found = nearest(point, {patch});
      if (found.distance >= best.distance) continue;
      best = found;
      from = {patch};
      if (best.distance <= enough) break;
    }
  }
  return best;
}

std::vector<Vec3> SurfaceSearch::sample_points() const {
  std::vector<Vec3> points;
  points.reserve(samples_.size());
  for (const Sample& sample : samples_) points.push_back(sample.point);
  return points;
}

std::vector<NearPoint> SurfaceSearch::feet(const Vec3& point) const {
  const std::vector<int> all;
  Candidates candidates{point, all, {}};
  search(0, samples_.size(), 0, candidates);
  std::vector<NearPoint> feet;
  for (std::size_t i = 0; i < candidates.count; ++i) {
    feet.push_back(descend(*candidates.best[i].second, point));
  }
  std::stable_sort(feet.begin(), feet.end(),
                   [](const NearPoint& a, const NearPoint& b) { return a.distance < b.distance; });
  return feet;
}

}  // namespace surfmesh
