// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

/// A number below 1e-3 by its spelling: 1e-9, 2.5E-12, 0.0001.
bool has_small_literal(const std::string& code) {
  static const std::regex pattern(R"((^|[^\w.])(\d+\.?\d*|\.\d+)[eE]-\d|(^|[^\w.])0?\.000\d)");
  return std::regex_search(testing::without_strings(code), pattern);
}

/// `const double kName = ...`, whose comment tells the reason of the value.
bool names_a_constant(const std::string& code) {
  static const std::regex pattern(R"(\bconst(expr)?\b.*\bk[A-Z]\w*\s*(=|\{))");
  return std::regex_search(code, pattern);
}

TEST(NoBareEpsilon, StandsInTheLibrary) {
  for (const auto& file : testing::library_sources_with_parts()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_TRUE(!has_small_literal(file.code[i]) || names_a_constant(file.code[i]))
          << "give the tolerance a name and a reason\n"
          << place(file, i);
    }
  }
}

TEST(NoBareEpsilon, SeesSmallNumbers) {
  EXPECT_TRUE(has_small_literal("if (x < 1e-9)"));
  EXPECT_TRUE(has_small_literal("x=1.0e-12;"));
  EXPECT_TRUE(has_small_literal("f(2.E-3, .5e-4)"));
  EXPECT_TRUE(has_small_literal("return 0.0001;"));
  EXPECT_FALSE(has_small_literal("0.001 + 1e9 + 0.5 - 1"));
  EXPECT_FALSE(has_small_literal("\"to 1e-9 of the diagonal\""));
  EXPECT_FALSE(has_small_literal("size-1, e-2, me-3"));
}

TEST(NoBareEpsilon, KnowsNamedConstants) {
  EXPECT_TRUE(names_a_constant("constexpr double kLoopGap = 1e-6;"));
  EXPECT_TRUE(names_a_constant("inline constexpr double kGap{1e-6};"));
  EXPECT_FALSE(names_a_constant("const double gap = 1e-6;"));
}

}  // namespace
}  // namespace surfmesh
