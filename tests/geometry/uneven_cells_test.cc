// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/uneven_cells.hh"

#include <gtest/gtest.h>

namespace surfmesh {
namespace {

const UnevenCells kCells = {{0, 1, 4}, {-1, 1}};

TEST(UnevenCells, AreAsManyAsTheSpacesBetweenTheLines) {
  EXPECT_EQ(kCells.count().u, 2);
  EXPECT_EQ(kCells.count().v, 1);
}

TEST(UnevenCells, PutWholeNumbersOnTheLines) {
  EXPECT_EQ(kCells.from_cells({1, 1}), (Uv{1, 1}));
  EXPECT_EQ(kCells.from_cells({2, 0}), (Uv{4, -1}));
  EXPECT_EQ(kCells.from_cells({1.5, 0.5}), (Uv{2.5, 0}));
}

TEST(UnevenCells, ComeBackFromParameters) {
  for (const Uv uv : {Uv{0, -1}, Uv{0.3, 0.2}, Uv{1, 0}, Uv{2.2, 1}, Uv{4, 1}}) {
    const Uv back = kCells.from_cells(kCells.to_cells(uv));
    EXPECT_NEAR(back.u, uv.u, 1e-15);
    EXPECT_NEAR(back.v, uv.v, 1e-15);
  }
}

TEST(UnevenCells, GoOnBeyondTheDomain) {
  EXPECT_EQ(kCells.to_cells({5.5, 0}).u, 2.5);
  EXPECT_EQ(kCells.to_cells({-0.5, 0}).u, -0.5);
}

}  // namespace
}  // namespace surfmesh
