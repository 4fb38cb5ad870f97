// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/version.hh"

#include <gtest/gtest.h>

#include <string>

namespace surfmesh {
namespace {

TEST(Version, ReadsAsItsParts) {
  EXPECT_EQ(SURFMESH_VERSION, std::to_string(SURFMESH_VERSION_MAJOR) + "." +
                                  std::to_string(SURFMESH_VERSION_MINOR) + "." +
                                  std::to_string(SURFMESH_VERSION_PATCH));
}

}  // namespace
}  // namespace surfmesh
