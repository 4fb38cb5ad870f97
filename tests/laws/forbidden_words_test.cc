// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

/// Words that tell nothing about what a thing does.
const std::array<std::string, 4> kForbidden = {"manager", "helper", "util", "process"};

/// The words of all identifiers: snake_case and CamelCase taken apart, in lower case.
std::vector<std::string> words_of(const std::string& code) {
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    if (!word.empty()) words.push_back(word);
    word.clear();
  };
  for (std::size_t i = 0; i < code.size(); ++i) {
    const auto c = static_cast<unsigned char>(code[i]);
    const bool begins_hump =
        std::isupper(c) != 0 && i > 0 && std::islower(static_cast<unsigned char>(code[i - 1])) != 0;
    if (std::isalpha(c) == 0 || begins_hump) finish();
    if (std::isalpha(c) != 0) word += static_cast<char>(std::tolower(c));
  }
  finish();
  return words;
}

bool is_forbidden(const std::string& word) {
  return std::any_of(kForbidden.begin(), kForbidden.end(), [&](const std::string& forbidden) {
    return word == forbidden || word == forbidden + "s";
  });
}

TEST(ForbiddenWords, AreInNoIdentifier) {
  for (const auto& file : testing::library_sources_with_parts()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      if (file.code[i].starts_with("#include <")) continue;  // the names of others
      for (const std::string& word : words_of(testing::without_strings(file.code[i]))) {
        EXPECT_FALSE(is_forbidden(word)) << "the word \"" << word << "\"\n" << place(file, i);
      }
    }
  }
}

TEST(ForbiddenWords, AreInNoFileName) {
  for (const auto& file : testing::library_sources_with_parts()) {
    for (const std::string& word : words_of(file.path)) {
      EXPECT_FALSE(is_forbidden(word)) << file.path;
    }
  }
}

TEST(ForbiddenWords, TakesIdentifiersApart) {
  const std::vector<std::string> expected = {"mesh", "manager", "do", "it", "utility"};
  EXPECT_EQ(words_of("MeshManager::do_it(utility)"), expected);
  EXPECT_TRUE(is_forbidden("utils"));
  EXPECT_FALSE(is_forbidden("utility"));
}

}  // namespace
}  // namespace surfmesh
