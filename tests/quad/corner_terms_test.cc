// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/corner_terms.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace surfmesh {
namespace {

TEST(CornerEnergy, OfAUnitSquareIsNearlyZero) {
  // The barrier takes h(1) to 1.0025.
  EXPECT_NEAR(corner_energy({2, 1}, {}), 0, 0.05);
  EXPECT_NEAR(corner_energy({2, 1}, {.size = 0.1}), 0, 0.05);
}

/// The corner of sides a and b with an angle between, in an orthonormal frame.
CornerMeasure corner(double a, double b, double angle) {
  return {a * a + b * b, a * b * std::sin(angle)};
}

constexpr double kRight = 1.5707963267948966;

TEST(CornerEnergy, IsLeastAtTheUnitSquareWhereSizeCounts) {
  const double least = corner_energy({2, 1}, {});
  for (const double a : {0.5, 0.8, 1.0, 1.3, 2.0}) {
    for (const double b : {0.5, 0.8, 1.0, 1.3, 2.0}) {
      for (const double angle : {0.3, 1.0, kRight, 2.2, 3.0, -1.0}) {
        if (a == 1 && b == 1 && angle == kRight) continue;
        EXPECT_GT(corner_energy(corner(a, b, angle), {}), least);
      }
    }
  }
}

TEST(CornerEnergy, OfAShapeIsLeastForSquares) {
  for (const double a : {0.7, 1.0, 1.5}) {
    const double least = corner_energy(corner(a, a, kRight), {.size = 0});
    for (const double ratio : {0.5, 0.8, 1.2, 2.0}) {
      EXPECT_GT(corner_energy(corner(a * ratio, a / ratio, kRight), {.size = 0}), least);
    }
    for (const double angle : {0.3, 1.0, 2.2, 3.0, -1.0}) {
      EXPECT_GT(corner_energy(corner(a, a, angle), {.size = 0}), least);
    }
  }
}

TEST(CornerEnergy, GrowsAsTheAngleLeavesTheRightOne) {
  for (const double size : {0.1, 1.0}) {
    double last = corner_energy(corner(1, 1, kRight), {.size = size});
    for (double angle = kRight - 0.1; angle > -kRight; angle -= 0.1) {
      const double energy = corner_energy(corner(1, 1, angle), {.size = size});
      EXPECT_GT(energy, last) << angle;
      last = energy;
    }
  }
}

TEST(CornerEnergy, IsFiniteForInvertedCornersAndLeadsOutOfThem) {
  EXPECT_TRUE(std::isfinite(corner_energy({2, -1}, {})));
  EXPECT_TRUE(std::isfinite(corner_energy({0, 0}, {})));
  EXPECT_GT(corner_energy({2, -1}, {}), corner_energy({2, -0.5}, {}));
  EXPECT_GT(corner_energy({2, -0.5}, {}), corner_energy({2, 0}, {}));
}

TEST(CornerEnergy, DoesNotRewardACornerOfNoSizeWhereSizeCounts) {
  for (const double size : {0.3, 0.4, 1.0}) {
    const double square = corner_energy({2, 1}, {.size = size});
    for (const double a : {0.0, 0.01, 0.1, 0.2, 0.3}) {
      EXPECT_GT(corner_energy(corner(a, a, kRight), {.size = size}), square) << a << ' ' << size;
    }
  }
}

TEST(CornerEnergy, IsSteepByItsCube) {
  const CornerMeasure sharp = corner(1, 1.2, 0.8);
  const double energy = corner_energy(sharp, {.size = 0.1});
  EXPECT_EQ(corner_energy(sharp, {.size = 0.1, .is_steep = true}),
            energy * (1 + 3 * energy * energy));
}

TEST(CornerEnergy, CountsSizeByItsWeight) {
  const double without = corner_energy({4, 2}, {.size = 0});
  const double half = corner_energy({4, 2}, {.size = 0.5});
  const double whole = corner_energy({4, 2}, {.size = 1});
  EXPECT_NEAR(whole - half, half - without, 1e-14);
  EXPECT_GT(whole, half);
}

TEST(CornerTerms, AreQuadraticInTheSumAndLinearInTheArea) {
  const CornerTerms terms{{2, 1}, 0.5, -1, 0.25, 2, 4, 1, 6};
  const CornerMeasure after = terms.after({0.5, -0.25});
  EXPECT_DOUBLE_EQ(after.s, 2 + 0.25 + 0.25 + 0.5 * (4 * 0.25 + 6 * 0.0625) - 0.125);
  EXPECT_DOUBLE_EQ(after.d, 1 + 0.125 - 0.5);
  EXPECT_EQ(terms.after({}).s, 2);
  EXPECT_EQ(terms.after({}).d, 1);
}

}  // namespace
}  // namespace surfmesh
