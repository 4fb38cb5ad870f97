// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/split_at_creases.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "surfmesh/core/error.hh"
#include "surfmesh/nurbs/full_knots.hh"

namespace surfmesh {
namespace {

/// Sine of the angle between derivatives on both sides of a crease: 0.1°, less than what shows.
constexpr double kCreaseSine = 0.0017;

/// Samples of each span along a knot.
constexpr int kSamples = 4;

/// The rectangle of a domain between two values of one of its parameters, 0 for u.
Domain strip(const Domain& domain, int direction, double from, double to) {
  Domain result = domain;
  (direction == 0 ? result.u0 : result.v0) = from;
  (direction == 0 ? result.u1 : result.v1) = to;
  return result;
}

/// True if derivatives do not have the same direction. One that is 0, as at a pole, has none.
bool differ(const Vec3& a, const Vec3& b) {
  const double lengths = a.norm() * b.norm();
  if (lengths == 0) return false;
  return a.dot(b) <= 0 || a.cross(b).norm() > kCreaseSine * lengths;
}

/// True if surfaces on both sides of a line of constant u or v meet at an angle there.
bool is_crease(const NurbsSurface& before, const NurbsSurface& behind, int direction, double line) {
  const CellCount cells = before.cells();
  const int count = kSamples * (direction == 0 ? cells.v : cells.u);
  for (int i = 0; i <= count; ++i) {
    const double along = static_cast<double>(i) / kSamples;
    Uv uv = before.from_cells({along, along});
    (direction == 0 ? uv.u : uv.v) = line;
    const Jet a = before.evaluate(uv, Order::First), b = behind.evaluate(uv, Order::First);
    if (direction == 0 ? differ(a.du, b.du) : differ(a.dv, b.dv)) return true;
  }
  return false;
}

/// The ends of a domain in one direction with the creases between.
std::vector<double> crease_lines(const NurbsNet& net, const Domain& domain, int direction) {
  const auto d = static_cast<std::size_t>(direction);
  const FullKnots knots = full_knots(net.knots[d], net.degree[d], net.periodic[d]);
  const std::vector<double> lines = direction == 0 ? KnotSpans(knots, domain.u0, domain.u1).lines()
                                                   : KnotSpans(knots, domain.v0, domain.v1).lines();
  std::vector<double> result = {lines.front()};
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
    double knot = lines[i];
    if (knots.period > 0) knot -= knots.period * std::floor((knot - knots.from()) / knots.period);
    const auto equal = std::count_if(knots.knots.begin(), knots.knots.end(), [&](double other) {
      return std::abs(other - knot) <= knots.rounding();
    });
    if (equal < knots.degree) continue;
    const NurbsSurface before(net, strip(domain, direction, lines[i - 1], lines[i]));
    const NurbsSurface behind(net, strip(domain, direction, lines[i], lines[i + 1]));
    if (is_crease(before, behind, direction, lines[i])) result.push_back(lines[i]);
  }
  result.push_back(lines.back());
  return result;
}

}  // namespace

std::vector<NurbsPiece> split_at_creases(const NurbsNet& net, const Domain& domain) {
  auto whole = std::make_shared<const NurbsSurface>(net, domain);
  const std::vector<double> u = crease_lines(net, domain, 0), v = crease_lines(net, domain, 1);
  if (u.size() == 2 && v.size() == 2) return {{std::move(whole)}};
  std::vector<NurbsPiece> pieces;
  for (std::size_t j = 0; j + 1 < v.size(); ++j) {
    for (std::size_t i = 0; i + 1 < u.size(); ++i) {
      const Domain part{u[i], u[i + 1], v[j], v[j + 1]};
      pieces.push_back({std::make_shared<const NurbsSurface>(net, part), static_cast<int>(i),
                        static_cast<int>(j)});
    }
  }
  return pieces;
}

}  // namespace surfmesh
