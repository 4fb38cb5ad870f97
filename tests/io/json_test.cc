// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/json.hh"

#include <gtest/gtest.h>

#include "support/errors.hh"

namespace surfmesh {
namespace {

TEST(Json, IsAnObjectWhereAllArePairsThatBeginWithATextElseAnArray) {
  EXPECT_EQ((Json{{"a", 1}, {"b", {1, 2.5, nullptr}}}).dump(), R"({"a":1,"b":[1,2.5,null]})");
  EXPECT_EQ((Json{{"a", 1}, {2, 1}}).dump(), R"([["a",1],[2,1]])");
  EXPECT_EQ((Json{"a", "b"}).dump(), R"(["a","b"])");
  EXPECT_EQ((Json{{"a", {{"x", 1}, {"y", Json()}}}}).dump(), R"({"a":{"x":1,"y":null}})");
  EXPECT_EQ(Json::array({{"a", 1}}).dump(), R"([["a",1]])");
  EXPECT_EQ(Json::object().dump(), "{}");
  EXPECT_EQ(error_of([] {
              return Json::object({1, 2}).size();
            }),
            "invalid input: a list of no pairs is no object");
}

TEST(Json, KeepsTheOrderOfKeysAndTheFirstOfEqualOnes) {
  EXPECT_EQ((Json{{"b", 1}, {"a", 2}, {"b", 3}}).dump(), R"({"b":1,"a":2})");
}

TEST(Json, CopiesWhatIsNamed) {
  const Json inner = {{"x", "text"}};
  const Json outer = {{"a", inner}, {"b", inner}};
  EXPECT_EQ(inner.dump(), R"({"x":"text"})");
  EXPECT_EQ(outer.dump(), R"({"a":{"x":"text"},"b":{"x":"text"}})");
}

}  // namespace
}  // namespace surfmesh
