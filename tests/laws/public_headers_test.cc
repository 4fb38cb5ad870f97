// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <string>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

/// The headers that the build installs, as "core/mesh.hh", or "core/version.hh.in" where CMake
/// fills it in; all others are the library's own.
std::multiset<std::string> public_headers() {
  static const std::regex pattern(R"(\n\s*surfmesh/((?:\w+/)?\w+\.hh(?:\.in)?))");
  std::ifstream stream(std::filesystem::path(SURFMESH_SOURCE_DIR) / "libsurfmesh/CMakeLists.txt");
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  std::multiset<std::string> result;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    result.insert((*match)[1]);
  }
  return result;
}

TEST(PublicHeaders, AreListedOnceAndExist) {
  std::multiset<std::string> existing;
  const auto listed = public_headers();
  for (const auto& file : testing::library_sources()) {
    if (listed.count(file.path) > 0) existing.insert(file.path);
  }
  EXPECT_GT(existing.size(), 50u);
  EXPECT_EQ(listed, existing) << "libsurfmesh/CMakeLists.txt, PUBLIC_HEADERS";
}

/// Our header that a line includes, as "core/mesh.hh", if it does.
std::optional<std::string> included_header(const std::string& line) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*["<]surfmesh/([^">]+)[">])re");
  std::smatch match;
  if (!std::regex_search(line, match, pattern)) return std::nullopt;
  return match[1].str();
}

bool is_listed(const std::string& header, const std::multiset<std::string>& listed) {
  return listed.count(header) + listed.count(header + ".in") > 0;
}

/// A consumer has neither our private headers nor the libraries that only our sources use.
bool is_private_include(const std::string& line, const std::multiset<std::string>& listed) {
  static const std::regex library(
      R"re(^\s*#\s*include\s*<((nlohmann|fmt|boost|opensubdiv|tbb)/|expat|zlib))re");
  const auto header = included_header(line);
  return std::regex_search(line, library) || (header && !is_listed(*header, listed));
}

TEST(PublicHeaders, IncludeNothingPrivate) {
  const auto listed = public_headers();
  for (const auto& file : testing::library_sources()) {
    if (listed.count(file.path) == 0) continue;
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_FALSE(is_private_include(file.code[i], listed)) << place(file, i);
    }
  }
}

bool includes_one_of_ours(const testing::SourceFile& file) {
  return std::any_of(file.code.begin(), file.code.end(),
                     [](const std::string& line) { return included_header(line).has_value(); });
}

/// Then each reaches it: following what they include ends at the one that includes nothing.
TEST(PublicHeaders, IncludeTheCheckOfTheLanguageOrAnotherOfOurs) {
  const auto listed = public_headers();
  for (const auto& file : testing::library_sources()) {
    if (listed.count(file.path) == 0 || file.path == "core/language_standard.hh") continue;
    EXPECT_TRUE(includes_one_of_ours(file))
        << file.path << " must include surfmesh/core/language_standard.hh";
  }
}

TEST(PublicHeaders, SeesWhatIsPrivate) {
  const std::multiset<std::string> listed = {"core/mesh.hh", "core/version.hh.in"};
  EXPECT_FALSE(is_private_include("#include \"surfmesh/core/mesh.hh\"", listed));
  EXPECT_FALSE(is_private_include("#include \"surfmesh/core/version.hh\"", listed));
  EXPECT_FALSE(is_private_include("#include <vector>", listed));
  EXPECT_TRUE(is_private_include("#include \"surfmesh/io/json_node.hh\"", listed));
  EXPECT_TRUE(is_private_include("#include <fmt/format.h>", listed));
}

}  // namespace
}  // namespace surfmesh
