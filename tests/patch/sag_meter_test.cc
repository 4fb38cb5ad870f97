// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/sag_meter.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/analytic.hh"

namespace surfmesh::detail {
namespace {

PatchCorner on(const Surface& surface, Uv uv) {
  const Jet jet = surface.evaluate(uv, Order::First);
  return {uv, jet.point, jet.du.cross(jet.dv)};
}

/// A square of the unit cylinder in two triangles, whose common edge runs along the axis or
/// across.
CornerTriangles square(const Surface& surface, double width, bool is_axial) {
  const PatchCorner a = on(surface, {0, 0}), b = on(surface, {width, 0});
  const PatchCorner c = on(surface, {width, 1}), d = on(surface, {0, 1});
  const PatchCorner low = on(surface, {width / 2, 0}), high = on(surface, {width / 2, 1});
  if (is_axial) return {{low, high, a}, {high, low, b}};
  return {{a, b, c}, {a, c, d}};
}

TEST(SagMeter, FindsTheSagOfAnArc) {
  const test::Cylinder cylinder(1, Domain{0, 2, 0, 1});
  const SagMeter meter(cylinder, 1e-3);
  const double width = 0.4;
  EXPECT_NEAR(meter.sag_of(square(cylinder, width, false)), 1 - std::cos(width / 2), 1e-3);
}

TEST(SagMeter, FindsNothingAtAnEdgeOnTheSurface) {
  const test::Cylinder cylinder(1, Domain{0, 2, 0, 1});
  const SagMeter meter(cylinder, 1e-3);
  EXPECT_LT(meter.ridge_sag(square(cylinder, 0.4, true)), 1e-12);
}

TEST(SagMeter, FindsTheMiddleOfAnEdgeAwayFromTheSurface) {
  const test::Cylinder cylinder(1, Domain{0, 2, 0, 1});
  const SagMeter meter(cylinder, 1e-3);
  const double width = 0.4;
  EXPECT_NEAR(meter.ridge_sag(square(cylinder, width, false)), 1 - std::cos(width / 2), 1e-3);
}

}  // namespace
}  // namespace surfmesh::detail
