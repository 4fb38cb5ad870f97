// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/text_table.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

namespace surfmesh::detail {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

using Lines = std::vector<std::string>;

TEST(TextTable, WrapsValuesBetweenWords) {
  TextTable table({});
  table.add("mesh", std::string(60, 'a') + ' ' + std::string(9, 'b') + " c");
  table.add("", std::string(100, 'd') + " e");
  EXPECT_EQ(lines_of(table.take()),
            (Lines{"mesh      " + std::string(60, 'a') + ' ' + std::string(9, 'b'), "          c",
                   "          " + std::string(100, 'd'), "          e"}));
}

TEST(TextTable, KeepsALineWhole) {
  TextTable table({});
  table.add_line("input", std::string(60, 'a') + ' ' + std::string(60, 'b'));
  EXPECT_EQ(lines_of(table.take()).size(), 1u);
}

TEST(TextTable, CountsColumnsNotBytes) {
  EXPECT_EQ(columns("√½ ≤ 1"), 6u);
  TextTable table({});
  table.add("a", "√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√ √√√√√√√√√√√√√√√√√√√√√√√√√√√√√");
  EXPECT_EQ(lines_of(table.take()).size(), 1u);
}

TEST(TextTable, AlignsColumns) {
  TextTable table({});
  table.add_rows({"patch", "area"}, {{"wing", "1.5"}, {"a", "1234.25"}});
  EXPECT_EQ(lines_of(table.take()), (Lines{"patch     area", "wing       1.5", "a      1234.25"}));
}

TEST(TextTable, CutsLongNamesBetweenLetters) {
  TextTable table({});
  table.add_rows({"patch", "n"}, {{std::string(19, 'x') + "√√", "1"}, {std::string(20, 'y'), "2"}});
  EXPECT_EQ(lines_of(table.take()),
            (Lines{"patch                 n", std::string(17, 'x') + "...  1",
                   std::string(20, 'y') + "  2"}));
  table.add_rows({"p"}, {{"√√√√√√√√√√√√√√√√√√√√√"}});
  EXPECT_EQ(lines_of(table.take())[1], "√√√√√√√√√√√√√√√√√...");
}

const std::array kBins = {HistogramBin{0, 1, 8}, HistogramBin{1, 2, 1}, HistogramBin{2, 3, 0},
                          HistogramBin{3, 4, 991}};

TEST(TextTable, SumsTheBinsBetweenLimits) {
  const auto rows = rows_between(kBins, std::array{0.0, 2.0, 3.0});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].label, "0 to 2");
  EXPECT_EQ(rows[0].count, 9u);
  EXPECT_EQ(rows[1].count, 0u);
  EXPECT_EQ(rows[2].label, "3 to 4");
  EXPECT_EQ(rows[2].count, 991u);
}

HistogramText example() {
  return {.heading = {"heights"},
          .rows = rows_between(kBins, std::array{0.0, 1.0, 2.0, 3.0}),
          .share = {"low", 9},
          .total = 1000};
}

TEST(TextTable, DrawsAHistogram) {
  TextTable table({});
  table.add_histograms(example(), {});
  EXPECT_EQ(lines_of(table.take()), (Lines{"heights",                                 //
                                           "0 to 1               8   0.8 % .",        //
                                           "1 to 2               1   0.1 % .",        //
                                           "2 to 3               0   0.0 %",          //
                                           "3 to 4             991  99.1 % ########"  //
                                           ,
                                           "low                  9  0.90 %"}));
}

TEST(TextTable, DrawsEighthsOfBlocksWhereItMay) {
  TextTable table({.has_unicode = true});
  HistogramText half = example();
  half.rows = {{"a", 1000}, {"b", 330}, {"c", 1}};
  half.share = {};
  table.add_histograms(half, {});
  const Lines lines = lines_of(table.take());
  EXPECT_EQ(lines[1], "a                 1000 100.0 % ████████");
  EXPECT_EQ(lines[2], "b                  330  33.0 % ██▋");
  EXPECT_EQ(lines[3], "c                    1   0.1 % ▏");
}

TEST(TextTable, PutsTwoHistogramsSideBySide) {
  TextTable table({});
  table.add_histograms(example(), example());
  for (const std::string& line : lines_of(table.take())) {
    EXPECT_LE(columns(line), kTextWidth);
    EXPECT_EQ(line.substr(0, line.find("  ")), line.substr(41, line.find("  ", 41) - 41));
  }
}

TEST(TextTable, ShowsTheRangesThatUsersKnow) {
  EdgeStatistics edges;
  for (int i = -8; i < 8; ++i) {
    edges.histogram.push_back({i == -8 ? 0 : std::exp2(0.25 * i), std::exp2(0.25 * (i + 1)), 1});
  }
  const HistogramText text = length_text(edges, {});
  Lines labels;
  for (const HistogramRow& row : text.rows) labels.push_back(row.label);
  EXPECT_EQ(labels,
            (Lines{"0 to 0.5", "0.5 to 0.707", "0.707 to 1", "1 to 1.41", "1.41 to 2", "2 to 4"}));
  std::vector<std::size_t> counts;
  for (const HistogramRow& row : text.rows) counts.push_back(row.count);
  EXPECT_EQ(counts, (std::vector<std::size_t>{4, 2, 2, 2, 2, 4}));
  EXPECT_EQ(length_text(edges, {.is_long = true}).rows.size(), 16u);
}

TEST(TextTable, ShowsQualitiesFromTheBestToTheWorst) {
  QualityStatistics quality;
  quality.count = 12;
  quality.below_0_3 = 0.25;
  quality.histogram = {{-1, 0, 1}};
  for (int i = 0; i < 10; ++i) quality.histogram.push_back({0.1 * i, 0.1 * (i + 1), 1});
  const HistogramText text = quality_text("quality", quality, {});
  Lines labels;
  for (const HistogramRow& row : text.rows) labels.push_back(row.label);
  EXPECT_EQ(labels, (Lines{"0.9 to 1", "0.8 to 0.9", "0.6 to 0.8", "0.3 to 0.6", "0 to 0.3",
                           "turned over"}));
  EXPECT_EQ(text.rows[4].count, 3u);
  EXPECT_EQ(text.share.count, 3u);
  EXPECT_EQ(quality_text("quality", quality, {.is_long = true}).rows.size(), 11u);
}

}  // namespace
}  // namespace surfmesh::detail
