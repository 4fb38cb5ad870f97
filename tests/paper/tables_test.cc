// SPDX-License-Identifier: BSD-3-Clause
#include "paper/tables.hh"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace surfmesh::paper {
namespace {

Table example() {
  return {"table9",
          "Table 9",
          {{"NT", 1}, {"σ", 2}},
          {{"V_t", {{25.04, 25.0}, {0.129}}}, {"V_o", {{std::nullopt, 7}, {0.2, 0.18}}}}};
}

TEST(PaperTable, HasOursAndThePapersBeside) {
  EXPECT_EQ(to_markdown(example()),
            "### Table 9\n\n"
            "| | NT | σ |\n"
            "|---|--:|--:|\n"
            "| V_t | 25.0 (25.0) | 0.13 |\n"
            "| V_o | – (7.0) | 0.20 (0.18) |\n");
}

TEST(PaperTable, IsFullInJson) {
  const auto json = nlohmann::json::parse(to_json({example()}, "1.2.3", "a machine"));
  EXPECT_EQ(json["version"], "1.2.3");
  EXPECT_EQ(json["machine"], "a machine");
  const auto& rows = json["tables"]["table9"]["rows"];
  EXPECT_EQ(rows[0]["variant"], "V_t");
  EXPECT_EQ(rows[0]["NT"]["ours"], 25.04);
  EXPECT_TRUE(rows[0]["σ"]["paper"].is_null());
  EXPECT_TRUE(rows[1]["NT"]["ours"].is_null());
  EXPECT_EQ(rows[1]["NT"]["paper"], 7);
}

}  // namespace
}  // namespace surfmesh::paper
