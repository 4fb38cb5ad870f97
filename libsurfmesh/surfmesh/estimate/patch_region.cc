// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/estimate/patch_region.hh"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "surfmesh/delaunay/predicates.hh"

namespace surfmesh {
namespace {

constexpr int kChordsPerPart = 64;
constexpr std::size_t kMostRows = 4096;

/// Share of the domain's area that rounding may leave between it and its loop.
constexpr double kWholeShare = 1e-9;

double twice_area(const std::vector<PatchRegion::Segment>& segments) {
  double sum = 0;
  for (const auto& s : segments) sum += s.from.u * s.to.v - s.from.v * s.to.u;
  return sum;
}

double area_of(const Domain& domain) {
  const double area = (domain.u1 - domain.u0) * (domain.v1 - domain.v0);
  return domain.shape == Domain::Shape::Triangle ? 0.5 * area : area;
}

/// True if the boxes of a segment and a triangle meet and the segment's line divides the corners.
bool may_meet(const PatchRegion::Segment& s, const UvTriangle& t) {
  const auto [u0, u1] = std::minmax({t.a.u, t.b.u, t.c.u});
  const auto [v0, v1] = std::minmax({t.a.v, t.b.v, t.c.v});
  if (std::max(s.from.u, s.to.u) < u0 || std::min(s.from.u, s.to.u) > u1) return false;
  if (std::max(s.from.v, s.to.v) < v0 || std::min(s.from.v, s.to.v) > v1) return false;
  const double a = orient2d(s.from, s.to, t.a), b = orient2d(s.from, s.to, t.b),
               c = orient2d(s.from, s.to, t.c);
  return !((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0));
}

}  // namespace

PatchRegion::PatchRegion(const Model& model, int patch) {
  const Patch& own = model.patch(patch);
  const Domain domain = own.surface->domain();
  for (const PatchLoop& loop : own.loops) add_loop(model, loop);
  const double area = area_of(domain);
  is_whole_ =
      own.loops.size() == 1 && std::abs(0.5 * twice_area(segments_) - area) <= kWholeShare * area;
  if (!is_whole_) fill_rows(domain);
}

void PatchRegion::add_loop(const Model& model, const PatchLoop& loop) {
  for (const LoopEntry& entry : loop) {
    const ContourUse& use = model.use(entry);
    const int chords = kChordsPerPart * model.contour(entry).part_count;
    Uv last = use.curve->evaluate(use.is_forward ? 0 : 1);
    for (int i = 1; i <= chords; ++i) {
      const double share = double(i) / chords;
      const Uv next = use.curve->evaluate(use.is_forward ? share : 1 - share);
      segments_.push_back({last, next});
      last = next;
    }
  }
}

void PatchRegion::fill_rows(const Domain& domain) {
  rows_.resize(std::clamp<std::size_t>(segments_.size() / 4, 1, kMostRows));
  first_v_ = domain.v0;
  rows_per_v_ = static_cast<double>(rows_.size()) / (domain.v1 - domain.v0);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto [low, high] = std::minmax(segments_[i].from.v, segments_[i].to.v);
    for (std::size_t row = row_of(low); row <= row_of(high); ++row) {
      rows_[row].push_back(static_cast<int>(i));
    }
  }
}

std::size_t PatchRegion::row_of(double v) const {
  const double row = (v - first_v_) * rows_per_v_;
  return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(rows_.size() - 1)));
}

bool PatchRegion::contains(Uv uv) const {
  if (is_whole_) return true;
  bool is_inside = false;
  for (const int i : rows_[row_of(uv.v)]) {
    const Segment& s = segment(i);
    if ((s.from.v > uv.v) == (s.to.v > uv.v)) continue;
    const double u = s.from.u + (uv.v - s.from.v) / (s.to.v - s.from.v) * (s.to.u - s.from.u);
    if (u > uv.u) is_inside = !is_inside;
  }
  return is_inside;
}

std::vector<int> PatchRegion::segments_at(const UvTriangle& t) const {
  if (is_whole_) return {};
  const auto [low, high] = std::minmax({t.a.v, t.b.v, t.c.v});
  const std::size_t first = row_of(low), last = row_of(high);
  std::vector<int> found;
  for (std::size_t row = first; row <= last; ++row) {
    for (const int i : rows_[row]) {
      const Segment& s = segment(i);
      // In the list of the first of the rows that it shares with the triangle.
      const std::size_t own_first = row_of(std::min(s.from.v, s.to.v));
      if (row == std::max(first, own_first) && may_meet(s, t)) found.push_back(i);
    }
  }
  return found;
}

std::vector<int> PatchRegion::segments_at(const UvTriangle& triangle,
                                          const std::vector<int>& among) const {
  std::vector<int> found;
  std::copy_if(among.begin(), among.end(), std::back_inserter(found),
               [&](int i) { return may_meet(segment(i), triangle); });
  return found;
}

}  // namespace surfmesh
