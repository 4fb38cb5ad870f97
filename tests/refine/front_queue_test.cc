// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/front_queue.hh"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace surfmesh {
namespace {

FrontQueue::Entry entry(int i) { return {FaceHandle(i), static_cast<std::uint32_t>(i)}; }

/// The faces in the order in which they leave the queue.
std::vector<int> drain(FrontQueue& queue) {
  std::vector<int> order;
  for (FrontQueue::Entry e; queue.pop(e);) order.push_back(e.face.idx());
  return order;
}

std::vector<int> order_of(const std::vector<double>& squared_radii) {
  FrontQueue queue;
  int i = 0;
  for (const double r : squared_radii) queue.push(entry(i++), r);
  return drain(queue);
}

TEST(FrontQueue, IsEmptyAtFirst) { EXPECT_TRUE(order_of({}).empty()); }

TEST(FrontQueue, GivesTheLargestFirst) {
  EXPECT_EQ(order_of({0.6, 1.2, 0.9, 1.4}), (std::vector<int>{3, 1, 2, 0}));
}

TEST(FrontQueue, GivesEqualOnesInTheOrderOfTheirArrival) {
  EXPECT_EQ(order_of({0.8, 0.8, 0.8, 0.8}), (std::vector<int>{0, 1, 2, 3}));
}

TEST(FrontQueue, TakesAllThatIsLargeAsEqual) {
  EXPECT_EQ(order_of({2, 1e300, 1.6, INFINITY}), (std::vector<int>{0, 1, 2, 3}));
}

TEST(FrontQueue, TakesATriangleWithoutARadiusAsLarge) {
  EXPECT_EQ(order_of({1, std::numeric_limits<double>::quiet_NaN(), 1.2}),
            (std::vector<int>{1, 2, 0}));
}

TEST(FrontQueue, TakesAllThatIsSmallAsEqual) {
  EXPECT_EQ(order_of({0.5, 0.1, 0, -1, 0.6}), (std::vector<int>{4, 0, 1, 2, 3}));
}

TEST(FrontQueue, GivesWhatCameLaterAndIsLargerNext) {
  FrontQueue queue;
  FrontQueue::Entry e;
  queue.push(entry(0), 0.6);
  queue.push(entry(1), 0.6);
  ASSERT_TRUE(queue.pop(e));
  queue.push(entry(2), 1.1);
  EXPECT_EQ(drain(queue), (std::vector<int>{2, 1}));
}

TEST(FrontQueue, CanBeUsedAgainAfterItWasEmpty) {
  FrontQueue queue;
  queue.push(entry(0), 1.4);
  EXPECT_EQ(drain(queue).size(), 1u);
  queue.push(entry(1), 0.7);
  EXPECT_EQ(drain(queue), (std::vector<int>{1}));
}

TEST(FrontQueue, KeepsTheStamp) {
  FrontQueue queue;
  queue.push({FaceHandle(3), 42}, 1);
  FrontQueue::Entry e;
  ASSERT_TRUE(queue.pop(e));
  EXPECT_EQ(e.stamp, 42u);
}

TEST(FrontQueue, OrdersManyToTheWidthOfABucket) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  std::vector<double> radii;
  for (int i = 0; i < 5000; ++i) radii.push_back(uniform(random));
  const std::vector<int> order = order_of(radii);
  ASSERT_EQ(order.size(), radii.size());
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    EXPECT_GT(radii[static_cast<std::size_t>(order[i])] + 1.0 / 64,
              radii[static_cast<std::size_t>(order[i + 1])]);
  }
}

}  // namespace
}  // namespace surfmesh
