// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/patch_names.hh"

#include <gtest/gtest.h>

#include "support/models.hh"

namespace surfmesh {
namespace {

TEST(PatchNames, TellTheFirstAndHowManyMore) {
  const Model model = testing::sphere_of(4);
  const std::string first = "patch " + model.patches[1].name;
  EXPECT_EQ(detail::patch_names(model, {0, 0, 0, 0}), "");
  EXPECT_EQ(detail::patch_names(model, {0, 1, 0, 0}), first);
  EXPECT_EQ(detail::patch_names(model, {0, 1, 1, 1}), first + " and 2 more");
}

}  // namespace
}  // namespace surfmesh
