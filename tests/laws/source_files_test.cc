// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

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

/// Code points of a text in UTF-8: the bytes that do not continue one.
std::ptrdiff_t columns(std::string_view line) {
  return std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; });
}

TEST(SourceFiles, CountColumnsNotBytes) { EXPECT_EQ(columns("√½ ≤ 1"), 6); }

TEST(SourceFiles, HaveNoLineOfMoreThan100Columns) {
  const auto files = testing::project_sources();
  EXPECT_GT(files.size(), testing::library_sources().size());
  for (const auto& file : files) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      EXPECT_LE(columns(file.lines[i]), 100) << place(file, i);
    }
  }
}

TEST(SourceFiles, BeginWithTheLicence) {
  for (const auto& file : testing::library_sources()) {
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_EQ(file.lines[0], "// SPDX-License-Identifier: BSD-3-Clause") << file.path;
  }
}

}  // namespace
}  // namespace surfmesh
