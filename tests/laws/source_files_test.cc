// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
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
  for (const auto& file : testing::library_sources_with_parts()) {
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_EQ(file.lines[0], "// SPDX-License-Identifier: BSD-3-Clause") << file.path;
  }
}

/// clang-format differs between versions; this is Debian 12's, which tools/setup.sh installs.
constexpr const char* kFormatter = "clang-format-14";

int run(const std::string& command) { return std::system((command + " >&2").c_str()); }

bool has_formatter() { return run(std::string(kFormatter) + " --version") == 0; }

/// Check the formatting of files, or of standard input. Returns 0 if nothing is to be changed.
int check_format(const std::string& before, const std::string& arguments) {
  return run(before + kFormatter + " --dry-run --Werror " + arguments);
}

TEST(SourceFiles, AreFormatted) {
  if (!has_formatter()) GTEST_SKIP() << kFormatter << " is not installed";
  std::string paths;
  for (const auto& file : testing::project_sources()) {
    if (file.path.ends_with(".in")) continue;  // @NAME@ is no code before CMake fills it in
    paths += " '" + file.path + "'";
  }
  EXPECT_EQ(check_format("cd '" SURFMESH_SOURCE_DIR "' && ", paths), 0)
      << "run " << kFormatter << " -i on the files named above";
}

TEST(SourceFiles, AreSeenWhereTheyAreNotFormatted) {
  if (!has_formatter()) GTEST_SKIP() << kFormatter << " is not installed";
  const std::string name = "--assume-filename=test.cc";
  EXPECT_EQ(check_format("printf 'int f();\\n' | ", name), 0);
  EXPECT_NE(check_format("printf 'int  f ();\\n' | ", name), 0);
}

}  // namespace
}  // namespace surfmesh
