// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "surfmesh/geometry/surface.hh"
#include "surfmesh/nurbs/nurbs_net.hh"

/// Nets of NURBS surfaces, and their slow evaluation by the definition.
namespace surfmesh::testing {

/// Knots from 0 to 1 with degree + 1 of them at both ends, `inner` ones apart by powers of i.
inline std::vector<double> clamped_knots(int degree, int spans, double power = 1) {
  std::vector<double> knots(static_cast<std::size_t>(degree), 0.0);
  for (int i = 0; i <= spans; ++i) knots.push_back(std::pow(1.0 * i / spans, power));
  knots.insert(knots.end(), static_cast<std::size_t>(degree), 1.0);
  return knots;
}

/// Knots without ends: each is there once.
inline std::vector<double> open_knots(int degree, int spans) {
  std::vector<double> knots;
  for (int i = -degree; i <= spans + degree; ++i) knots.push_back(i + 0.3 * std::sin(2.0 * i));
  return knots;
}

/// Waves over a rectangle with these knots.
inline NurbsNet wavy_net(int p, int q, std::vector<double> u, std::vector<double> v,
                         bool is_rational = false) {
  NurbsNet net{{p, q}, {std::move(u), std::move(v)}, {}, {}, {}};
  const int columns = static_cast<int>(net.knots[0].size()) - p - 1;
  const int rows = static_cast<int>(net.knots[1].size()) - q - 1;
  for (int j = 0; j < rows; ++j) {
    std::vector<Vec3>& row = net.points.emplace_back();
    std::vector<double> weights;
    for (int i = 0; i < columns; ++i) {
      row.push_back(
          {i + 0.1 * std::sin(3.0 * j), j + 0.2 * std::cos(2.0 * i), std::sin(i + j * j)});
      weights.push_back(1 + 0.5 * std::cos(i + 2 * j));
    }
    if (is_rational) net.weights.push_back(weights);
  }
  return net;
}

/// The unit sphere as a rational surface of degree 2, with poles at v = 0 and v = 1.
inline NurbsNet sphere_net(const Vec3& centre = Vec3::Zero()) {
  const double h = std::numbers::sqrt2 / 2;
  const std::vector<Vec3> circle = {{1, 0, 0},   {1, 1, 0},  {0, 1, 0},  {-1, 1, 0}, {-1, 0, 0},
                                    {-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {1, 0, 0}};
  const std::vector<double> radius = {0, 1, 1, 1, 0}, height = {-1, -1, 0, 1, 1};
  NurbsNet net{
      {2, 2},
      {{{0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1}, {0, 0, 0, 0.5, 0.5, 1, 1, 1}}},
      {},
      {},
      {}};
  for (std::size_t j = 0; j < radius.size(); ++j) {
    std::vector<Vec3>& row = net.points.emplace_back();
    std::vector<double>& weights = net.weights.emplace_back();
    for (std::size_t i = 0; i < circle.size(); ++i) {
      row.push_back(centre + radius[j] * circle[i] + height[j] * Vec3::UnitZ());
      weights.push_back((i % 2 == 1 ? h : 1) * (j % 2 == 1 ? h : 1));
    }
  }
  return net;
}

/// A strip of degree p along u and 1 along v, whose rows are these points.
inline NurbsNet strip_net(int degree, std::vector<double> knots, const std::vector<Vec3>& row) {
  NurbsNet net{{degree, 1}, {std::move(knots), {0, 0, 1, 1}}, {row, row}, {}, {}};
  for (Vec3& point : net.points[1]) point.y() += 1;
  return net;
}

/// A place in the span of x; for the end of the inner knots that is the last span before it.
inline long double place_in_span(const std::vector<double>& knots, int degree, double x) {
  const double end = knots[knots.size() - 1 - static_cast<std::size_t>(degree)];
  if (x < end) return x;
  return (*(std::lower_bound(knots.begin(), knots.end(), end) - 1) + end) / 2;
}

/// The k-th derivative of basis function i of degree p, by the definition. `place` is in the span.
inline long double basis(const std::vector<double>& knots, int i, int p, long double x, int k,
                         long double place) {
  const auto knot = [&](int at) -> long double { return knots[static_cast<std::size_t>(at)]; };
  if (p == 0) return k == 0 && knot(i) <= place && place < knot(i + 1) ? 1 : 0;
  const long double left = knot(i + p) - knot(i), right = knot(i + p + 1) - knot(i + 1);
  const auto lower = [&](int j, int derivative) {
    return basis(knots, j, p - 1, x, derivative, place);
  };
  long double sum = 0;
  if (k > 0) {
    if (left > 0) sum += p * lower(i, k - 1) / left;
    if (right > 0) sum -= p * lower(i + 1, k - 1) / right;
    return sum;
  }
  if (left > 0) sum += (x - knot(i)) / left * lower(i, 0);
  if (right > 0) sum += (knot(i + p + 1) - x) / right * lower(i + 1, 0);
  return sum;
}

/// The same at a parameter of a curve or of one direction.
inline long double basis(const std::vector<double>& knots, std::size_t i, int p, double x, int k) {
  return basis(knots, static_cast<int>(i), p, x, k, place_in_span(knots, p, x));
}

/// The derivative of order (a, b) of (wx, wy, wz, w).
inline std::array<long double, 4> slow_homogeneous(const NurbsNet& net, Uv uv, int a, int b) {
  std::array<long double, 4> sum = {};
  std::vector<long double> along;
  for (std::size_t i = 0; i < net.points[0].size(); ++i) {
    along.push_back(basis(net.knots[0], i, net.degree[0], uv.u, a));
  }
  for (std::size_t j = 0; j < net.points.size(); ++j) {
    const long double across = basis(net.knots[1], j, net.degree[1], uv.v, b);
    for (std::size_t i = 0; i < net.points[j].size(); ++i) {
      const long double weight = net.weights.empty() ? 1 : net.weights[j][i];
      for (int c = 0; c < 4; ++c) {
        const long double factor = c < 3 ? net.points[j][i][c] : 1;
        sum[static_cast<std::size_t>(c)] += along[i] * across * weight * factor;
      }
    }
  }
  return sum;
}

/// Position and derivatives by the definition and the quotient rule.
inline Jet slow_jet(const NurbsNet& net, Uv uv) {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  struct Part {
    Vector xyz;
    long double w;
  };
  const auto part = [&](int a, int b) -> Part {
    const std::array<long double, 4> sum = slow_homogeneous(net, uv, a, b);
    return {{sum[0], sum[1], sum[2]}, sum[3]};
  };
  const Part o = part(0, 0), u = part(1, 0), v = part(0, 1);
  const Part uu = part(2, 0), uv_part = part(1, 1), vv = part(0, 2);
  const Vector p = o.xyz / o.w;
  const Vector du = (u.xyz - u.w * p) / o.w, dv = (v.xyz - v.w * p) / o.w;
  const Vector duu = (uu.xyz - 2 * u.w * du - uu.w * p) / o.w;
  const Vector duv = (uv_part.xyz - u.w * dv - v.w * du - uv_part.w * p) / o.w;
  const Vector dvv = (vv.xyz - 2 * v.w * dv - vv.w * p) / o.w;
  return {p.cast<double>(),   du.cast<double>(),  dv.cast<double>(),
          duu.cast<double>(), duv.cast<double>(), dvv.cast<double>()};
}

}  // namespace surfmesh::testing
