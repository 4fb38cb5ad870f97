// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/predicates.hh"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace surfmesh::detail {
namespace {

/// True if a − b has no rounding error.
/// Source   Knuth's two-difference
bool is_exact_difference(double a, double b) {
  const double difference = a - b;
  const double b_virtual = a - difference, a_virtual = difference + b_virtual;
  return (b_virtual - b) + (a - a_virtual) == 0;
}

int sign(double x) { return (x > 0) - (x < 0); }

/// Exact sign of w x − y z: products round monotonously, so only equal ones need their errors.
int compare_products(double w, double x, double y, double z) {
  const double left = w * x, right = y * z;
  if (left != right) return sign(left - right);
  return sign(std::fma(w, x, -left) - std::fma(y, z, -right));
}

using Integer = boost::multiprecision::cpp_int;

/// Numbers as multiples of one power of two. Rationals would be reduced after each operation, which
/// takes most of the time.
template <std::size_t n>
std::array<Integer, n> multiples(const std::array<double, n>& numbers) {
  constexpr int digits = std::numeric_limits<double>::digits;
  std::array<std::int64_t, n> mantissas{};
  std::array<int, n> exponents{};
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < n; ++i) {
    mantissas[i] =
        static_cast<std::int64_t>(std::ldexp(std::frexp(numbers[i], &exponents[i]), digits));
    if (mantissas[i] != 0) least = std::min(least, exponents[i]);
  }
  std::array<Integer, n> result;
  for (std::size_t i = 0; i < n; ++i) {
    if (mantissas[i] == 0) continue;
    result[i] = mantissas[i];
    result[i] <<= exponents[i] - least;
  }
  return result;
}

}  // namespace

int orient2d_exact(Uv a, Uv b, Uv c) {
  // An exact number cannot hold what is not finite; such a point is on no side.
  for (const double x : {a.u, a.v, b.u, b.v, c.u, c.v}) {
    if (!std::isfinite(x)) return 0;
  }
  // Points on one line of a grid: no need of exact numbers, which allocate.
  if (is_exact_difference(a.u, c.u) && is_exact_difference(a.v, c.v) &&
      is_exact_difference(b.u, c.u) && is_exact_difference(b.v, c.v)) {
    return compare_products(a.u - c.u, b.v - c.v, a.v - c.v, b.u - c.u);
  }
  const auto [au, av, bu, bv, cu, cv] = multiples<6>({a.u, a.v, b.u, b.v, c.u, c.v});
  const Integer determinant = (au - cu) * (bv - cv) - (av - cv) * (bu - cu);
  return determinant.sign();
}

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  for (const Vec3& p : {a, b, c, d}) {
    if (!p.allFinite()) return 0;
  }
  auto [ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz] = multiples<12>(
      {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z(), d.x(), d.y(), d.z()});
  for (Integer* x : {&ax, &bx, &cx}) *x -= dx;
  for (Integer* y : {&ay, &by, &cy}) *y -= dy;
  for (Integer* z : {&az, &bz, &cz}) *z -= dz;
  const Integer determinant =
      az * (cx * by - bx * cy) + bz * (ax * cy - cx * ay) + cz * (bx * ay - ax * by);
  return determinant.sign();
}

}  // namespace surfmesh::detail
