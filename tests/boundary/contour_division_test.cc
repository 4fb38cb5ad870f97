// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/contour_division.hh"

#include <gtest/gtest.h>

#include "support/cancelling.hh"
#include "support/errors.hh"
#include "support/models.hh"

namespace surfmesh {
namespace {

const RunContext kContext;

using testing::isotropic_field;
using testing::model_of;

/// Two squares side by side; their common contour has the first patch as its first use.
struct Squares {
  Model model = model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  const Contour& common = model.contour(testing::contour_index(model, "p0:u1"));
};

TEST(ContourDivision, DividesByTheLongestUse) {
  const Squares squares;
  const auto coarse = isotropic_field(0.25), fine = isotropic_field(0.1);
  ContourDivision division(squares.model, squares.common, {&coarse, &fine}, kContext);
  division.divide(1, 1, {});
  EXPECT_EQ(division.segment_count(), 10u);
  for (const auto& list : division.parameters()) {
    ASSERT_EQ(list.size(), 11u);
    for (std::size_t i = 0; i <= 10; ++i) EXPECT_NEAR(list[i], 0.1 * double(i), 1e-3);
  }
}

TEST(ContourDivision, EndsWhileItDividesOnceItIsCancelled) {
  const Squares squares;
  testing::Cancelling observer;
  const RunContext context(&observer);
  const auto field = isotropic_field(0.1);
  ContourDivision division(squares.model, squares.common, {&field, &field}, context);
  division.divide(10, 1, {});
  EXPECT_EQ(error_of([&] { division.divide(1000, 1, {}); }), testing::kCancelled);
}

TEST(ContourDivision, TakesAtLeastTheLeastRoundedUp) {
  const Squares squares;
  const auto field = isotropic_field(10);
  ContourDivision division(squares.model, squares.common, {&field, &field}, kContext);
  division.divide(3, 2, {});
  EXPECT_EQ(division.segment_count(), 4u);
}

TEST(ContourDivision, HalvesWhatIsTooLongForAnotherUse) {
  const Squares squares;
  const auto below = isotropic_field([](Uv uv) { return uv.v < 0.5 ? 0.1 : 10; });
  const auto above = isotropic_field([](Uv uv) { return uv.v > 0.5 ? 0.105 : 10; });
  ContourDivision division(squares.model, squares.common, {&below, &above}, kContext);
  division.divide(1, 1, {});
  const std::size_t before = division.segment_count();
  EXPECT_TRUE(division.halve_long_segments());
  EXPECT_GT(division.segment_count(), before);
  EXPECT_FALSE(division.halve_long_segments());
}

TEST(ContourDivision, RoundsItsCountUp) {
  const Squares squares;
  const auto field = isotropic_field(0.2);
  ContourDivision division(squares.model, squares.common, {&field, &field}, kContext);
  division.divide(1, 1, {});
  ASSERT_EQ(division.segment_count(), 5u);
  division.round_up_to(4);
  EXPECT_EQ(division.segment_count(), 8u);
  division.round_up_to(4);
  EXPECT_EQ(division.segment_count(), 8u);
}

TEST(ContourDivision, HalvesACrossingSegmentInItsMiddle) {
  const Squares squares;
  const auto field = isotropic_field(0.5);
  ContourDivision division(squares.model, squares.common, {&field, &field}, kContext);
  division.divide(1, 1, {});
  ASSERT_EQ(division.segment_count(), 2u);
  EXPECT_TRUE(division.halve_crossing(1));
  ASSERT_EQ(division.segment_count(), 3u);
  for (const auto& list : division.parameters()) EXPECT_NEAR(list[2], 0.75, 1e-3);
}

TEST(ContourDivision, DoesNotHalveWithoutEnd) {
  const Squares squares;
  const auto field = isotropic_field(1);
  ContourDivision division(squares.model, squares.common, {&field, &field}, kContext);
  division.divide(1, 1, {});
  int rounds = 0;
  while (rounds < 100 && division.halve_crossing(0)) ++rounds;
  EXPECT_GT(rounds, 10);
  EXPECT_LT(rounds, 30);
}

}  // namespace
}  // namespace surfmesh
