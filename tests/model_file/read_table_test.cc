// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_table.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/errors.hh"

namespace surfmesh {
namespace {

std::vector<TableNode> parse(const std::string& text) { return parse_table(text, "t.csv", {}); }

std::string table_fault(const std::string& text) {
  return error_of([&] { parse(text); });
}

TEST(ReadTable, ReadsSizes) {
  const auto nodes = parse("u,v,size\n0,0,0.1\n1 , 0.5, 2e-1\r\n\n# a comment\n0.25,1,3");
  ASSERT_EQ(nodes.size(), 3u);
  EXPECT_EQ(nodes[1].uv, (Uv{1, 0.5}));
  EXPECT_EQ(nodes[1].size.along.value, 0.2);
  EXPECT_EQ(nodes[1].size.across.value, 0.2);
  EXPECT_TRUE(std::isnan(nodes[1].metric.m11));
}

TEST(ReadTable, ReadsStretchedSizesInDegrees) {
  const auto nodes = parse("u, v, ls, lt, angle\n0,0,0.1,0.3,90\n");
  EXPECT_EQ(nodes.at(0).size.across.value, 0.3);
  EXPECT_DOUBLE_EQ(nodes[0].size.angle, std::numbers::pi / 2);
}

TEST(ReadTable, ReadsMetrics) {
  EXPECT_EQ(parse("u,v,m11,m12,m22\n0,0,4,-1,2\n").at(0).metric, (Metric{4, -1, 2}));
}

TEST(ReadTable, SkipsAByteOrderMark) {
  EXPECT_EQ(parse("\xEF\xBB\xBFu,v,size\n0,0,0.5\n").at(0).size.along.value, 0.5);
}

TEST(ReadTable, TakesAnyAngle) {
  EXPECT_TRUE(std::isfinite(parse("u,v,ls,lt,angle\n0,0,1,2,1e308\n").at(0).size.angle));
}

TEST(ReadTable, TellsTheLineOfWhatWouldOverflow) {
  const std::string front = "invalid input: t.csv:2: ";
  const std::string header = "u,v,m11,m12,m22\n";
  const std::string entries = front + "m11 and m22 must be between 1e-100 and 1e+100";
  EXPECT_EQ(table_fault(header + "0,0,1e200,0,1e200\n"), entries);
  EXPECT_EQ(table_fault(header + "0,0,1,0,1e101\n"), entries);
  EXPECT_EQ(table_fault(header + "0,0,1e-170,0,1e-170\n"), entries);
  EXPECT_EQ(table_fault(header + "0,0,1,1e200,1\n"), front + "the metric is not positive definite");
  EXPECT_EQ(table_fault(header + "0,0,-1e200,0,1\n"),
            front + "the metric is not positive definite");
  EXPECT_EQ(parse(header + "0,0,1e-100,0,1e-100\n").at(0).metric, (Metric{1e-100, 0, 1e-100}));
  const std::string lengths = front + "a size must be between 1e-50 and 1e+50";
  EXPECT_EQ(table_fault("u,v,size\n0,0,1e200\n"), lengths);
  EXPECT_EQ(table_fault("u,v,ls,lt,angle\n0,0,1,1e-170,0\n"), lengths);
}

TEST(ReadTable, TellsTheLineOfAFault) {
  const std::string front = "invalid input: t.csv:";
  EXPECT_EQ(table_fault("u,v\n"),
            front +
                "1: the first line must name the columns: u,v,size or u,v,ls,lt,angle or "
                "u,v,m11,m12,m22");
  EXPECT_EQ(table_fault("u,v,size\n0,0\n"), front + "2: the row has 2 values, the table 3 columns");
  EXPECT_EQ(table_fault("u,v,size\n\n0,0,x\n"), front + "3: 'x' is not a number");
  EXPECT_EQ(table_fault("u,v,size\n0,0,nan\n"), front + "2: 'nan' is not a number");
  EXPECT_EQ(table_fault("u,v,size\n0,0,0\n"), front + "2: a size must be above 0");
  EXPECT_EQ(table_fault("u,v,size\n0,2,1\n"),
            front + "2: the point (0, 2) is outside of the domain");
  EXPECT_EQ(table_fault("u,v,m11,m12,m22\n0,0,1,2,1\n"),
            front + "2: the metric is not positive definite");
  EXPECT_EQ(table_fault("u,v,size\n"), front + " the table has no rows");
  EXPECT_EQ(table_fault(""), front + " the table has no rows");
  EXPECT_EQ(error_of([] { read_table("no.csv", {}); }),
            "io: cannot read no.csv: it does not exist");
}

}  // namespace
}  // namespace surfmesh
