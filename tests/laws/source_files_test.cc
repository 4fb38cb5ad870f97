// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

using testing::without_comments;
using testing::without_strings;

TEST(SourceFiles, AreFound) {
  const auto files = testing::library_sources();
  EXPECT_GT(files.size(), 10u);
  for (const auto& file : files) EXPECT_EQ(file.lines.size(), file.code.size()) << file.path;
}

TEST(SourceFiles, LoseTheirComments) {
  EXPECT_EQ(without_comments("a // b\nc"), "a  \nc");
  EXPECT_EQ(without_comments("a /* b\n */ c"), "a \n  c");
  EXPECT_EQ(without_comments("\"// no\" '\"' // yes"), "\"// no\" '\"'  ");
  EXPECT_EQ(without_comments("1'000 // yes"), "1'000  ");
  EXPECT_EQ(without_comments("R\"(a // \" b)\" // yes"), "R\"(a // \" b)\"  ");
}

TEST(SourceFiles, LoseTheirStrings) { EXPECT_EQ(without_strings("f(\"a\\\"b\", 'c')"), "f( ,  )"); }

TEST(SourceFiles, BeginWithTheLicence) {
  for (const auto& file : testing::library_sources()) {
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_EQ(file.lines[0], "// SPDX-License-Identifier: BSD-3-Clause") << file.path;
  }
}

}  // namespace
}  // namespace surfmesh
