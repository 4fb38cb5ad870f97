// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surfmesh/geometry/surface.hh"
#include "surfmesh/geometry/uneven_cells.hh"
#include "surfmesh/nurbs/knot_spans.hh"
#include "surfmesh/nurbs/nurbs_net.hh"

namespace surfmesh {

/// A B-spline or NURBS surface, with exact derivatives.
///
/// Its cells are the knot spans. In a periodic direction it may be evaluated anywhere. At a knot,
/// derivatives are those behind it; at the end of the domain, those inside. Where a surface is a
/// point along a side (a pole), the derivatives along that are exactly 0: what remains of them by
/// rounding, below 1e-12 of the greatest one of the surface, is dropped.
///
/// Error    for degrees up to 13: points to 1e-13 of the size of the net, second derivatives to
///          1e-9 of their greatest (NurbsSurfaces.AgreeWithDeBoor)
/// Cost     an evaluation is O(product of the degrees); memory is 32 bytes times the product of the
///          orders (degree + 1) for each span
class NurbsSurface : public Surface {
 public:
  /// The whole surface: between the inner knots, or one period of them.
  /// Throws   InvalidInput as check(net)
  explicit NurbsSurface(const NurbsNet& net);

  /// The part over a rectangle, which lies between the inner knots; in a periodic direction it may
  /// lie anywhere and is at most one period long.
  /// Throws   InvalidInput as check(net), or for such a domain
  NurbsSurface(const NurbsNet& net, const Domain& domain);

  Jet evaluate(Uv uv, Order order) const override;

  Domain domain() const override { return domain_; }
  CellCount cells() const override { return cells_.count(); }
  Uv from_cells(Uv point) const override { return cells_.from_cells(point); }
  Uv to_cells(Uv uv) const override { return cells_.to_cells(uv); }

 private:
  /// Derivatives below these are rounding.
  struct Noise {
    double du = 0;
    double dv = 0;
    double duu = 0;
    double dvv = 0;
  };

  void make_polynomials(const NurbsNet& net, const FullKnots& inner, const FullKnots& outer);
  void measure_noise();
  void drop_noise(Jet& jet, Order order) const;
  template <bool is_rational, int order>
  Jet evaluate_to(Uv uv) const;
  template <bool is_rational>
  Jet evaluate_as(Uv uv, Order order) const;

  Domain domain_;
  UnevenCells cells_;
  /// Of the inner and the outer sum of powers: the inner direction is that of the greater degree.
  KnotSpans inner_;
  KnotSpans outer_;
  int inner_degree_ = 1;
  int outer_degree_ = 1;
  bool is_inner_u_ = true;
  bool is_rational_ = false;
  Vec3 centre_ = Vec3::Zero();  ///< of the points, which polynomials are relative to
  /// The factors of (wx, wy, wz, w): span by span, the powers of the inner direction run fastest.
  std::vector<Eigen::Vector4d> factors_;
  Noise noise_;
};

/// The inner knots of a net, or one period of them.
/// Throws   InvalidInput as check(net)
Domain knot_domain(const NurbsNet& net);

}  // namespace surfmesh
