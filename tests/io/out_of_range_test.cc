// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/out_of_range.hh"

#include <gtest/gtest.h>

#include <string>

namespace surfmesh {
namespace {

std::string zeros(int count) { return std::string(static_cast<std::size_t>(count), '0'); }

TEST(OutOfRange, IsToldFromZeroByTheSizeOfTheNumber) {
  for (const std::string& tiny :
       {std::string("1e-400"), std::string("-1.5E-999"), std::string("1e-99999999999999999999"),
        "0." + zeros(400) + "1", "-0." + zeros(400) + "1E+10", "." + zeros(330) + "7",
        "1" + zeros(10) + "e-400"}) {
    EXPECT_TRUE(is_too_near_to_zero(tiny)) << tiny;
  }
  for (const std::string& large :
       {std::string("1e400"), std::string("-1.5E+999"), std::string("1e99999999999999999999"),
        "1" + zeros(400), "1" + zeros(400) + "E-10", "0." + zeros(10) + "1e400",
        "-1" + zeros(309) + ".5"}) {
    EXPECT_FALSE(is_too_near_to_zero(large)) << large;
  }
}

}  // namespace
}  // namespace surfmesh
