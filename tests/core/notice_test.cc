// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/notice.hh"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace surfmesh {
namespace {

TEST(NoticeKind, HasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kNoticeKinds; ++i) names.insert(name(static_cast<NoticeKind>(i)));
  EXPECT_EQ(names.size(), kNoticeKinds);
  EXPECT_EQ(names.count("unknown"), 0U);
  EXPECT_EQ(name(static_cast<NoticeKind>(kNoticeKinds)), "unknown");
}

Notices many(std::size_t count) {
  Notices notices;
  for (std::size_t i = 0; i < count; ++i) {
    notices.push_back(warning(NoticeKind::UnjoinedSides, "sides " + std::to_string(i)));
  }
  return notices;
}

TEST(Notices, CountWhatComesAgain) {
  Notices notices = {warning(NoticeKind::TurnedLoop, "a")};
  append({warning(NoticeKind::TurnedLoop, "a"), warning(NoticeKind::NarrowGap, "a"),
          warning(NoticeKind::TurnedLoop, "b"), warning(NoticeKind::TurnedLoop, "b")},
         notices);
  ASSERT_EQ(notices.size(), 3U);
  EXPECT_EQ(notices[0].count, 2U);
  EXPECT_EQ(notices[1].count, 1U);
  EXPECT_EQ(notices[2].count, 2U);
}

TEST(Notices, HaveAShortfallIfOneIs) {
  Notices notices = many(2);
  EXPECT_FALSE(has_shortfall(notices));
  notices.push_back(shortfall(NoticeKind::GivenUp, "given up"));
  EXPECT_TRUE(has_shortfall(notices));
}

TEST(NoticeLines, TellTheSeverityAndHowOften) {
  Notices notices = {warning(NoticeKind::IgnoredInput, "odd"),
                     shortfall(NoticeKind::GivenUp, "given up"),
                     information(NoticeKind::ChosenSurface, "a mesh")};
  notices[0].count = 4;
  EXPECT_EQ(lines_of(notices), (std::vector<std::string>{"warning: odd (and 3 more)",
                                                         "not reached: given up", "note: a mesh"}));
}

TEST(Severity, HasANameOfItsOwn) {
  EXPECT_EQ(name(Severity::Warning), "warning");
  EXPECT_EQ(name(Severity::Shortfall), "shortfall");
  EXPECT_EQ(name(Severity::Information), "information");
}

TEST(NoticeLines, ListAFewOfAKind) {
  EXPECT_EQ(lines_of(many(4)).size(), 4U);  // rather than three and "1 more"
  const auto lines = lines_of(many(12));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], "warning: sides 0");
  EXPECT_EQ(lines[2], "warning: sides 2; and 9 more like these");
}

TEST(NoticeLines, CountTheSameAtOtherLocations) {
  const auto turned = NoticeKind::TurnedLoop;
  Notices notices = {warning_at("loop 0", turned, "it is turned"),
                     warning_at("loop 1", turned, "it is turned"),
                     warning_at("patch a, loop 2", turned, "it is not")};
  for (std::size_t i = 0; i < 2; ++i) locate("a.json", notices[i]);
  EXPECT_EQ(lines_of(notices),
            (std::vector<std::string>{"warning: a.json: loop 0: it is turned (and 1 more)",
                                      "warning: patch a, loop 2: it is not"}));
}

TEST(NoticeLines, KeepApartWhatDiffersBeforeAColonOfTheText) {
  const auto kind = NoticeKind::UnjoinedSides;
  const Notices notices = {warning(kind, "sides a and b nearly meet: joining = 1e-3 joins them"),
                           warning(kind, "sides c and d nearly meet: joining = 1e-3 joins them")};
  EXPECT_EQ(lines_of(notices).size(), 2u);
}

TEST(NoticeLines, KeepApartWhatDiffersInSeverity) {
  const auto kind = NoticeKind::SurfaceJump;
  EXPECT_EQ(lines_of({warning(kind, "it jumps"), shortfall(kind, "it jumps")}).size(), 2u);
}

}  // namespace
}  // namespace surfmesh
