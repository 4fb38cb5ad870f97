// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/version.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

using testing::text_of_file;

/// What stands between the first two of these in a text; nothing if they are not there.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  if (at == text.npos) return "";
  const std::size_t begin = at + before.size();
  return text.substr(begin, text.find(after, begin) - begin);
}

TEST(Version, IsThatOfThePythonModuleAndOfThePages) {
  EXPECT_EQ(between(text_of_file("tools/python/pyproject.toml"), "\nversion = \"", "\""),
            SURFMESH_VERSION);
  for (const char* file : {"package.json", "package-lock.json"}) {
    EXPECT_EQ(
        between(text_of_file(std::string("tools/view/page/") + file), "\"version\": \"", "\""),
        SURFMESH_VERSION);
  }
}

/// The newest section comes first.
TEST(Version, IsThatOfTheNewestSectionOfTheChangelog) {
  EXPECT_EQ(between(text_of_file("CHANGELOG.md"), "\n## ", " ("), SURFMESH_VERSION);
}

TEST(Version, IsThatOfThePackagesInTheReadme) {
  const std::string readme = text_of_file("README.md");
  EXPECT_EQ(between(readme, "./surfmesh_", "_"), SURFMESH_VERSION);
  EXPECT_EQ(between(readme, "-xzf surfmesh-", "-"), SURFMESH_VERSION);
}

TEST(Version, IsAskedForWhereTheLibraryIsFound) {
  const std::string wanted =
      std::to_string(SURFMESH_VERSION_MAJOR) + "." + std::to_string(SURFMESH_VERSION_MINOR);
  for (const char* file : {"libsurfmesh/LIBRARY.md", "tests/package/CMakeLists.txt"}) {
    EXPECT_EQ(between(text_of_file(file), "find_package(surfmesh ", " "), wanted) << file;
  }
}

}  // namespace
}  // namespace surfmesh
