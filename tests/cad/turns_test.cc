// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/turns.hh"

#include <gtest/gtest.h>

#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Ax3.hxx>
#include <numbers>

#include "support/errors.hh"

namespace surfmesh {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::string error_with(const Geom_Surface& surface, const Domain& domain) {
  return error_of([&] { check_turns(surface, domain); });
}

TEST(CheckTurns, TakesSpringsAndThreads) {
  const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 2);
  EXPECT_EQ(error_with(*cylinder, {-100 * kTurn, 1000 * kTurn, -1e9, 1e9}), "no error");
}

TEST(CheckTurns, RefusesDomainsFarAroundASurface) {
  const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 2);
  const std::string reason = "geometry: it is 3e+06 turns away from the start of its surface";
  EXPECT_EQ(error_with(*cylinder, {0, 3e6 * kTurn, 0, 1}), reason);
  EXPECT_EQ(error_with(*cylinder, {-3e6 * kTurn, 1 - 3e6 * kTurn, 0, 1}), reason);
  const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), 3, 1);
  EXPECT_EQ(error_with(*torus, {0, 1, 0, 3e6 * kTurn}), reason);
}

TEST(CheckTurns, KnowsNoneOfSurfacesThatAreNotPeriodic) {
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Ax3());
  EXPECT_EQ(error_with(*plane, {-1e99, 1e99, -1e99, 1e99}), "no error");
}

}  // namespace
}  // namespace surfmesh
