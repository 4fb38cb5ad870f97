// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/geometry/surface.hh"
#include "surfmesh/geometry/surface_checks.hh"

namespace surfmesh {

/// The plane p(u,v) = origin + u axis_u + v axis_v; the axes need be neither unit nor orthogonal.
class PlaneSurface : public Surface {
 public:
  /// Throws   InvalidInput for an empty or infinite domain
  PlaneSurface(const Vec3& origin, const Vec3& axis_u, const Vec3& axis_v, const Domain& domain)
      : origin_(origin), axis_u_(axis_u), axis_v_(axis_v), domain_(domain) {
    check(domain);
  }

  Jet evaluate(Uv uv, Order order) const override {
    Jet jet;
    jet.point = origin_ + uv.u * axis_u_ + uv.v * axis_v_;
    if (order >= Order::First) {
      jet.du = axis_u_;
      jet.dv = axis_v_;
    }
    if (order >= Order::Second) {
      jet.duu.setZero();
      jet.duv.setZero();
      jet.dvv.setZero();
    }
    check_finite(jet, uv, order);
    return jet;
  }

  Domain domain() const override { return domain_; }

 private:
  Vec3 origin_;
  Vec3 axis_u_;
  Vec3 axis_v_;
  Domain domain_;
};

}  // namespace surfmesh
