// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/bicubic_patch.hh"

#include <fmt/format.h>

#include <cmath>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

using Point4 = Eigen::Vector4d;
using Weights = std::array<double, 4>;

/// Bernstein polynomials of degree 3.
Weights bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

Weights bernstein_first(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
}

Weights bernstein_second(double t) {
  const double s = 1 - t;
  return {6 * s, 6 * (t - 2 * s), 6 * (s - 2 * t), 6 * t};
}

/// Always inline: the calls of one evaluation share their loads of points and weights.
[[gnu::always_inline]] inline Point4 combine(const std::array<Point4, 4>& points,
                                             const Weights& w) {
  return w[0] * points[0] + w[1] * points[1] + (w[2] * points[2] + w[3] * points[3]);
}

/// A bicubic polynomial over the unit square.
class BicubicPatch : public CageSurface {
 public:
  BicubicPatch(const BicubicPolynomial& polynomial, const FaceOfCage& face)
      : polynomial_(polynomial), face_(face) {}

  Jet evaluate(Uv uv, Order order) const override {
    if (!std::isfinite(uv.u) || !std::isfinite(uv.v)) {
      throw Error(ErrorCode::Geometry,
                  fmt::format("the limit surface is not finite at ({}, {})", uv.u, uv.v));
    }
    return polynomial_.evaluate(uv, order);
  }

  CagePlace place(Uv uv) const override { return place_on(face_, uv); }

  Domain domain() const override { return {}; }

 private:
  BicubicPolynomial polynomial_;
  FaceOfCage face_;
};

}  // namespace

bool BicubicPolynomial::can_have(const Jet& corner) {
  return corner.point.allFinite() && corner.du.allFinite() && corner.dv.allFinite() &&
         corner.duv.allFinite();
}

BicubicPolynomial::BicubicPolynomial(const std::array<Jet, 4>& corners) {
  for (std::size_t c = 0; c < 4; ++c) {
    const Jet& jet = corners[c];
    if (!can_have(jet)) throw Error(ErrorCode::Geometry, "a bicubic patch is not finite");
    const bool is_right = c == 1 || c == 2;
    const bool is_upper = c >= 2;
    // From a corner inwards a step of one Bézier point is a third of the domain.
    const Vec3 du = (is_right ? -1.0 : 1.0) / 3 * jet.du;
    const Vec3 dv = (is_upper ? -1.0 : 1.0) / 3 * jet.dv;
    const Vec3 duv = (is_right == is_upper ? 1.0 : -1.0) / 9 * jet.duv;
    const std::size_t i0 = is_right ? 3 : 0, i1 = is_right ? 2 : 1;
    const std::size_t j0 = is_upper ? 3 : 0, j1 = is_upper ? 2 : 1;
    rows_[j0][i0] << jet.point, 0;
    rows_[j0][i1] << jet.point + du, 0;
    rows_[j1][i0] << jet.point + dv, 0;
    rows_[j1][i1] << jet.point + du + dv + duv, 0;
  }
}

Jet BicubicPolynomial::evaluate(Uv uv, Order order) const {
  const auto along_u = [this](const Weights& w) {
    return std::array<Point4, 4>{combine(rows_[0], w), combine(rows_[1], w), combine(rows_[2], w),
                                 combine(rows_[3], w)};
  };
  Jet jet;
  const Weights v0 = bernstein(uv.v);
  const std::array<Point4, 4> points = along_u(bernstein(uv.u));
  jet.point = combine(points, v0).head<3>();
  if (order == Order::Position) return jet;

  const Weights v1 = bernstein_first(uv.v);
  const std::array<Point4, 4> tangents = along_u(bernstein_first(uv.u));
  jet.du = combine(tangents, v0).head<3>();
  jet.dv = combine(points, v1).head<3>();
  if (order == Order::First) return jet;

  jet.duu = combine(along_u(bernstein_second(uv.u)), v0).head<3>();
  jet.duv = combine(tangents, v1).head<3>();
  jet.dvv = combine(points, bernstein_second(uv.v)).head<3>();
  return jet;
}

std::shared_ptr<const Surface> make_bicubic_patch(const std::array<Jet, 4>& corners,
                                                  const FaceOfCage& face) {
  return std::make_shared<BicubicPatch>(BicubicPolynomial(corners), face);
}

}  // namespace surfmesh
