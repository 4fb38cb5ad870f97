// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/predicates.hh"

#include <boost/multiprecision/cpp_int.hpp>

namespace surfmesh::detail {

int orient2d_exact(Uv a, Uv b, Uv c) {
  // An exact number cannot hold what is not finite; such a point is on no side.
  for (const double x : {a.u, a.v, b.u, b.v, c.u, c.v}) {
    if (!std::isfinite(x)) return 0;
  }
  using Exact = boost::multiprecision::cpp_rational;
  const Exact cu(c.u), cv(c.v);
  const Exact determinant =
      (Exact(a.u) - cu) * (Exact(b.v) - cv) - (Exact(a.v) - cv) * (Exact(b.u) - cu);
  return determinant.sign();
}

}  // namespace surfmesh::detail
