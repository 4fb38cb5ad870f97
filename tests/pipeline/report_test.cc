// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/report.hh"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "surfmesh/pipeline/set_option.hh"

#include "support/notices.hh"

namespace surfmesh {
namespace {

using Json = nlohmann::ordered_json;

Report example() {
  Report report;
  report.input = "wave.json";
  report.notices = {warning(NoticeKind::ClampedSizes, "a warning"),
                    shortfall(NoticeKind::TurnedTriangles, "a shortfall")};
  report.notices[1].patch = 0;
  report.notices[1].point = Vec3(1, 2, 3);
  report.patches = {{.name = "wing", .groups = {}, .triangles = 1, .area = 0.5}};
  report.mesh = {5, 1, 1, 1, false, 1};
  report.edges.histogram = {{0, 0.25, 7}};
  report.quality.count = 1;
  report.quality.below_0_3 = 0.5;
  report.quads.count = 1;
  report.quads.fraction = 0.5;
  report.control.nodes = 10;
  report.control.faces = 20;
  report.control.classes = {3, 10, 7};
  report.control.queries[Stage::Boundary].triangle = 4;
  report.control.queries[Stage::Refine] = {1, 2, 3, 4, 5, 6, 7, 8, 20};
  report.wall_seconds = 1.5;
  report.seconds[Stage::Refine] = 0.001;
  return report;
}

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

using Keys = std::vector<std::string>;

TEST(ReportJson, HasTheKeysOfTheDocumentation) {
  const Json json = Json::parse(to_json(example()));
  EXPECT_EQ(keys_of(json), (Keys{"version",
                                 "input",
                                 "output",
                                 "files",
                                 "given",
                                 "options",
                                 "notices",
                                 "estimated_elements",
                                 "mesh",
                                 "patches",
                                 "groups",
                                 "diagonal",
                                 "tolerance",
                                 "edge_lengths",
                                 "edges",
                                 "quality",
                                 "quads",
                                 "sag",
                                 "refine",
                                 "control",
                                 "seconds",
                                 "triangles_per_second",
                                 "triangles_per_second_in_all"}));
  EXPECT_EQ(keys_of(json["mesh"]),
            (Keys{"vertices", "triangles", "quads", "patches", "closed", "euler"}));
  EXPECT_EQ(keys_of(json["edges"]),
            (Keys{"count", "mean", "stddev", "min", "max", "unit_fraction", "histogram"}));
  EXPECT_EQ(keys_of(json["quality"]), (Keys{"min", "mean", "below_0.3", "worst"}));
  EXPECT_EQ(
      keys_of(json["quads"]),
      (Keys{"fraction", "min_scaled_jacobian", "mean_scaled_jacobian",
            "min_scaled_jacobian_in_space", "mean_scaled_jacobian_in_space", "inverted",
            "below_0.1", "folded_in_space", "irregular_vertices", "worst", "worst_in_space"}));
  EXPECT_EQ(keys_of(json["sag"]), (Keys{"asked", "reached", "evaluations"}));
  EXPECT_EQ(keys_of(json["control"]), (Keys{"kind", "nodes", "faces", "precision", "classes",
                                            "queries", "answers", "walks"}));
  EXPECT_EQ(keys_of(json["refine"]),
            (Keys{"inserted", "left_too_large", "circumcentres_given_up"}));
  EXPECT_EQ(keys_of(json["seconds"]),
            (Keys{"read", "control", "boundary", "triangulate", "refine", "improve", "quad",
                  "assemble", "across", "write", "total", "wall"}));
}

TEST(ReportJson, CountsQuestionsByStageAndAnswersByKind) {
  const Json control = Json::parse(to_json(example()))["control"];
  EXPECT_EQ(control["classes"], Json::parse(R"({"s": 3, "t": 10, "o": 7, "linear": 0})"));
  EXPECT_EQ(
      control["answers"],
      Json::parse(
          R"({"s": 1, "t": 6, "o": 3, "linear": 4, "lattice": 5, "extended": 6, "reused": 7})"));
  EXPECT_EQ(control["walks"], Json::parse(R"({"count": 8, "mean_steps": 2.5})"));
  EXPECT_EQ(control["queries"]["boundary"], 4);
  EXPECT_EQ(control["queries"]["refine"], 28);
  EXPECT_EQ(keys_of(control["queries"]),
            (Keys{"boundary", "triangulate", "refine", "improve", "quad", "across"}));
}

TEST(ReportJson, HasTheFigures) {
  const Json json = Json::parse(to_json(example()));
  EXPECT_EQ(json["mesh"]["closed"], false);
  EXPECT_EQ(json["quality"]["below_0.3"], 0.5);
  EXPECT_EQ(json["quads"]["fraction"], 0.5);
  EXPECT_EQ(json["edges"]["histogram"], Json::parse(R"([{"from": 0.0, "to": 0.25, "count": 7}])"));
  EXPECT_TRUE(json["sag"]["asked"].is_null());
}

TEST(ReportJson, TellsNoticesAsData) {
  const Json notices = Json::parse(to_json(example()))["notices"];
  ASSERT_EQ(notices.size(), 2U);
  EXPECT_EQ(keys_of(notices[0]),
            (Keys{"kind", "severity", "text", "patch", "contour", "point", "count"}));
  EXPECT_EQ(notices[0]["kind"], "clamped_sizes");
  EXPECT_EQ(notices[0]["severity"], "warning");
  EXPECT_TRUE(notices[0]["patch"].is_null());
  EXPECT_TRUE(notices[0]["point"].is_null());
  EXPECT_EQ(notices[1]["severity"], "shortfall");
  EXPECT_EQ(notices[1]["text"], "a shortfall");
  EXPECT_EQ(notices[1]["patch"], "wing");
  EXPECT_EQ(notices[1]["point"], (Json{1.0, 2.0, 3.0}));
  EXPECT_EQ(notices[1]["count"], 1);
}

TEST(ReportJson, ListsEveryOptionWithItsEffectiveValue) {
  Report report = example();
  set_option(report.options, "hmin", "0.07%");
  set_option(report.options, "nodes", "400");
  const Json options = Json::parse(to_json(report))["options"];
  EXPECT_EQ(options.size(), option_names().size());
  EXPECT_EQ(options["hmin"], "0.07%");
  EXPECT_EQ(options["nodes"], 400);
  EXPECT_EQ(options["quads"], false);
  EXPECT_EQ(options["curvature"], 0.25);
}

TEST(ReportJson, TellsOptionsAsGivenAndFrom) {
  Report report = example();
  set_option(report.options, "hmin", "0.07%");
  Model model;
  model.made_with = {{"weld", "0.01"}, {"weld", "0.02", "knob:"}, {"patches", "auto", "knob:"}};
  report.given = options_of_file(report.options, model);
  add_given({"hmax", "5%", OptionOrigin::CommandLine}, report.given);
  EXPECT_EQ(Json::parse(to_json(report))["given"],
            Json::parse(R"({"hmin": {"value": "0.07%", "from": "model file"},
                            "knob:weld": {"value": "0.02", "from": "model file"},
                            "hmax": {"value": "5%", "from": "command line"}})"));
}

TEST(ReportJson, SumsPatchesByGroup) {
  Report report = example();
  report.patches = {
      {"a", {"g"}, 1, 0, 0, 0.5, 0.9}, {"b", {"h", "g"}, 2, 0, 0, 1.5, 0.7}, {"c", {}, 4, 0, 0, 1}};
  const Json json = Json::parse(to_json(report));
  EXPECT_EQ(json["groups"][0],
            Json::parse(R"({"name": "g", "patches": 2, "triangles": 3, "quads": 0, "area": 2.0,
                            "least_quality": 0.7, "least_scaled_jacobian": null})"));
  EXPECT_EQ(json["groups"][1]["name"], "h");
  EXPECT_TRUE(json["patches"][2]["least_quality"].is_null());
}

TEST(ReportJson, HoldsNamesThatAreNotUtf8) {
  Report report = example();
  report.input = "caf\xe9.obj";
  EXPECT_TRUE(Json::accept(to_json(report)));
}

TEST(ReportText, IsShort) {
  const std::string text = to_text(example());
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 12);
  for (const char* key : {"mesh", "edges", "quality", "control", "time", "notices"}) {
    EXPECT_NE(text.find(key), std::string::npos) << key;
  }
}

}  // namespace
}  // namespace surfmesh
