// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/even_counts.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>

#include "support/models.hh"
#include "surfmesh/boundary/patch_boundary.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::model_of;
using testing::rectangle;
using testing::UniformSizes;

/// The contours of a model, each divided by itself.
struct Divided {
  Model model;
  std::vector<testing::FunctionField> fields;
  RunContext context;
  ContourDivisions divisions;

  Divided(Model given, const std::vector<double>& sizes) : model(std::move(given)) {
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
      fields.push_back(
          testing::isotropic_field_on(*model.patches[p].surface, sizes[p % sizes.size()]));
    }
    std::vector<const MetricField*> pointers;
    for (const auto& field : fields) pointers.push_back(&field);
    const LeastSegments least(model);
    divisions.resize(model.contours.size());
    for (std::size_t c = 0; c < model.contours.size(); ++c) {
      const Contour& contour = model.contours[c];
      if (contour.uses.empty() || contour.is_degenerate) continue;
      divisions[c].emplace(model, contour, pointers, context);
      divisions[c]->divide(least(contour), 1, {});
    }
  }
  Divided(const Divided&) = delete;

  std::vector<int> counts() const {
    std::vector<int> counts;
    for (const auto& division : divisions) {
      counts.push_back(division ? static_cast<int>(division->segment_count()) : 0);
    }
    return counts;
  }

  std::size_t count_odd() const {
    const std::vector<char> odd = odd_patches(model, divisions);
    return static_cast<std::size_t>(std::count(odd.begin(), odd.end(), 1));
  }

  void make_even(bool may_shrink = true) {
    make_patches_even(model, LeastSegments(model), may_shrink, divisions);
  }

  /// How much farther the number of segments is, by ratio, from the length, with some more.
  double cost(std::size_t contour, int count) const {
    const double length = divisions[contour]->longest_sum();
    return std::abs(std::log(count / length)) -
           std::abs(std::log(static_cast<double>(divisions[contour]->segment_count()) / length));
  }
};

/// Two rows of unequal squares: vertices of three and four patches.
Model tiles(int columns, int rows) {
  std::vector<testing::Shape> shapes;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      shapes.push_back(rectangle(i + 0.2 * std::sin(i), j, i + 1 + 0.2 * std::sin(i + 1), j + 1));
    }
  }
  return model_of(shapes);
}

/// A wide rectangle below two narrow ones: a T-junction.
Model t_shape() {
  return model_of({rectangle(0, 0, 2, 1), rectangle(0, 1, 0.9, 2), rectangle(0.9, 1, 2, 2)});
}

struct ModelCase {
  const char* name;
  std::function<Model()> make;
};

void PrintTo(const ModelCase& example, std::ostream* out) { *out << example.name; }

class EvenCounts : public ::testing::TestWithParam<ModelCase> {
 protected:
  static constexpr double kSizes[] = {0.31, 0.17, 0.093, 0.41, 1.7};
};

TEST_P(EvenCounts, MakeEveryPatchEven) {
  std::size_t odd = 0;
  for (const double size : kSizes) {
    for (const bool may_shrink : {true, false}) {
      Divided divided(GetParam().make(), {size, 0.7 * size, 1.3 * size});
      odd += divided.count_odd();
      divided.make_even(may_shrink);
      EXPECT_EQ(divided.count_odd(), 0u) << size;
    }
  }
}

TEST_P(EvenCounts, ChangeNoContourByMoreThanOneSegment) {
  for (const double size : kSizes) {
    Divided divided(GetParam().make(), {size, 0.7 * size});
    const std::vector<int> before = divided.counts();
    divided.make_even();
    for (std::size_t c = 0; c < before.size(); ++c) {
      EXPECT_LE(std::abs(divided.counts()[c] - before[c]), 1);
      const bool is_even = divided.counts()[c] % 2 == 0;
      EXPECT_TRUE(divided.model.contours[c].uses.size() < 3 || is_even);
    }
  }
}

TEST_P(EvenCounts, OnlyGrowWhereTheyMayNotShrink) {
  for (const double size : kSizes) {
    Divided divided(GetParam().make(), {size, 0.7 * size});
    const std::vector<int> before = divided.counts();
    divided.make_even(false);
    for (std::size_t c = 0; c < before.size(); ++c) EXPECT_GE(divided.counts()[c], before[c]);
  }
}

TEST_P(EvenCounts, DoNotFallBelowTheLeastNumbers) {
  for (const double size : kSizes) {
    Divided divided(GetParam().make(), {size});
    divided.make_even();
    const LeastSegments least(divided.model);
    for (std::size_t c = 0; c < divided.divisions.size(); ++c) {
      if (!divided.divisions[c]) continue;
      EXPECT_GE(divided.counts()[c], least(divided.model.contours[c]));
    }
  }
}

TEST_P(EvenCounts, ChangeNothingTheSecondTime) {
  Divided divided(GetParam().make(), {0.23, 0.19});
  divided.make_even();
  const std::vector<int> before = divided.counts();
  divided.make_even();
  EXPECT_EQ(divided.counts(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Models, EvenCounts,
    ::testing::Values(
        ModelCase{"Square", [] { return testing::unit_square(); }},
        ModelCase{"Tiles", [] { return tiles(4, 3); }},
        ModelCase{"TShape", [] { return t_shape(); }},
        ModelCase{"Ring", [] { return testing::narrow_ring(0.6); }},
        ModelCase{"PlateWithHole", [] { return testing::square_with_hole(0.4); }},
        ModelCase{"Torus", [] { return testing::torus_of(3); }},
        ModelCase{"TorusOfOnePatch", [] { return model_of({testing::whole_torus()}); }},
        ModelCase{"CylinderOfOnePatch", [] { return model_of({testing::cylinder(0, 2 * pi)}); }},
        ModelCase{"Sphere", [] { return testing::sphere_of(3); }},
        ModelCase{"Cone", [] { return testing::cone_of(2); }},
        ModelCase{"MobiusBand", [] { return testing::mobius_band(); }},
        ModelCase{"ThreeSquares", [] { return testing::three_squares(); }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(MakePatchesEven, LeavesEvenPatchesAsTheyAre) {
  Divided divided(tiles(2, 2), {10});
  const std::vector<int> before = divided.counts();
  ASSERT_EQ(divided.count_odd(), 0u);
  divided.make_even();
  EXPECT_EQ(divided.counts(), before);
}

TEST(MakePatchesEven, ChangesAContourBetweenTwoOddPatches) {
  // 3 + 5 + 3 + 4 on the left and 3 + 5 + 3 + 4 on the right, say: only the one between both.
  Divided divided(model_of({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)}), {0.2});
  const auto between = static_cast<std::size_t>(testing::contour_index(divided.model, "p0:u1"));
  divided.divisions[between]->change_count(1);
  ASSERT_EQ(divided.count_odd(), 2u);
  divided.make_even();
  EXPECT_EQ(divided.counts()[between], 5 + (divided.counts()[between] == 5 ? 0 : 2));
  EXPECT_EQ(divided.counts()[between] % 2, 1);
}

TEST(OddPatches, CountBothSidesOfASeam) {
  // Three segments of the seam twice, and two closed contours.
  Divided divided(model_of({testing::cylinder(0, 2 * pi)}), {0.3});
  int rims = 0;
  for (std::size_t c = 0; c < divided.model.contours.size(); ++c) {
    if (divided.model.contours[c].uses.size() == 1) rims += divided.counts()[c];
  }
  EXPECT_EQ(odd_patches(divided.model, divided.divisions), std::vector<char>(1, rims % 2 != 0));
}

/// The least cost of making all patches even, by trying all sets of contours.
double least_cost(const Divided& divided, const std::vector<double>& costs) {
  const std::size_t n = costs.size();
  double best = std::numeric_limits<double>::infinity();
  const std::vector<char> odd = odd_patches(divided.model, divided.divisions);
  for (std::size_t set = 0; set < (std::size_t{1} << n); ++set) {
    std::vector<char> left = odd;
    double sum = 0;
    for (std::size_t c = 0; c < n; ++c) {
      if ((set >> c & 1) == 0) continue;
      sum += costs[c];
      for (const ContourUse& use : divided.model.contours[c].uses) {
        left[static_cast<std::size_t>(use.patch)] ^= 1;
      }
    }
    if (sum < best && std::count(left.begin(), left.end(), 1) == 0) best = sum;
  }
  return best;
}

/// Over random sizes: the sum of what all cost, against that of the best ones.
TEST(MakePatchesEven, CostsLittleMoreThanTheBest) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> size(0.05, 0.4);
  double sum = 0, best = 0;
  int odd = 0;
  for (int i = 0; i < 60; ++i) {
    Divided divided(i % 2 == 0 ? tiles(2, 2) : t_shape(),
                    {size(random), size(random), size(random), size(random)});
    if (divided.count_odd() == 0) continue;
    ++odd;
    const LeastSegments least(divided.model);
    std::vector<double> costs;
    for (std::size_t c = 0; c < divided.divisions.size(); ++c) {
      const int count = divided.counts()[c];
      double cost = divided.cost(c, count + 1);
      const bool can_shrink = count - 1 >= least(divided.model.contours[c]) &&
                              divided.divisions[c]->longest_sum() <= std::sqrt(2) * (count - 1);
      if (can_shrink) cost = std::min(cost, divided.cost(c, count - 1));
      costs.push_back(cost);
    }
    best += least_cost(divided, costs);
    const std::vector<int> before = divided.counts();
    divided.make_even();
    for (std::size_t c = 0; c < costs.size(); ++c) {
      if (divided.counts()[c] != before[c]) sum += costs[c];
    }
  }
  EXPECT_GT(odd, 30);
  EXPECT_GE(sum, best - 1e-9);
  EXPECT_LE(sum, 1.1 * best);
}

TEST(PlaceContourNodes, MakesEveryPatchEvenIfThatIsAskedFor) {
  for (const Model& model : {tiles(3, 3), t_shape(), testing::sphere_of(3),
                             testing::three_squares(), testing::narrow_ring(0.95)}) {
    for (const double size : {0.07, 0.31, 0.9}) {
      const auto nodes = place_contour_nodes(model, UniformSizes(model, size),
                                             {.parity = SegmentParity::EvenPatches})
                             .contours;
      std::vector<int> sums(model.patches.size(), 0);
      for (std::size_t c = 0; c < nodes.size(); ++c) {
        if (model.contours[c].is_degenerate) continue;
        for (const ContourUse& use : model.contours[c].uses) {
          sums[static_cast<std::size_t>(use.patch)] += nodes[c].segment_count();
        }
      }
      for (const int sum : sums) EXPECT_EQ(sum % 2, 0) << size;
    }
  }
}

// --- rings around poles ---

/// The rings of all fans of a model with fans of quads.
std::vector<PoleFan> fans_of_quads(const Model& model, double size) {
  const UniformSizes fields(model, size);
  const auto nodes =
      place_contour_nodes(model, fields, {.parity = SegmentParity::EvenPatches}).contours;
  const NodeNumbers numbers(model, nodes);
  std::vector<PoleFan> fans;
  for (int p = 0; p < static_cast<int>(model.patches.size()); ++p) {
    const PatchBoundary boundary =
        collect_boundary(model, p, nodes, numbers, fields[p], /*segments_per_face=*/2);
    std::size_t count = 0;
    for (const BoundaryLoop& loop : boundary.loops) count += loop.size();
    EXPECT_EQ(count % 2, 0u) << "patch " << p << ", size " << size;
    fans.insert(fans.end(), boundary.fans.begin(), boundary.fans.end());
  }
  return fans;
}

std::size_t fewest_segments(const Model& model, double size) {
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const PoleFan& fan : fans_of_quads(model, size)) {
    EXPECT_EQ(fan.segments_per_face, 2);
    EXPECT_EQ((fan.ring.size() - 1) % 2, 0u);
    fewest = std::min(fewest, fan.ring.size() - 1);
  }
  return fewest;
}

TEST(PoleFanOfQuads, HasAnEvenRingOfAtLeastSixSegmentsAroundItsPole) {
  for (const double size : {0.05, 0.2, 0.7, 3.0}) {
    EXPECT_GE(fewest_segments(model_of({testing::sphere()}), size), 6u);
  }
}

TEST(PoleFanOfQuads, HasAtLeastFourSegmentsWhereTwoPatchesShareThePole) {
  for (const double size : {0.05, 0.2, 0.7, 3.0}) {
    EXPECT_GE(fewest_segments(testing::sphere_of(2), size), 4u);
    EXPECT_GE(fewest_segments(testing::cone_of(2), size), 4u);
  }
}

TEST(PoleFanOfQuads, HasAtLeastTwoSegmentsWhereMoreDo) {
  for (const double size : {0.05, 0.2, 0.7, 3.0}) {
    EXPECT_GE(fewest_segments(testing::sphere_of(5), size), 2u);
  }
  EXPECT_EQ(fewest_segments(testing::sphere_of(5), 0.2), 2u);
}

}  // namespace
}  // namespace surfmesh
