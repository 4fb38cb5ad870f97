// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/clean_text.hh"

#include <gtest/gtest.h>

namespace surfmesh {
namespace {

#define REPLACED "\xEF\xBF\xBD"

TEST(CleanText, KeepsWhatIsUtf8) {
  for (const char* text : {"", "plain ~ <&>", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9D\x84\x9E",
                           "\xED\x9F\xBF", "\xF4\x8F\xBF\xBD", REPLACED, "\x7F"}) {
    EXPECT_EQ(clean_text(text), text);
  }
}

TEST(CleanText, ReplacesControlCharacters) {
  EXPECT_EQ(clean_text("a\tb\x01"
                       "c\n"),
            "a" REPLACED "b" REPLACED "c" REPLACED);
  EXPECT_EQ(clean_text(std::string_view("\0", 1)), REPLACED);
}

TEST(CleanText, ReplacesBytesThatAreNoCharacter) {
  EXPECT_EQ(clean_text("caf\xE9 x"), "caf" REPLACED " x") << "Latin-1";
  EXPECT_EQ(clean_text("\xC3"), REPLACED) << "cut off";
  EXPECT_EQ(clean_text("\x80z"), REPLACED "z") << "begins in the middle";
  EXPECT_EQ(clean_text("\xC0\xAF"), REPLACED REPLACED) << "a long form of /";
  EXPECT_EQ(clean_text("\xED\xA0\x80"), REPLACED REPLACED REPLACED) << "half of a pair";
  EXPECT_EQ(clean_text("\xF4\x90\x80\x80"), REPLACED REPLACED REPLACED REPLACED) << "beyond all";
  EXPECT_EQ(clean_text("\xEF\xBF\xBF"), REPLACED REPLACED REPLACED) << "no character of XML";
  EXPECT_EQ(clean_text("\xFF"), REPLACED);
}

#undef REPLACED

}  // namespace
}  // namespace surfmesh
