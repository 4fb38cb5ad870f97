// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/out_of_memory.hh"

#include <gtest/gtest.h>

#include "support/errors.hh"

namespace surfmesh {
namespace {

const auto kReached = [] { return "at 7 triangles"; };

TEST(OutOfMemory, SaysHowFarItCame) {
  EXPECT_EQ(error_of([] { tell_out_of_memory([] { throw std::bad_alloc(); }, kReached); }),
            "limit: out of memory at 7 triangles");
}

TEST(OutOfMemory, PassesResultsAndOtherErrorsOn) {
  EXPECT_EQ(tell_out_of_memory([] { return 3; }, kReached), 3);
  const auto fail = [] { throw Error(ErrorCode::Io, "no file"); };
  EXPECT_EQ(error_of([&] { tell_out_of_memory(fail, kReached); }), "io: no file");
}

}  // namespace
}  // namespace surfmesh
