// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

using testing::text_of_file;

/// The programs of tests/package, by name.
std::set<std::string> examples() {
  std::set<std::string> names;
  const std::filesystem::path root(SURFMESH_SOURCE_DIR);
  for (const auto& entry : std::filesystem::directory_iterator(root / "tests" / "package")) {
    if (entry.path().extension() == ".cc") names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(Readme, AndTheLibrarysShowEveryExampleThatIsCompiled) {
  const std::string text = text_of_file("README.md") + text_of_file("libsurfmesh/LIBRARY.md");
  EXPECT_GE(examples().size(), 5u);
  for (const std::string& name : examples()) {
    EXPECT_NE(text.find("```cpp\n" + text_of_file("tests/package/" + name) + "```\n"),
              std::string::npos)
        << "README.md or libsurfmesh/LIBRARY.md must contain tests/package/" << name << " as it is";
  }
}

/// The blocks of C++ in a document.
std::vector<std::string> snippets(const std::string& text) {
  const std::string begin = "```cpp\n";
  std::vector<std::string> found;
  for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at)) {
    at += begin.size();
    found.push_back(text.substr(at, text.find("```", at) - at));
  }
  return found;
}

TEST(Readme, AndTheOthersShowNoCppThatIsNotCompiled) {
  std::set<std::string> compiled;
  for (const std::string& name : examples()) compiled.insert(text_of_file("tests/package/" + name));
  std::size_t count = 0;
  for (const char* document : {"README.md", "libsurfmesh/LIBRARY.md", "libsurfmesh/REFERENCE.md",
                               "libsurfmesh/README.md"}) {
    for (const std::string& snippet : snippets(text_of_file(document))) {
      ++count;
      EXPECT_TRUE(compiled.contains(snippet)) << document << " shows what is in no program of "
                                              << "tests/package:\n"
                                              << snippet;
    }
  }
  EXPECT_EQ(count, examples().size());
}

/// Of ours; what they include besides is not what a reader has to look for.
TEST(Readme, ShowsExamplesThatIncludeOneHeader) {
  static const std::regex pattern(R"re(#include ["<](surfmesh/[^">]+))re");
  for (const std::string& name : examples()) {
    const std::string text = text_of_file("tests/package/" + name);
    std::vector<std::string> headers;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end;
         ++match) {
      headers.push_back((*match)[1]);
    }
    EXPECT_EQ(headers, std::vector<std::string>{"surfmesh/surfmesh.hh"}) << name;
  }
}

TEST(Readme, ShowsShortExamples) {
  for (const std::string& name : examples()) {
    EXPECT_LE(testing::lines_of(text_of_file("tests/package/" + name)).size(), 40u) << name;
  }
}

/// What is to be replaced, "@SUMMARY@".
TEST(Readme, HasNoPlaceholders) {
  static const std::regex pattern(R"(@[A-Z]+@)");
  EXPECT_FALSE(std::regex_search(text_of_file("README.md"), pattern));
}

TEST(Readme, NamesModelsAndScriptsThatExist) {
  static const std::regex pattern(R"((models|tools)/\w+(\.\w+)+)");
  const std::string text = text_of_file("README.md") + text_of_file("libsurfmesh/REFERENCE.md") +
                           text_of_file("libsurfmesh/LIBRARY.md");
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(SURFMESH_SOURCE_DIR) / match->str()))
        << match->str();
  }
}

/// A row of the table of properties begins with the name of the key in the code.
TEST(LibraryReadme, ListsEveryProperty) {
  static const std::regex pattern(R"re(PropertyKey<.*> (\w+)\{"surf:)re");
  const std::string text = text_of_file("libsurfmesh/README.md");
  std::size_t count = 0;
  for (const std::string& line :
       testing::lines_of(text_of_file("libsurfmesh/surfmesh/core/properties.hh"))) {
    std::smatch match;
    if (!std::regex_search(line, match, pattern)) continue;
    ++count;
    EXPECT_NE(text.find("| " + match[1].str() + " |"), std::string::npos) << match[1].str();
  }
  EXPECT_GT(count, 5u);
}

TEST(LibraryReadme, ListsEveryFolder) {
  const std::string text = text_of_file("libsurfmesh/README.md");
  std::set<std::string> folders;
  for (const auto& file : testing::library_sources()) folders.insert(file.folder);
  folders.erase("");
  for (const std::string& folder : folders) {
    EXPECT_NE(text.find("| " + folder + " |"), std::string::npos) << folder;
  }
}

/// What a pattern's first group matches in a text.
std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    found.insert((*match)[1]);
  }
  return found;
}

TEST(LibraryDocuments, NameFilesThatExist) {
  static const std::regex pattern(R"(`([\w/]+/\w+\.(?:hh|cc|sh|json|txt))`)");
  const std::filesystem::path root(SURFMESH_SOURCE_DIR);
  for (const char* document : {"libsurfmesh/README.md", "libsurfmesh/DECISIONS.md"}) {
    const auto files = matches(text_of_file(document), pattern);
    EXPECT_GT(files.size(), 5u);
    for (const std::string& file : files) {
      EXPECT_TRUE(std::filesystem::exists(root / file) ||
                  std::filesystem::exists(root / "libsurfmesh/surfmesh" / file))
          << document << " names " << file;
    }
  }
}

/// The tests of all sources, as "Suite.Name".
std::set<std::string> test_names() {
  static const std::regex pattern(R"(^TEST(?:_F|_P)?\((\w+), (\w+)\))");
  std::set<std::string> names;
  for (const auto& file : testing::project_sources()) {
    for (const std::string& line : file.code) {
      std::smatch match;
      if (std::regex_search(line, match, pattern)) names.insert(match.format("$1.$2"));
    }
  }
  return names;
}

TEST(Decisions, NameTestsThatExist) {
  static const std::regex pattern(R"(`([A-Z]\w+\.[A-Z]\w+)`)");
  const auto existing = test_names();
  const auto named = matches(text_of_file("libsurfmesh/DECISIONS.md"), pattern);
  EXPECT_GT(named.size(), 10u);
  for (const std::string& name : named) EXPECT_EQ(existing.count(name), 1u) << name;
}

/// Each source of the list as "Surname", with its year.
std::vector<std::pair<std::string, std::string>> listed_sources() {
  static const std::regex pattern(R"(\n- ([\w-]+),[^:]*\((\d{4})\):)");
  const std::string text = text_of_file("libsurfmesh/README.md");
  std::vector<std::pair<std::string, std::string>> sources;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    sources.emplace_back((*match)[1], (*match)[2]);
  }
  return sources;
}

/// The comments of the library that cite something: "Shewchuk, ... (1997)", "Marsaglia 2003".
std::vector<std::string> citing_lines() {
  static const std::regex pattern(R"(//.*\b(19|20)\d\d\))");
  std::vector<std::string> lines;
  for (const auto& file : testing::library_sources()) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (!std::regex_search(file.lines[i], pattern)) continue;
      lines.push_back((i > 0 ? file.lines[i - 1] : "") + file.lines[i]);
    }
  }
  return lines;
}

bool cites(const std::string& line, const std::pair<std::string, std::string>& source) {
  return line.find(source.first) != std::string::npos &&
         line.find(source.second) != std::string::npos;
}

TEST(LibraryReadme, ListsEverySourceThatIsCited) {
  const auto sources = listed_sources();
  for (const std::string& line : citing_lines()) {
    EXPECT_TRUE(std::any_of(sources.begin(), sources.end(), [&](const auto& source) {
      return cites(line, source);
    })) << line;
  }
}

TEST(LibraryReadme, ListsNoSourceThatIsNotCited) {
  const auto lines = citing_lines();
  EXPECT_GT(listed_sources().size(), 4u);
  for (const auto& source : listed_sources()) {
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                            [&](const std::string& line) { return cites(line, source); }))
        << source.first << ' ' << source.second;
  }
}

}  // namespace
}  // namespace surfmesh
