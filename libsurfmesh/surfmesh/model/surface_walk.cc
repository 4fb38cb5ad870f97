// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/surface_walk.hh"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/parts.hh"
#include "surfmesh/geometry/project_to_curve.hh"

namespace surfmesh {
namespace {

/// Pieces of boundary keep so near to their curve, as a share of their length. A place counts as on
/// the boundary up to twice that.
constexpr double kStraightness = 5e-3;
constexpr double kOnBoundary = 2 * kStraightness;

/// Halvings of a curve into pieces, at most.
constexpr int kMostHalvings = 8;

/// How far beyond its ends, as a share, a piece is crossed: pieces leave no gap at corners.
constexpr double kBeyondEnd = 1e-9;

constexpr int kMostCrossings = 16;

/// Cells of the grid for each piece, about, and along each axis at most.
constexpr double kCellsPerPiece = 4;
constexpr double kMostColumns = 256;

/// Share of the product of the derivatives' lengths below which their cross product is rounding.
constexpr double kParallel = 1e-12;

double norm(Uv step) { return std::hypot(step.u, step.v); }

/// How steps of one surface are seen in another one that has the same tangent plane: by least
/// squares in space.
std::optional<StepMap> step_map(const Jet& from, const Jet& to) {
  const double e = to.du.squaredNorm(), f = to.du.dot(to.dv), g = to.dv.squaredNorm();
  const double determinant = e * g - f * f;
  if (!(determinant > kParallel * e * g)) return {};
  const auto solve = [&](const Vec3& d) {
    const double a = to.du.dot(d), b = to.dv.dot(d);
    return Uv{(g * a - f * b) / determinant, (e * b - f * a) / determinant};
  };
  const Uv u = solve(from.du), v = solve(from.dv);
  return StepMap{u.u, v.u, u.v, v.v};
}

}  // namespace

std::vector<char> smooth_contours(const Model& model, const std::vector<int>& cut_contours) {
  std::vector<char> is_smooth;
  for (const Contour& contour : model.contours) {
    is_smooth.push_back(contour.is_smooth && !contour.is_degenerate && contour.uses.size() == 2);
  }
  for (const int c : cut_contours) is_smooth[static_cast<std::size_t>(c)] = 0;
  return is_smooth;
}

SurfaceWalk::SurfaceWalk(const Model& model, std::vector<char> may_cross, Walks walks)
    : model_(model), may_cross_(std::move(may_cross)), borders_(model.patches.size()) {
  const auto is_open = [this](const LoopEntry& entry) {
    return may_cross_[static_cast<std::size_t>(entry.contour)] != 0;
  };
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    const std::vector<PatchLoop>& loops = model.patches[p].loops;
    borders_[p].is_closed = walks == Walks::FromOpenPatches &&
                            std::none_of(loops.begin(), loops.end(), [&](const PatchLoop& loop) {
                              return std::any_of(loop.begin(), loop.end(), is_open);
                            });
    if (borders_[p].is_closed) continue;
    for (const PatchLoop& loop : loops) {
      for (const LoopEntry& entry : loop) add_use(entry, borders_[p]);
    }
    borders_[p].sort_into_cells();
  }
}

void SurfaceWalk::add_use(const LoopEntry& entry, Border& border) const {
  const Curve& curve = *model_.use(entry).curve;
  const std::vector<double> ends = divided_parts(model_.contour(entry).breaks, 1);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double t0 = ends[i - 1], t1 = ends[i];
    add_pieces(curve, {curve.evaluate(t0), curve.evaluate(t1), entry, t0, t1}, kMostHalvings,
               border);
  }
}

/// Halve a piece until it is straight, and runs evenly.
void SurfaceWalk::add_pieces(const Curve& curve, const Piece& whole, int halvings,
                             Border& border) const {
  const double allowed = kStraightness * norm(whole.to - whole.from);
  bool is_straight = true;
  for (const double share : {0.25, 0.5, 0.75}) {
    const Uv at = curve.evaluate(std::lerp(whole.t_from, whole.t_to, share));
    is_straight = is_straight && norm(at - lerp(whole.from, whole.to, share)) <= allowed;
  }
  if (!is_straight && halvings > 0) {
    const double t = std::midpoint(whole.t_from, whole.t_to);
    const Uv middle = curve.evaluate(t);
    add_pieces(curve, {whole.from, middle, whole.entry, whole.t_from, t}, halvings - 1, border);
    add_pieces(curve, {middle, whole.to, whole.entry, t, whole.t_to}, halvings - 1, border);
    return;
  }
  Piece piece = whole;
  if (!model_.use(whole.entry).is_forward) {
    std::swap(piece.from, piece.to);
    std::swap(piece.t_from, piece.t_to);
  }
  border.pieces.push_back(piece);
}

std::size_t SurfaceWalk::Border::column(double u) const {
  const double position = (u - lower.u) / (upper.u - lower.u) * static_cast<double>(columns);
  return static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(columns) - 0.5));
}

std::size_t SurfaceWalk::Border::row(double v) const {
  const double position = (v - lower.v) / (upper.v - lower.v) * static_cast<double>(rows);
  return static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(rows) - 0.5));
}

/// Visit the cells of the bounding box of two points.
template <class Visit>
void SurfaceWalk::Border::for_each_cell(Uv a, Uv b, Visit visit) const {
  const std::size_t last_column = column(std::max(a.u, b.u)), last_row = row(std::max(a.v, b.v));
  for (std::size_t j = row(std::min(a.v, b.v)); j <= last_row; ++j) {
    for (std::size_t i = column(std::min(a.u, b.u)); i <= last_column; ++i) {
      visit(j * columns + i);
    }
  }
}

void SurfaceWalk::Border::sort_into_cells() {
  if (pieces.empty()) {
    first.assign(2, 0);
    return;
  }
  lower = upper = pieces.front().from;
  for (const Piece& piece : pieces) {
    lower = {std::min({lower.u, piece.from.u, piece.to.u}),
             std::min({lower.v, piece.from.v, piece.to.v})};
    upper = {std::max({upper.u, piece.from.u, piece.to.u}),
             std::max({upper.v, piece.from.v, piece.to.v})};
  }
  const double side = std::sqrt(kCellsPerPiece * static_cast<double>(pieces.size()));
  columns = rows = static_cast<std::size_t>(std::clamp(std::ceil(side), 1.0, kMostColumns));
  std::vector<std::size_t> counts(columns * rows, 0);
  for (const Piece& piece : pieces) {
    for_each_cell(piece.from, piece.to, [&](std::size_t cell) { ++counts[cell]; });
  }
  first.assign(1, 0);
  for (const std::size_t count : counts) first.push_back(first.back() + count);
  in_cells.resize(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for_each_cell(pieces[i].from, pieces[i].to,
                  [&](std::size_t cell) { in_cells[next[cell]++] = i; });
  }
}

/// Where a step first leads from the left of a piece to its right. One that begins on a piece, or
/// by rounding beyond it, leaves there at once.
SurfaceWalk::Crossing SurfaceWalk::first_crossing(const Border& border, Uv from, Uv step) const {
  Crossing first;
  border.for_each_cell(from, from + step, [&](std::size_t cell) {
    for (std::size_t k = border.first[cell]; k < border.first[cell + 1]; ++k) {
      const Piece& piece = border.pieces[border.in_cells[k]];
      const Uv side = piece.to - piece.from;
      const double leaving = surfmesh::cross(step, side);
      if (!(leaving > 0)) continue;
      const double inside = surfmesh::cross(side, from - piece.from);
      const double share = inside / leaving;
      if (share > 1 || (first.piece && share >= first.share)) continue;
      const double squared = side.u * side.u + side.v * side.v;
      if (inside < -kOnBoundary * squared) continue;
      const Uv at = from + share * step - piece.from;
      const double along = (at.u * side.u + at.v * side.v) / squared;
      if (along < -kBeyondEnd || along > 1 + kBeyondEnd) continue;
      first = {&piece, share, std::clamp(along, 0.0, 1.0)};
    }
  });
  return first;
}

/// Go on in the patch beyond a crossing.
/// Returns  the point there, and how steps are seen there
std::optional<WalkEnd> SurfaceWalk::cross(const Crossing& crossing) const {
  const Piece& piece = *crossing.piece;
  const Contour& contour = model_.contour(piece.entry);
  if (!may_cross_[static_cast<std::size_t>(piece.entry.contour)]) return {};
  const ContourUse& here = model_.use(piece.entry);
  const ContourUse& there = contour.uses[piece.entry.use == 0 ? 1 : 0];
  const double t = std::lerp(piece.t_from, piece.t_to, crossing.along);
  const Jet before = model_.surface(here).evaluate(here.curve->evaluate(t), Order::First);
  const double t_there =
      here.is_same_speed && there.is_same_speed
          ? t
          : project_to_curve(model_.surface(there), *there.curve, before.point, t);
  const Uv uv = there.curve->evaluate(t_there);
  const auto map = step_map(before, model_.surface(there).evaluate(uv, Order::First));
  if (!map) return {};
  return WalkEnd{{there.patch, uv}, *map};
}

std::optional<WalkEnd> SurfaceWalk::go(const SurfacePlace& from, Uv step) const {
  if (!std::isfinite(step.u) || !std::isfinite(step.v)) return {};
  WalkEnd end{from, {}};
  for (int crossings = 0; crossings <= kMostCrossings; ++crossings) {
    const Border& border = borders_[static_cast<std::size_t>(end.place.patch)];
    if (border.is_closed) return {};
    const Crossing crossing = first_crossing(border, end.place.uv, step);
    if (!crossing.piece) {
      end.place.uv = end.place.uv + step;
      return end;
    }
    std::optional<WalkEnd> beyond;
    try {
      beyond = cross(crossing);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::Geometry) throw;  // derivatives are infinite there
    }
    if (!beyond) return {};
    step = beyond->turn(std::min(1.0, 1 - crossing.share) * step);
    end = {beyond->place, beyond->turn.after(end.turn)};
  }
  return {};
}

}  // namespace surfmesh
