// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/append_model.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/errors.hh"
#include "support/models.hh"
#include "support/notices.hh"

namespace surfmesh {
namespace {

using testing::model_of;
using testing::rectangle;

TEST(Append, KeepsBothPartsSound) {
  Model model = model_of({rectangle(0, 0, 1, 1)});
  append(model, model_of({rectangle(3, 0, 4, 1), rectangle(4, 0, 5, 1)}), "b:");
  EXPECT_EQ(error_of([&] { check(model); }), "no error");
  EXPECT_EQ(model.patches.size(), 3u);
  EXPECT_EQ(model.patches[2].name, "b:p1");
  EXPECT_EQ(model.contours.size(), 11u);
  EXPECT_EQ(model.contours[4].uses[0].patch, 1);
  EXPECT_EQ(model.vertices.size(), 10u);
  EXPECT_NEAR(model.diagonal, std::sqrt(26.0), 1e-14);
  EXPECT_TRUE(texts_of(model.notices).empty());
}

TEST(Append, ShiftsGroups) {
  Model model = model_of({rectangle(0, 0, 1, 1)});
  Model added = model_of({rectangle(3, 0, 4, 1)});
  added.groups.push_back({"wing", {0}});
  append(model, added);
  ASSERT_EQ(model.groups.size(), 1u);
  EXPECT_EQ(model.groups[0].patches, std::vector<int>{1});
}

TEST(Append, WarnsOfOpenContoursThatCoincide) {
  Model model = model_of({rectangle(0, 0, 1, 1)});
  append(model, model_of({rectangle(1, 0.25, 2, 0.75)}), "b:");
  ASSERT_EQ(texts_of(model.notices).size(), 1u);
  EXPECT_EQ(model.contour(model.notices[0].contour).name, "p0:u1");
  EXPECT_NE(texts_of(model.notices)[0].find(
                "1 pair of contours run along each other without being joined"),
            std::string::npos);
  EXPECT_NE(texts_of(model.notices)[0].find("p0:u1 and b:p0:u0"), std::string::npos)
      << texts_of(model.notices)[0];
}

}  // namespace
}  // namespace surfmesh
