// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/values.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "surfmesh/core/mesh.hh"

namespace surfmesh {
namespace {

TEST(Values, AreVisiblyUnsetUntilTheyAreSet) {
  EXPECT_TRUE(std::isnan(Uv().u) && std::isnan(Uv().v));
  EXPECT_TRUE(std::isnan(Metric().m11) && std::isnan(Metric().m12) && std::isnan(Metric().m22));
  EXPECT_TRUE(std::isnan(SizeTensor().h11) && std::isnan(SizeTensor().h22));
  EXPECT_TRUE(std::isnan(FirstFormFactor().l11) && std::isnan(FirstFormFactor().l22));
}

TEST(Lerp, IsExactAtBothEnds) {
  const Uv a{0.1, 1e17}, b{0.7, -3};
  EXPECT_EQ(lerp(a, b, 0), a);
  EXPECT_EQ(lerp(a, b, 1), b);
}

TEST(Cross, ChangesItsSignWithTheOrder) {
  const Uv a{0.1, 2}, b{0.7, -3};
  EXPECT_EQ(cross(a, b), -cross(b, a));
  EXPECT_EQ(cross({1, 0}, {0, 1}), 1);
}

TEST(ToOpenmesh, IsUndoneByToEigen) {
  const Vec3 p(0.1, -2, 1e300);
  EXPECT_EQ(to_eigen(to_openmesh(p)), p);
}

}  // namespace
}  // namespace surfmesh
