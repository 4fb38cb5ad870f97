// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.hh"

namespace surfmesh {
namespace {

using SurfmeshPaper = Program;

TEST_F(SurfmeshPaper, MakesAllTablesAndFigures) {
  ASSERT_EQ(run("-o made/here --rounds 1"), 0) << err_;
  const auto made = folder_ / "made" / "here";
  const std::string tables = read_text(made / "tables.md");
  const auto json = nlohmann::json::parse(read_text(made / "tables.json"));
  for (const char* number : {"1", "2", "3", "4", "5"}) {
    EXPECT_NE(tables.find(std::string("### Table ") + number), std::string::npos);
    EXPECT_GT(json["tables"][std::string("table") + number]["rows"].size(), 1U);
  }
  EXPECT_EQ(json["tables"]["variants_in_the_papers_way"]["rows"].size(), 36U);
  EXPECT_EQ(json["tables"]["variants_today"]["rows"].size(), 18U);
  for (const char* number : {"1", "4", "5", "6", "7", "8", "9", "10"}) {
    const std::string svg = read_text(made / (std::string("figure") + number + ".svg"));
    EXPECT_TRUE(svg.starts_with("<svg ") && svg.ends_with("</svg>\n")) << number;
    EXPECT_LT(svg.size(), 1'000'000U) << number;
    EXPECT_EQ(svg.find("nan"), std::string::npos) << number;
  }
  EXPECT_EQ(read_text(made / "example2.json"), read_text(own_model("paper/example2.json")));
  EXPECT_TRUE(says("example 3"));
}

TEST_F(SurfmeshPaper, TellsWrongUsage) {
  EXPECT_EQ(run(""), 2);
  EXPECT_TRUE(says("--output is required"));
  EXPECT_EQ(run("-o x --rounds 0"), 2);
  EXPECT_EQ(run("-o x --wrong"), 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x"));
}

TEST_F(SurfmeshPaper, TellsAFolderThatCannotBe) {
  ASSERT_EQ(shell("touch file"), 0);
  EXPECT_EQ(run("-o file/x"), 1);
  EXPECT_TRUE(says("surfmesh-paper: error: "));
  EXPECT_EQ(run("-o file"), 1);
  EXPECT_TRUE(says("cannot make the folder 'file'"));
}

TEST_F(SurfmeshPaper, TellsAFileThatCannotBeBeforeItBegins) {
  ASSERT_EQ(shell("mkdir -p out/tables.md"), 0);
  EXPECT_EQ(run("-o out"), 1);
  EXPECT_TRUE(says("tables.md"));
  EXPECT_FALSE(says("example 1"));
}

TEST_F(SurfmeshPaper, HasAHelp) {
  EXPECT_EQ(run("--help"), 0);
  EXPECT_TRUE(says("tables.md"));
  EXPECT_EQ(run("--version"), 0);
  EXPECT_TRUE(says("surfmesh-paper "));
}

}  // namespace
}  // namespace surfmesh
