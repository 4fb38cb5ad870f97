// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/estimate/patch_region.hh"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "surfmesh/geometry/parts.hh"
#include "surfmesh/geometry/predicates.hh"

namespace surfmesh {
namespace {

constexpr int kRegionChordsPerPart = 64;
constexpr std::size_t kMostCells = 512;

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

PatchRegion::PatchRegion(const Model& model, int patch) : domain_(model.surface(patch).domain()) {
  const Patch& own = model.patch(patch);
  for (const PatchLoop& loop : own.loops) add_loop(model, loop);
  area_ = std::abs(0.5 * twice_area(segments_));
  const double of_domain = area_of(domain_);
  is_whole_ = own.loops.size() == 1 && std::abs(area_ - of_domain) <= kWholeShare * of_domain;
  if (!is_whole_) fill_cells();
}

void PatchRegion::add_loop(const Model& model, const PatchLoop& loop) {
  for (const LoopEntry& entry : loop) {
    const ContourUse& use = model.use(entry);
    std::vector<double> ends = divided_parts(model.contour(entry).breaks, kRegionChordsPerPart);
    if (!use.is_forward) std::reverse(ends.begin(), ends.end());
    Uv last = use.curve->evaluate(ends.front());
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const Uv next = use.curve->evaluate(ends[i]);
      segments_.push_back({last, next});
      last = next;
    }
  }
}

void PatchRegion::fill_cells() {
  const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(segments_.size())));
  side_ = std::clamp<std::size_t>(root, 1, kMostCells);
  cells_.resize(side_ * side_);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const CellRange range = cells_of({segments_[i].from, segments_[i].to});
    for (std::size_t row = range.first_row; row <= range.last_row; ++row) {
      for (std::size_t column = range.first_column; column <= range.last_column; ++column) {
        cells_[row * side_ + column].push_back(static_cast<int>(i));
      }
    }
  }
  judge_empty_cells();
}

PatchRegion::CellRange PatchRegion::cells_of(std::initializer_list<Uv> points) const {
  const auto by_u = [](Uv a, Uv b) { return a.u < b.u; };
  const auto by_v = [](Uv a, Uv b) { return a.v < b.v; };
  const auto index = [this](double x, double low, double high) {
    const double cell = (x - low) / (high - low) * static_cast<double>(side_);
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(side_ - 1)));
  };
  const auto [u0, u1] = std::minmax(points, by_u);
  const auto [v0, v1] = std::minmax(points, by_v);
  return {index(u0.u, domain_.u0, domain_.u1), index(u1.u, domain_.u0, domain_.u1),
          index(v0.v, domain_.v0, domain_.v1), index(v1.v, domain_.v0, domain_.v1)};
}

/// A cell without segments is inside or outside as a whole, and so are most of the points asked
/// for.
void PatchRegion::judge_empty_cells() {
  is_inside_.assign(cells_.size(), 0);
  for (std::size_t row = 0; row < side_; ++row) {
    for (std::size_t column = 0; column < side_; ++column) {
      if (!cell(column, row).empty()) continue;
      const double s = (static_cast<double>(column) + 0.5) / static_cast<double>(side_);
      const double t = (static_cast<double>(row) + 0.5) / static_cast<double>(side_);
      is_inside_[row * side_ + column] =
          is_left_of_odd({column, column, row, row}, domain_.at(s, t));
    }
  }
}

bool PatchRegion::contains(Uv uv) const {
  if (is_whole_) return true;
  const CellRange own = cells_of({uv});
  if (cell(own.first_column, own.first_row).empty()) {
    return is_inside_[own.first_row * side_ + own.first_column] != 0;
  }
  return is_left_of_odd(own, uv);
}

/// True if the ray from a point of a cell to greater u meets an odd number of segments.
bool PatchRegion::is_left_of_odd(const CellRange& own, Uv uv) const {
  bool is_inside = false;
  for (std::size_t column = own.first_column; column < side_; ++column) {
    for (const int i : cell(column, own.first_row)) {
      const Segment& s = segment(i);
      if ((s.from.v > uv.v) == (s.to.v > uv.v)) continue;
      // In the list of the first of its cells from here on.
      if (column != std::max(own.first_column, cells_of({s.from, s.to}).first_column)) continue;
      const double u = s.from.u + (uv.v - s.from.v) / (s.to.v - s.from.v) * (s.to.u - s.from.u);
      if (u > uv.u) is_inside = !is_inside;
    }
  }
  return is_inside;
}

std::vector<int> PatchRegion::segments_at(const UvTriangle& t) const {
  if (is_whole_) return {};
  const CellRange range = cells_of({t.a, t.b, t.c});
  std::vector<int> found;
  for (std::size_t row = range.first_row; row <= range.last_row; ++row) {
    for (std::size_t column = range.first_column; column <= range.last_column; ++column) {
      for (const int i : cell(column, row)) {
        // In the list of the first of the cells that it shares with the triangle.
        const CellRange own = cells_of({segment(i).from, segment(i).to});
        const bool is_first = row == std::max(range.first_row, own.first_row) &&
                              column == std::max(range.first_column, own.first_column);
        if (is_first && may_meet(segment(i), t)) found.push_back(i);
      }
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
