// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/block_surface.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "surfmesh/cage/turn_square.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Express derivatives in the directions of the place; members that are unset stay so.
void turn_derivatives(Jet& jet, int rotation) {
  if (rotation == 0) return;
  if (rotation == 2) {
    jet.du = -jet.du;
    jet.dv = -jet.dv;
    return;
  }
  std::swap(jet.du, jet.dv);
  (rotation == 1 ? jet.dv : jet.du) *= -1;
  std::swap(jet.duu, jet.dvv);
  jet.duv = -jet.duv;
}

bool is_unit_square(const Domain& domain) {
  return domain.shape == Domain::Shape::Rectangle && domain.u0 == 0 && domain.u1 == 1 &&
         domain.v0 == 0 && domain.v1 == 1;
}

/// The number of the cell along one axis in which a parameter lies; 0 for one that is not finite.
int cell_index(double x, int count) {
  return x >= 1 ? static_cast<int>(std::min(x, count - 1.0)) : 0;
}

}  // namespace

BlockSurface::BlockSurface(int columns, std::vector<BlockCell> cells)
    : columns_(columns), rows_(0), cells_(std::move(cells)) {
  const int count = static_cast<int>(cells_.size());
  if (columns < 1 || count == 0 || count % columns != 0) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{} cells make no rectangle of {} columns", count, columns));
  }
  rows_ = count / columns;
  for (int i = 0; i < count; ++i) {
    const BlockCell& cell = cells_[static_cast<std::size_t>(i)];
    if (!cell.surface || !is_unit_square(cell.surface->domain()) || cell.rotation < 0 ||
        cell.rotation > 3) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("cell {} of a block is no surface over the unit square", i));
    }
  }
}

BlockSurface::CellPoint BlockSurface::find_cell(Uv uv) const {
  const int i = cell_index(uv.u, columns_), j = cell_index(uv.v, rows_);
  return {cells_[static_cast<std::size_t>(j * columns_ + i)],
          {static_cast<double>(i), static_cast<double>(j)}};
}

Jet BlockSurface::evaluate(Uv uv, Order order) const {
  const auto [cell, corner] = find_cell(uv);
  try {
    Jet jet = cell.surface->evaluate(into_turned_square(uv - corner, cell.rotation), order);
    turn_derivatives(jet, cell.rotation);
    return jet;
  } catch (const Error& error) {
    throw Error(error.code(),
                fmt::format("at ({}, {}) of a block of faces: {}", uv.u, uv.v, error.what()));
  }
}

CagePlace BlockSurface::place(Uv uv) const {
  const auto [cell, corner] = find_cell(uv);
  return cage_place(*cell.surface, into_turned_square(uv - corner, cell.rotation));
}

Domain BlockSurface::domain() const {
  return {0, static_cast<double>(columns_), 0, static_cast<double>(rows_)};
}

std::vector<SingularPoint> BlockSurface::singular_points() const {
  std::vector<SingularPoint> points;
  for (int j = 0; j < rows_; ++j) {
    for (int i = 0; i < columns_; ++i) {
      const BlockCell& cell = cells_[static_cast<std::size_t>(j * columns_ + i)];
      for (SingularPoint point : cell.surface->singular_points()) {
        point.at = Uv{static_cast<double>(i), static_cast<double>(j)} +
                   out_of_turned_square(point.at, cell.rotation);
        const bool is_new =
            std::none_of(points.begin(), points.end(),
                         [&](const SingularPoint& known) { return known.at == point.at; });
        if (is_new) points.push_back(point);
      }
    }
  }
  return points;
}

Uv BlockSurface::beside_roundings(Uv uv) const {
  const auto [cell, corner] = find_cell(uv);
  const Uv inside = into_turned_square(uv - corner, cell.rotation);
  const Uv beside = cell.surface->beside_roundings(inside);
  return beside == inside ? uv : corner + out_of_turned_square(beside, cell.rotation);
}

}  // namespace surfmesh
