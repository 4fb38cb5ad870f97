// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/errors.hh"
#include "support/models.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

TEST(Sources, AreRefusedOnPatchesThatDoNotExist) {
  const Model model = testing::model_of({testing::rectangle(0, 0, 1, 1)});
  const Size size = {{0.1}, {0.1}};
  Sources everywhere, at;
  everywhere.everywhere = {{0, size}, {1, size}};
  at.at = {{-1, {0.5, 0.5}, size}};
  EXPECT_EQ(error_of([&] { mesh_model(model, everywhere); }),
            "invalid input: source 1 of kind everywhere: patch 1 of 1");
  EXPECT_EQ(error_of([&] { mesh_model(model, at); }),
            "invalid input: source 0 of kind at: patch -1 of 1");
}

}  // namespace
}  // namespace surfmesh
