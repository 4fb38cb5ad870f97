// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/predicates.hh"

#include <boost/multiprecision/cpp_int.hpp>

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
  using Exact = boost::multiprecision::cpp_rational;
  const Exact cu(c.u), cv(c.v);
  const Exact determinant =
      (Exact(a.u) - cu) * (Exact(b.v) - cv) - (Exact(a.v) - cv) * (Exact(b.u) - cu);
  return determinant.sign();
}

}  // namespace surfmesh::detail
