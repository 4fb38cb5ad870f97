// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

bool is_public(const testing::SourceFile& file) {
  return file.path.ends_with(".hh") && !file.path.ends_with("_detail.hh");
}

/// The headers that the build names, as "core/mesh.hh".
std::multiset<std::string> listed_headers() {
  static const std::regex pattern(R"(\n\s*surfmesh/(\w+/\w+\.hh))");
  std::ifstream stream(std::filesystem::path(SURFMESH_SOURCE_DIR) / "libsurfmesh/CMakeLists.txt");
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  std::multiset<std::string> result;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    result.insert((*match)[1]);
  }
  return result;
}

TEST(PublicHeaders, AreListedForTheInstallation) {
  std::multiset<std::string> expected;
  for (const auto& file : testing::library_sources()) {
    if (is_public(file)) expected.insert(file.path);
  }
  EXPECT_EQ(listed_headers(), expected) << "libsurfmesh/CMakeLists.txt, surfmesh_add_headers";
}

/// A consumer has neither our private headers nor the libraries that only our sources use.
TEST(PublicHeaders, IncludeNothingPrivate) {
  static const std::regex pattern(
      R"re(^\s*#\s*include\s*(<(nlohmann|fmt|boost|opensubdiv|tbb)/|"[^"]*_detail\.hh"))re");
  for (const auto& file : testing::library_sources()) {
    if (!is_public(file)) continue;
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_FALSE(std::regex_search(file.code[i], pattern)) << place(file, i);
    }
  }
}

}  // namespace
}  // namespace surfmesh
