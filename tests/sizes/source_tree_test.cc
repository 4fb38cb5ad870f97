// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/source_tree.hh"

#include <gtest/gtest.h>

#include <random>

#include "support/tensors.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

class RandomPlaces {
 public:
  double operator()(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  Vec3 point() { return {(*this)(0, 1), (*this)(0, 1), (*this)(0, 0.1)}; }

 private:
  std::mt19937 engine_{1};
};

std::vector<PlacedSize> random_sizes(int count, bool is_isotropic) {
  RandomPlaces random;
  std::vector<PlacedSize> sizes;
  for (int i = 0; i < count; ++i) {
    PlacedSize placed;
    placed.from = random.point();
    placed.to = i % 2 == 0 ? placed.from : random.point();
    const double size = random(0.01, 0.3);
    placed.at_from = {size, is_isotropic ? size : random(0.01, 0.3)};
    placed.at_to = placed.at_from;
    placed.radius = random(0, 0.1);
    sizes.push_back(placed);
  }
  return sizes;
}

TangentFrame random_place(RandomPlaces& random) {
  return {random.point(), Vec3::UnitX(), Vec3::UnitY()};
}

TEST(SourceTree, GivesTheLeastOfAllIsotropicSizes) {
  const auto sizes = random_sizes(300, true);
  for (const double grade : {0.0, 1.0, 1.5}) {
    const SourceTree tree(sizes, grade);
    RandomPlaces random;
    for (int i = 0; i < 200; ++i) {
      const TangentFrame place = random_place(random);
      double least = 0.5;
      for (const PlacedSize& placed : sizes) {
        const auto size = size_around(placed, place, growth_of_grade(grade));
        if (size) least = std::min(least, size->h11);
      }
      testing::expect_near(tree.minimum_at(place, isotropic(0.5)), isotropic(least), 1e-9);
    }
  }
}

TEST(SourceTree, IsNoLargerThanAnySize) {
  const auto sizes = random_sizes(100, false);
  const SourceTree tree(sizes, 1.5);
  RandomPlaces random;
  for (int i = 0; i < 100; ++i) {
    const TangentFrame place = random_place(random);
    const SizeTensor found = tree.minimum_at(place, isotropic(0.5));
    for (const PlacedSize& placed : sizes) {
      const SizeTensor size = *size_around(placed, place, growth_of_grade(1.5));
      EXPECT_LE(log_conformity(minimum(found, size), found), 1e-6);
    }
  }
}

TEST(SourceTree, LeavesASizeThatNothingIsBelow) {
  const SizeTensor size = size_tensor(0.004, 0.003, 0.2);
  RandomPlaces random;
  const SourceTree tree(random_sizes(100, false), 1.5);
  EXPECT_EQ(tree.minimum_at(random_place(random), size), size);
  EXPECT_EQ(SourceTree({}, 1.5).minimum_at(random_place(random), size), size);
}

TEST(SourceTree, HoldsAllItsSizes) {
  EXPECT_EQ(SourceTree(random_sizes(1001, true), 0).sizes().size(), 1001u);
}

TEST(SourceTree, TakesManySizesAtOnePlace) {
  std::vector<PlacedSize> sizes(1000, random_sizes(1, true)[0]);
  sizes[700].at_from = sizes[700].at_to = {0.001, 0.001};
  const SourceTree tree(sizes, 1.5);
  const TangentFrame place{sizes[0].from, Vec3::UnitX(), Vec3::UnitY()};
  testing::expect_near(tree.minimum_at(place, isotropic(1)), isotropic(0.001), 1e-12);
}

}  // namespace
}  // namespace surfmesh
