// SPDX-License-Identifier: BSD-3-Clause
#include "support/analytic.hh"

#include <gtest/gtest.h>

#include <string>

namespace surfmesh::test {
namespace {

struct Named {
  std::string name;
  std::shared_ptr<const Surface> surface;
};

void PrintTo(const Named& named, std::ostream* out) { *out << named.name; }

class AnalyticDerivatives : public ::testing::TestWithParam<Named> {};

/// Central differences of the next lower derivative.
TEST_P(AnalyticDerivatives, AgreeWithDifferences) {
  const Surface& surface = *GetParam().surface;
  const double h = 1e-5;
  const double tolerance = 1e-8;
  for (const Uv uv : {Uv{0.3, 0.2}, Uv{0.8, 0.7}}) {
    const auto jet = [&](double du, double dv) {
      return surface.evaluate({uv.u + du, uv.v + dv}, Order::Second);
    };
    const Jet at = jet(0, 0);
    const Jet e = jet(h, 0);
    const Jet w = jet(-h, 0);
    const Jet n = jet(0, h);
    const Jet s = jet(0, -h);
    EXPECT_LT((at.du - (e.point - w.point) / (2 * h)).norm(), tolerance);
    EXPECT_LT((at.dv - (n.point - s.point) / (2 * h)).norm(), tolerance);
    EXPECT_LT((at.duu - (e.du - w.du) / (2 * h)).norm(), tolerance);
    EXPECT_LT((at.duv - (n.du - s.du) / (2 * h)).norm(), tolerance);
    EXPECT_LT((at.duv - (e.dv - w.dv) / (2 * h)).norm(), tolerance);
    EXPECT_LT((at.dvv - (n.dv - s.dv) / (2 * h)).norm(), tolerance);
  }
}

const auto kCylinder = std::make_shared<Cylinder>(1.5, Domain{});

INSTANTIATE_TEST_SUITE_P(
    All, AnalyticDerivatives,
    ::testing::Values(
        Named{"Plane", std::make_shared<PlanePatch>(Vec3(1, 2, 3), Vec3(1, 0, 1), Vec3(0, 2, 1))},
        Named{"Cylinder", kCylinder}, Named{"Cone", std::make_shared<Cone>(2.0, Domain{})},
        Named{"Sphere", std::make_shared<Sphere>(2.0, Domain{})},
        Named{"Torus", std::make_shared<Torus>(2.0, 0.5, Domain{})},
        Named{"MobiusBand", std::make_shared<MobiusBand>(2.0, Domain{})},
        Named{"Reparametrised", std::make_shared<Reparametrised>(kCylinder)},
        Named{"Placed", std::make_shared<Placed>(kCylinder, 2.0, Vec3(1, 2, 3))}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace surfmesh::test
