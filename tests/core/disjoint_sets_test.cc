// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/disjoint_sets.hh"

#include <gtest/gtest.h>

namespace surfmesh {
namespace {

TEST(DisjointSets, HoldOneNumberEachAtFirst) {
  DisjointSets sets(3);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, AreRepresentedByTheirLeastNumber) {
  DisjointSets sets(5);
  sets.unite(4, 2);
  sets.unite(3, 4);
  for (const std::size_t i : {2u, 3u, 4u}) EXPECT_EQ(sets.find(i), 2u) << i;
  sets.unite(2, 0);
  for (const std::size_t i : {0u, 2u, 3u, 4u}) EXPECT_EQ(sets.find(i), 0u) << i;
}

TEST(DisjointSets, LeaveOthersAlone) {
  DisjointSets sets(4);
  sets.unite(0, 1);
  EXPECT_EQ(sets.find(2), 2u);
  EXPECT_EQ(sets.find(3), 3u);
}

TEST(DisjointSets, TellWhetherTheyWereApart) {
  DisjointSets sets(3);
  EXPECT_TRUE(sets.unite(0, 1));
  EXPECT_TRUE(sets.unite(1, 2));
  EXPECT_FALSE(sets.unite(0, 2));
  EXPECT_FALSE(sets.unite(1, 1));
}

TEST(DisjointSets, FindTheLeastNumberOfALongChain) {
  constexpr std::size_t count = 1000;
  DisjointSets sets(count);
  for (std::size_t i = count - 1; i > 0; --i) sets.unite(i, i - 1);
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(sets.find(i), 0u);
}

}  // namespace
}  // namespace surfmesh
