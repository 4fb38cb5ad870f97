// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/sampled_surface.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/surface_checks.hh"
#include "surfmesh/nurbs/uniform_spline.hh"

namespace surfmesh {
namespace {

/// Rounding of factors as a share of the size of the surface; each derivative multiplies it by the
/// number of cells.
constexpr double kFactorRounding = 1e-14;

/// Steps to one of the cells that samples are taken in.
constexpr std::size_t kStepsPerCell = 8;

/// A parameter in its cell.
struct Place {
  std::size_t cell;
  double s;
};

Place place_of(double x, double from, double to, std::size_t cells) {
  const double count = static_cast<double>(cells);
  const double at = (x - from) / (to - from) * count;
  const double cell = std::clamp(std::floor(at), 0., count - 1);
  return {static_cast<std::size_t>(cell), at - cell};
}

void check_grid(const PointGrid& grid) {
  if (grid.columns <= kLeastSplineCells || grid.rows <= kLeastSplineCells) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("a grid of {} x {} points: a spline through it takes {} in each "
                            "direction",
                            grid.rows, grid.columns, kLeastSplineCells + 1));
  }
  if (grid.points.size() != grid.columns * grid.rows) {
    throw Error(ErrorCode::InvalidInput, fmt::format("a grid of {} x {} has {} points", grid.rows,
                                                     grid.columns, grid.points.size()));
  }
  const auto bad = std::find_if(grid.points.begin(), grid.points.end(),
                                [](const Vec3& point) { return !point.allFinite(); });
  if (bad == grid.points.end()) return;
  const auto index = static_cast<std::size_t>(bad - grid.points.begin());
  throw Error(ErrorCode::InvalidInput, fmt::format("point [{}, {}] of the grid is not finite",
                                                   index / grid.columns, index % grid.columns));
}

/// Sum of the basis functions of one direction, with two of their derivatives.
template <class Value>
struct Sums {
  Value value;
  Value first;
  Value second;
};

template <class PointOf>
Sums<Vec3> sums_of(const SplineBasis& basis, PointOf point_of) {
  Sums<Vec3> sums{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  for (std::size_t i = 0; i < kSplineOrder; ++i) {
    const Vec3& point = point_of(i);
    sums.value += basis.value[i] * point;
    sums.first += basis.first[i] * point;
    sums.second += basis.second[i] * point;
  }
  return sums;
}

template <class PointOf>
Vec3 sum_of(const std::array<double, kSplineOrder>& weights, PointOf point_of) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < kSplineOrder; ++i) sum += weights[i] * point_of(i);
  return sum;
}

}  // namespace

SampledSurface::SampledSurface(const Domain& domain, const PointGrid& grid)
    : domain_(domain), columns_(grid.columns - 1), rows_(grid.rows - 1) {
  check(domain);
  check_grid(grid);
  if (domain.shape != Domain::Shape::Rectangle) {
    throw Error(ErrorCode::InvalidInput, "the domain of a grid is a rectangle");
  }
  Eigen::AlignedBox3d box;
  for (const Vec3& point : grid.points) box.extend(point);
  centre_ = box.center();
  make_factors(grid);
  const double size = box.diagonal().norm();
  const double per_u = static_cast<double>(columns_) / (domain_.u1 - domain_.u0);
  const double per_v = static_cast<double>(rows_) / (domain_.v1 - domain_.v0);
  noise_ = {kFactorRounding * size * per_u, kFactorRounding * size * per_v,
            kFactorRounding * size * per_u * per_u, kFactorRounding * size * per_v * per_v};
}

/// First along v, all columns at once, then along u in each row.
void SampledSurface::make_factors(const PointGrid& grid) {
  const UniformSpline along_u(columns_), along_v(rows_);
  const std::size_t width = along_u.control_count();
  std::vector<Vec3> columns(along_v.control_count() * grid.columns);
  std::transform(grid.points.begin(), grid.points.end(),
                 columns.begin() + static_cast<std::ptrdiff_t>(2 * grid.columns),
                 [this](const Vec3& point) -> Vec3 { return point - centre_; });
  along_v.solve(columns.front().data(), 3 * grid.columns);
  factors_.resize(along_v.control_count() * width);
  for (std::size_t row = 0; row < along_v.control_count(); ++row) {
    const auto from = columns.begin() + static_cast<std::ptrdiff_t>(row * grid.columns);
    Vec3* factors = factors_.data() + row * width;
    std::copy_n(from, grid.columns, factors + 2);
    along_u.solve(factors->data(), 3);
  }
}

Jet SampledSurface::evaluate(Uv uv, Order order) const {
  const Place u = place_of(uv.u, domain_.u0, domain_.u1, columns_);
  const Place v = place_of(uv.v, domain_.v0, domain_.v1, rows_);
  const SplineBasis along_u = spline_basis(u.s), along_v = spline_basis(v.s);
  const std::size_t width = columns_ + kSplineDegree;
  const Vec3* corner = factors_.data() + v.cell * width + u.cell;
  Jet jet;
  if (order == Order::Position) {
    jet.point = centre_ + sum_of(along_v.value, [&](std::size_t j) {
                  return sum_of(along_u.value, [&](std::size_t i) -> const Vec3& {
                    return corner[j * width + i];
                  });
                });
    check_finite(jet, uv, order);
    return jet;
  }
  std::array<Sums<Vec3>, kSplineOrder> rows;
  for (std::size_t j = 0; j < kSplineOrder; ++j) {
    rows[j] = sums_of(along_u, [&](std::size_t i) -> const Vec3& { return corner[j * width + i]; });
  }
  const double per_u = static_cast<double>(columns_) / (domain_.u1 - domain_.u0);
  const double per_v = static_cast<double>(rows_) / (domain_.v1 - domain_.v0);
  const auto value = [&](std::size_t j) -> const Vec3& { return rows[j].value; };
  const auto first = [&](std::size_t j) -> const Vec3& { return rows[j].first; };
  jet.point = centre_ + sum_of(along_v.value, value);
  jet.du = per_u * sum_of(along_v.value, first);
  jet.dv = per_v * sum_of(along_v.first, value);
  if (order == Order::Second) {
    jet.duu = per_u * per_u *
              sum_of(along_v.value, [&](std::size_t j) -> const Vec3& { return rows[j].second; });
    jet.duv = per_u * per_v * sum_of(along_v.first, first);
    jet.dvv = per_v * per_v * sum_of(along_v.second, value);
  }
  drop_noise(jet, order);
  check_finite(jet, uv, order);
  return jet;
}

void SampledSurface::drop_noise(Jet& jet, Order order) const {
  const auto drop = [](Vec3& derivative, double noise) {
    if (derivative.cwiseAbs().maxCoeff() <= noise) derivative.setZero();
  };
  drop(jet.du, noise_.first_u);
  drop(jet.dv, noise_.first_v);
  if (order != Order::Second) return;
  drop(jet.duu, noise_.second_u);
  drop(jet.dvv, noise_.second_v);
}

CellCount SampledSurface::cells() const {
  const auto cells = [](std::size_t steps) {
    return static_cast<int>((steps + kStepsPerCell - 1) / kStepsPerCell);
  };
  return {cells(columns_), cells(rows_)};
}

SampledCurve::SampledCurve(const std::vector<Uv>& points)
    : cells_(points.size() - 1), factors_(points.size() + kSplineDegree - 1) {
  if (points.size() <= kLeastSplineCells) {
    throw Error(ErrorCode::InvalidInput, fmt::format("{} points: a smooth curve takes {}",
                                                     points.size(), kLeastSplineCells + 1));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].u) && std::isfinite(points[i].v)) continue;
    throw Error(ErrorCode::InvalidInput, fmt::format("point {} of the curve is not finite", i));
  }
  start_ = points.front();
  end_ = points.back();
  const UniformSpline spline(cells_);
  std::copy(points.begin(), points.end(), factors_.begin() + 2);
  spline.solve(&factors_.front().u, 2);
}

Uv SampledCurve::evaluate(double t) const {
  if (t == 0) return start_;
  if (t == 1) return end_;
  const Place place = place_of(t, 0, 1, cells_);
  const SplineBasis basis = spline_basis(place.s);
  Uv sum{0, 0};
  for (std::size_t i = 0; i < kSplineOrder; ++i) {
    sum = sum + basis.value[i] * factors_[place.cell + i];
  }
  return sum;
}

}  // namespace surfmesh
