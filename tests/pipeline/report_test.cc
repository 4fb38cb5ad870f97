// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/report.hh"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "surfmesh/pipeline/set_option.hh"
#include "surfmesh/pipeline/text_table.hh"

#include "support/notices.hh"

namespace surfmesh {
namespace {

using OrderedJson = nlohmann::ordered_json;

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
  report.surfaces = {{.part = "fish:", .vertices = 7, .fit = 0, .distance = 0.25}};
  report.wall_seconds = 1.5;
  report.seconds[Stage::Refine] = 0.001;
  return report;
}

std::vector<std::string> keys_of(const OrderedJson& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

using Keys = std::vector<std::string>;

TEST(ReportJson, HasTheKeysOfTheDocumentation) {
  const OrderedJson json = OrderedJson::parse(to_json(example()));
  EXPECT_EQ(keys_of(json), (Keys{"version",
                                 "input",
                                 "output",
                                 "files",
                                 "given",
                                 "options",
                                 "notices",
                                 "estimated_elements",
                                 "mesh",
                                 "tiles",
                                 "pieces",
                                 "patches",
                                 "groups",
                                 "surfaces",
                                 "diagonal",
                                 "tolerance",
                                 "edge_lengths",
                                 "edges",
                                 "quality",
                                 "quads",
                                 "sag",
                                 "facets",
                                 "refine",
                                 "control",
                                 "seconds",
                                 "triangles_per_second",
                                 "triangles_per_second_in_all"}));
  EXPECT_EQ(
      keys_of(json["surfaces"][0]),
      (Keys{"part", "vertices", "fit", "greatest_distance", "mean_distance", "greatest_move",
            "moved_vertex", "creases", "corners", "wavy_share", "greatest_wave", "noisy_share"}));
  EXPECT_EQ(keys_of(json["mesh"]),
            (Keys{"vertices", "triangles", "quads", "patches", "closed", "euler"}));
  EXPECT_EQ(keys_of(json["edges"]),
            (Keys{"count", "mean", "stddev", "min", "max", "unit_fraction", "histogram"}));
  EXPECT_EQ(keys_of(json["quality"]), (Keys{"min", "mean", "below_0.3", "histogram", "worst"}));
  EXPECT_EQ(keys_of(json["quads"]),
            (Keys{"fraction", "min_scaled_jacobian", "mean_scaled_jacobian",
                  "min_scaled_jacobian_in_space", "mean_scaled_jacobian_in_space", "inverted",
                  "below_0.1", "folded_in_space", "irregular_vertices", "histogram", "worst",
                  "worst_in_space"}));
  EXPECT_EQ(keys_of(json["sag"]), (Keys{"asked", "reached", "evaluations"}));
  EXPECT_EQ(keys_of(json["control"]), (Keys{"kind", "nodes", "faces", "precision", "classes",
                                            "queries", "answers", "walks"}));
  EXPECT_EQ(keys_of(json["refine"]),
            (Keys{"inserted", "left_too_large", "circumcentres_given_up"}));
  EXPECT_EQ(keys_of(json["seconds"]),
            (Keys{"read", "control", "boundary", "triangulate", "refine", "improve", "quad",
                  "assemble", "across", "write", "total", "serial", "wall"}));
}

TEST(ReportJson, CountsQuestionsByStageAndAnswersByKind) {
  const OrderedJson control = OrderedJson::parse(to_json(example()))["control"];
  EXPECT_EQ(control["classes"], OrderedJson::parse(R"({"s": 3, "t": 10, "o": 7, "linear": 0})"));
  EXPECT_EQ(
      control["answers"],
      OrderedJson::parse(
          R"({"s": 1, "t": 6, "o": 3, "linear": 4, "lattice": 5, "extended": 6, "reused": 7})"));
  EXPECT_EQ(control["walks"], OrderedJson::parse(R"({"count": 8, "mean_steps": 2.5})"));
  EXPECT_EQ(control["queries"]["boundary"], 4);
  EXPECT_EQ(control["queries"]["refine"], 28);
  EXPECT_EQ(keys_of(control["queries"]),
            (Keys{"boundary", "triangulate", "refine", "improve", "quad", "across"}));
}

TEST(ReportJson, HasTheFigures) {
  const OrderedJson json = OrderedJson::parse(to_json(example()));
  EXPECT_EQ(json["mesh"]["closed"], false);
  EXPECT_EQ(json["quality"]["below_0.3"], 0.5);
  EXPECT_EQ(json["quads"]["fraction"], 0.5);
  EXPECT_EQ(json["edges"]["histogram"],
            OrderedJson::parse(R"([{"from": 0.0, "to": 0.25, "count": 7}])"));
  EXPECT_TRUE(json["sag"]["asked"].is_null());
}

TEST(ReportJson, TellsOfTilesAndPieces) {
  Report report = example();
  OrderedJson json = OrderedJson::parse(to_json(report));
  EXPECT_TRUE(json["tiles"].is_null());
  EXPECT_TRUE(json["pieces"].is_null());
  report.tiles = {12, 2};
  report.pieces = {.count = 3,
                   .faces_of_ranks = {10, 30},
                   .seconds_of_ranks = {0.5, 0.75},
                   .of_several_pieces = 7,
                   .of_several_ranks = 4,
                   .bytes_sent = 1000};
  json = OrderedJson::parse(to_json(report));
  EXPECT_EQ(json["tiles"], OrderedJson::parse(R"({"count": 12, "refused": 2})"));
  EXPECT_EQ(json["pieces"],
            OrderedJson::parse(R"({"count": 3, "ranks": 2, "faces_of_ranks": [10, 30],
                            "largest_share": 1.5, "seconds_of_ranks": [0.5, 0.75],
                            "vertices_of_several_pieces": 7, "vertices_of_several_ranks": 4,
                            "bytes_sent": 1000})"));
  report.pieces->seconds_of_ranks.clear();
  json = OrderedJson::parse(to_json(report));
  EXPECT_TRUE(json["pieces"]["seconds_of_ranks"].is_null());
}

TEST(ReportText, TellsOfTilesAndPieces) {
  Report report = example();
  EXPECT_EQ(to_text(report, {.is_long = true}).find("tile"), std::string::npos);
  report.tiles = {12, 2};
  EXPECT_EQ(to_text(report).find("tile"), std::string::npos);
  EXPECT_NE(to_text(report, {.is_long = true})
                .find("tiles     12 tiles of 1 patch; 2 stay larger than asked"),
            std::string::npos);
  report.pieces.emplace();
  report.pieces->count = 3;
  report.pieces->faces_of_ranks = {10, 30};
  report.pieces->of_several_pieces = 7;
  const std::string text = to_text(report);
  EXPECT_NE(text.find("pieces    3 on 2 ranks; 7 vertices in several pieces, 0 on several ranks"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("the largest share is 1.50 of that"), std::string::npos) << text;
}

TEST(ReportJson, TellsNoticesAsData) {
  const OrderedJson notices = OrderedJson::parse(to_json(example()))["notices"];
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
  EXPECT_EQ(notices[1]["point"], (OrderedJson{1.0, 2.0, 3.0}));
  EXPECT_EQ(notices[1]["count"], 1);
}

TEST(ReportJson, ListsEveryOptionWithItsEffectiveValue) {
  Report report = example();
  set_option(report.options, "hmin", "0.07%");
  set_option(report.options, "nodes", "400");
  const OrderedJson options = OrderedJson::parse(to_json(report))["options"];
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
  EXPECT_EQ(OrderedJson::parse(to_json(report))["given"],
            OrderedJson::parse(R"({"hmin": {"value": "0.07%", "from": "model file"},
                            "knob:weld": {"value": "0.02", "from": "model file"},
                            "hmax": {"value": "5%", "from": "command line"}})"));
}

TEST(ReportJson, SumsPatchesByGroup) {
  Report report = example();
  report.patches = {
      {"a", {"g"}, 1, 0, 0, 0.5, 0.9}, {"b", {"h", "g"}, 2, 0, 0, 1.5, 0.7}, {"c", {}, 4, 0, 0, 1}};
  const OrderedJson json = OrderedJson::parse(to_json(report));
  EXPECT_EQ(
      json["groups"][0],
      OrderedJson::parse(R"({"name": "g", "patches": 2, "triangles": 3, "quads": 0, "area": 2.0,
                            "least_quality": 0.7, "least_scaled_jacobian": null})"));
  EXPECT_EQ(json["groups"][1]["name"], "h");
  EXPECT_TRUE(json["patches"][2]["least_quality"].is_null());
}

TEST(ReportJson, HoldsNamesThatAreNotUtf8) {
  Report report = example();
  report.input = "caf\xe9.obj";
  EXPECT_TRUE(OrderedJson::accept(to_json(report)));
}

/// A report of a usual run.
Report usual() {
  Report report;
  report.input = "knob.obj";
  report.output = "a.om";
  report.mesh = {3224, 6444, 0, 6, true, 2};
  report.edges = {9666, 0.997, 0.113, 0.626, 1.567, 0.998, {}};
  for (int i = -8; i < 8; ++i) {
    report.edges.histogram.push_back({std::exp2(0.25 * i), std::exp2(0.25 * (i + 1)), 10});
  }
  report.quality.count = 6444;
  report.quality.min = 0.665;
  report.quality.mean = 0.955;
  report.quality.histogram = {{-1, 0, 0}};
  for (int i = 0; i < 10; ++i) {
    report.quality.histogram.push_back({0.1 * i, 0.1 * (i + 1), i < 8 ? 0U : 3222U});
  }
  report.worst = Report::WorstFace{"f0", Vec3(1, 2, 3)};
  report.diagonal = 4.779;
  report.lengths = {0.00746, 0.06549, 0.6806};
  report.seconds[Stage::Refine] = 0.05;
  report.wall_seconds = 0.04;
  for (int p = 0; p < 12; ++p) {
    report.patches.push_back({.name = fmt::format("f{}", p), .triangles = 537, .area = 0.5});
    report.patches.back().least_quality = 0.9 - 0.01 * p;
  }
  return report;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(ReportText, IsATableOfTwentyLines) {
  EXPECT_EQ(to_text(usual()),
            "input     knob.obj\n"
            "output    a.om\n"
            "mesh      3224 vertices, 6444 triangles, 6 patches\n"
            "          closed, Euler characteristic 2\n"
            "\n"
            "quality of triangles                     metric length of edges (1 is wanted)\n"
            "least 0.665, mean 0.955                  0.626 to 1.567, mean 0.997, dev. 0.113\n"
            "0.9 to 1          3222  50.0 % ########  0 to 0.5            40   0.4 % ########\n"
            "0.8 to 0.9        3222  50.0 % ########  0.5 to 0.707        20   0.2 % ####\n"
            "0.6 to 0.8           0   0.0 %           0.707 to 1          20   0.2 % ####\n"
            "0.3 to 0.6           0   0.0 %           1 to 1.41           20   0.2 % ####\n"
            "0 to 0.3             0   0.0 %           1.41 to 2           20   0.2 % ####\n"
            "turned over          0   0.0 %           2 to 4              40   0.4 % ########\n"
            "below 0.3            0  0.00 %           0.707 to 1.41     9647 99.80 %\n"
            "worst     0.665 in patch f0 at (1, 2, 3)\n"
            "edges     0.00746 to 0.6806 long, mean 0.06549; the model's diagonal is 4.779\n"
            "control   cells, 0 nodes, 0 faces\n"
            "time      0.05 s of processor, 0.04 s by the clock\n"
            "          128880 triangles a second, 128880 without control space and files\n"
            "notices   none\n");
}

TEST(ReportText, TellsHowNearASurfaceIsToTheMesh) {
  Report report = usual();
  const auto line_for = [&](const SurfaceFit& fit) {
    report.surfaces = {fit};
    const std::string text = to_text(report);
    const std::size_t start = text.find("surface ");
    return start == text.npos ? "" : text.substr(start, text.find('\n', start) - start);
  };
  EXPECT_EQ(line_for({.vertices = 42, .greatest_move = 0.5}),
            "surface   through 42 points; its cage moved by up to 0.5");
  EXPECT_EQ(line_for({.vertices = 42, .fit = 0.1, .distance = 0.09, .greatest_move = 0.5}),
            "surface   within 0.09 of 42 points, 0.1 requested; its cage moved by up to 0.5");
  EXPECT_EQ(line_for({.vertices = 42, .distance = 0.02, .greatest_move = 0.5}),
            "surface   near 42 points, at up to 0.02; its cage moved by up to 0.5");
}

TEST(ReportText, IsShort) {
  const std::string text = to_text(example());
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 20);
  for (const char* key : {"mesh", "edges", "quality", "control", "time", "notices"}) {
    EXPECT_NE(text.find(key), std::string::npos) << key;
  }
}

TEST(ReportText, FitsAScreenInAllStyles) {
  Report report = usual();
  report.quads.count = 20000;
  report.quads.histogram = report.quality.histogram;
  report.worst_quad = report.worst_quad_in_space = report.worst;
  report.sag = {0.01, 0.02, 5};
  report.notices = example().notices;
  report.given = {{"hmax", "5%", OptionOrigin::CommandLine}};
  for (const bool is_long : {false, true}) {
    for (const bool has_unicode : {false, true}) {
      const std::string text = to_text(report, {is_long, has_unicode});
      for (const std::string& line : lines_of(text)) {
        EXPECT_LE(detail::columns(line), 80u) << line;
      }
      const bool is_ascii = std::all_of(text.begin(), text.end(), [](char c) { return c > 0; });
      EXPECT_EQ(is_ascii, !has_unicode);
    }
  }
  EXPECT_LE(lines_of(to_text(report)).size(), 24u);
}

TEST(ReportText, ShowsWhatWasNotReached) {
  Report report = usual();
  report.sag = {0.01, 0.009, 5};
  EXPECT_NE(to_text(report).find("sag       0.009 reached, 0.01 asked for\n"), std::string::npos);
  report.sag.reached = 0.02;
  report.notices = {warning(NoticeKind::ClampedSizes, "a"), warning(NoticeKind::ClampedSizes, "b"),
                    shortfall(NoticeKind::SagNotReached, "c"),
                    shortfall(NoticeKind::SagNotReached, "d")};
  const std::string text = to_text(report);
  EXPECT_NE(text.find("sag       0.02, NOT REACHED, 0.01 asked for\n"), std::string::npos) << text;
  EXPECT_NE(text.find("notices   2 warnings; NOT REACHED: sag_not_reached\n"), std::string::npos)
      << text;
}

TEST(ReportText, ShowsQuadsWhereMostFacesAreQuads) {
  Report report = usual();
  report.quads.count = 20000;
  report.quads.min_jacobian = 0.25;
  report.quads.flat = 8;
  report.quads.histogram = report.quality.histogram;
  report.worst_quad = report.worst;
  const std::string text = to_text(report);
  EXPECT_NE(text.find("scaled Jacobian of quads  "), std::string::npos) << text;
  EXPECT_NE(text.find("below 0.1            8  0.04 %"), std::string::npos) << text;
  EXPECT_NE(text.find("worst     quad: 0.250 in patch f0"), std::string::npos) << text;
  EXPECT_NE(text.find("          triangle: 0.665 in patch f0"), std::string::npos) << text;
  EXPECT_EQ(text.find("quality of triangles"), std::string::npos) << text;
}

TEST(ReportText, HasAllTablesInTheLongStyle) {
  Report report = usual();
  report.given = {{"hmax", "5%", OptionOrigin::CommandLine}};
  report.control.queries[Stage::Refine].triangle = 77;
  const std::vector<std::string> lines = lines_of(to_text(report, {.is_long = true}));
  const auto has = [&](const std::string& line) {
    return std::find(lines.begin(), lines.end(), line) != lines.end();
  };
  EXPECT_TRUE(has("refine         0.050  100.0 %                   77"));
  EXPECT_TRUE(has("option  value          from"));
  EXPECT_TRUE(has("hmax       5%  command line"));
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("worst of 12 patches  triangles");
  }));
  const auto worst = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("worst of ");
  });
  EXPECT_TRUE((worst + 1)->starts_with("f11 "));
  EXPECT_TRUE((worst + 10)->starts_with("f2 "));
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.ends_with("0.595 to 0.707      10   0.1 % ########");
  }));
}

TEST(ReportText, TellsAnEstimate) {
  Report report;
  report.input = "knob.obj";
  report.estimated_elements = 14512;
  report.mesh.patches = 2;
  EXPECT_EQ(to_text(usual()).find("estimate"), std::string::npos);
  EXPECT_TRUE(estimate_text(report).starts_with(
      "input     knob.obj\nestimate  about 14500 triangles, 2 patches\n"));
}

}  // namespace
}  // namespace surfmesh
