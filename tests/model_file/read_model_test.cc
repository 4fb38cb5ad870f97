// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_model.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/errors.hh"
#include "support/folders.hh"

namespace surfmesh {
namespace {

ModelFile read(const std::string& text) { return parse_model(text, "a.json"); }

/// The error of a text, without the code and the name of the file.
std::string fault(const std::string& text) {
  const std::string error = error_of([&] { read(text); });
  const std::string front = "invalid input: a.json:";
  return error.starts_with(front) ? error.substr(front.size()) : error;
}

/// A model of one patch: other keys of the patch, other keys of the model.
std::string model(const std::string& in_patch, const std::string& in_root = "") {
  return R"({"patches": [{"name": "p", "surface": {"z": "u*v"},
             "domain": {"u": [0, 2], "v": [-1, 1]})" +
         (in_patch.empty() ? "" : ", " + in_patch) + "}]" +
         (in_root.empty() ? "" : ", " + in_root) + "}";
}
std::string source(const std::string& keys) { return model("\"sources\": [{" + keys + "}]"); }
std::string sizing(const std::string& keys) { return model("", "\"sizing\": {" + keys + "}"); }

std::string contours(const std::string& list) { return model("", "\"contours\": [" + list + "]"); }
std::string contour(const std::string& keys) { return contours("{" + keys + "}"); }
std::string cages(const std::string& keys) { return model("", "\"cages\": [{" + keys + "}]"); }

Vec3 point(const ModelFile& file, std::size_t patch, Uv uv) {
  return file.patches[patch].surface->evaluate(uv, Order::Position).point;
}

TEST(ReadModel, ReadsSources) {
  const Sources sources = read(model(R"("sources": [
      {"everywhere": true, "size": 0.5}, {"at": [0, 1], "size": "1%"},
      {"at": [2, -0.5], "size": [0.2, 0.05], "angle": 30}])"))
                              .sources;
  ASSERT_EQ(sources.everywhere.size(), 1u);
  EXPECT_EQ(sources.everywhere[0].patch, 0);
  EXPECT_EQ(sources.everywhere[0].size.along.value, 0.5);
  EXPECT_EQ(sources.everywhere[0].size.across.value, 0.5);
  ASSERT_EQ(sources.at.size(), 2u);
  EXPECT_EQ(sources.at[0].at, (Uv{0, 1}));
  EXPECT_EQ(sources.at[0].size.along.value, 0.01);
  EXPECT_TRUE(sources.at[0].size.across.is_relative);
  EXPECT_EQ(sources.at[1].size.along.value, 0.2);
  EXPECT_EQ(sources.at[1].size.across.value, 0.05);
  EXPECT_DOUBLE_EQ(sources.at[1].size.angle, std::numbers::pi / 6);
}

TEST(ReadModel, ReadsSizesAroundPlaces) {
  const ModelFile file = read(model(R"("sources": [
      {"at": [0, 1], "size": 1, "radius": "1%",
       "outer": {"size": [2, 3], "angle": 90, "radius": 4}},
      {"along": [[0, 0], [1, 0.5], [2, 1]], "size": 5, "radius": 6},
      {"along": "p:u0", "size": 7},
      {"inside": [[0, 0], [1, 0], [1, "1/2"]], "size": 8}])"));
  const AtSource& at = file.sources.at.at(0);
  EXPECT_TRUE(at.radius.is_relative);
  EXPECT_EQ(at.outer.value().size.across.value, 3);
  EXPECT_DOUBLE_EQ(at.outer->size.angle, std::numbers::pi / 2);
  EXPECT_EQ(at.outer->radius.value, 4);
  ASSERT_EQ(file.sources.along.at(0).curves.size(), 2u);
  EXPECT_EQ(file.sources.along[0].curves[1]->evaluate(1), (Uv{2, 1}));
  EXPECT_EQ(file.sources.along[0].wish.radius.value, 6);
  EXPECT_EQ(file.along_contours.at(0).contour, "p:u0");
  EXPECT_EQ(file.along_contours[0].origin, "/patches/0/sources/2/along");
  EXPECT_EQ(file.sources.inside.at(0).polygon.at(2), (Uv{1, 0.5}));
}

TEST(ReadModel, ReadsFields) {
  const Sources sources = read(model(R"("sources": [
      {"field": {"size": "a*u+v+x+10*y+z"}, "precision": 0.2},
      {"field": {"m11": "1", "m12": "u", "m22": "v"}}])",
                                     R"("constants": {"a": 3})"))
                              .sources;
  ASSERT_EQ(sources.fields.size(), 2u);
  EXPECT_EQ(sources.fields[0].size({1, 2}, {4, 5, 6}), 3 + 2 + 4 + 50 + 6);
  EXPECT_EQ(sources.fields[0].precision, 0.2);
  EXPECT_EQ(sources.fields[1].metric({1, 2}, Vec3::Zero()), (Metric{1, 1, 2}));
  EXPECT_FALSE(sources.fields[1].precision);
}

TEST(ReadModel, ReadsTablesBesideTheFile) {
  const TestFolder folder;
  write_text(folder / "t.csv", "u,v,size\n0,0,1\n2,1,3\n");
  write_text(folder / "a.json", source(R"("table": "t.csv", "precision": 0.3)"));
  const Sources sources = read_model(folder / "a.json").sources;
  ASSERT_EQ(sources.tables.at(0).nodes.size(), 2u);
  EXPECT_EQ(sources.tables[0].precision, 0.3);
  write_text(folder / "t.csv", "u,v,size\n9,0,1\n");
  EXPECT_NE(error_of([&] { read_model(folder / "a.json"); }).find("t.csv:2: the point (9, 0)"),
            std::string::npos);
}

TEST(ReadModel, ReadsPlacesInSpace) {
  const ModelFile file = read(model("", R"("constants": {"a": 2}, "sources": [
      {"near": [0, "a", 1], "size": 1},
      {"near": [[0, 0, 0], [1, 0, "a"]], "size": 1, "radius": 2}])"));
  ASSERT_EQ(file.space_sources.size(), 2u);
  const auto near = [&](std::size_t i) { return std::get<NearSource>(file.space_sources[i].wish); };
  EXPECT_EQ(near(0).line.at(0), Vec3(0, 2, 1));
  EXPECT_EQ(near(1).line.at(1), Vec3(1, 0, 2));
}

TEST(ReadModel, ReadsBoxesAndBalls) {
  const ModelFile file = read(model("", R"("constants": {"a": 2}, "sources": [
      {"inside": {"box": [[1, 0, "a"], [0, 1, 0]]}, "size": 1, "radius": 0.5},
      {"group": "p", "inside": {"ball": [0, 0, "a"], "radius": "3%"}, "size": 1}])"));
  ASSERT_EQ(file.space_sources.size(), 2u);
  const BoxSource& box = std::get<BoxSource>(file.space_sources[0].wish);
  EXPECT_EQ(box.box.min(), Vec3(0, 0, 0));
  EXPECT_EQ(box.box.max(), Vec3(1, 1, 2));
  EXPECT_EQ(box.wish.radius.value, 0.5);
  EXPECT_TRUE(file.space_sources[0].group.empty());
  const NearSource& ball = std::get<NearSource>(file.space_sources[1].wish);
  EXPECT_EQ(ball.line.at(0), Vec3(0, 0, 2));
  EXPECT_TRUE(ball.wish.radius.is_relative);
  EXPECT_EQ(file.space_sources[1].group, "p");
}

TEST(ReadModel, ReadsFieldsAndSizesOfTheWholeModel) {
  const ModelFile file = read(model("", R"json("sources": [
      {"field": {"size": "r+0.1", "where": {"r": "sqrt(x^2+y^2+z^2)"}}, "precision": 0.3},
      {"everywhere": true, "size": 2},
      {"group": "p", "field": {"size": "0.1+z^2"}}])json"));
  ASSERT_EQ(file.space_sources.size(), 3u);
  const FieldSource& field = std::get<FieldSource>(file.space_sources[0].wish);
  EXPECT_DOUBLE_EQ(field.size({}, Vec3(1, 2, 2)), 3.1);
  EXPECT_EQ(field.precision, 0.3);
  EXPECT_EQ(std::get<Size>(file.space_sources[1].wish).along.value, 2);
  EXPECT_EQ(file.space_sources[2].group, "p");
}

TEST(ReadModel, ReadsNamedFormulas) {
  const ModelFile file = read(R"({"constants": {"a": 2}, "patches": [{"name": "p",
      "surface": {"where": {"r": "a+u", "s": "r*v"}, "x": "r", "z": "s"},
      "domain": {"u": [0, 2], "v": [-1, 1]},
      "sources": [{"field": {"size": "h", "where": {"h": "0.1+z*z"}}},
                  {"field": {"m11": "m", "m12": "0", "m22": "m*m", "where": {"m": "1+u"}}}]}],
    "contours": [{"name": "c", "on": [{"patch": "p", "u": "c", "v": "c/2", "where": {"c": "t*t"}}]},
      {"name": "d", "xyz": {"x": "c", "y": "0", "z": "c", "where": {"c": "a*t"}}}]})");
  EXPECT_EQ(point(file, 0, {1, 0.5}), Vec3(3, 0.5, 1.5));
  EXPECT_EQ(file.sources.fields.at(0).size({0, 0}, {0, 0, -2}), 4.1);
  EXPECT_EQ(file.sources.fields.at(1).metric({1, 0}, Vec3::Zero()), (Metric{2, 0, 4}));
  EXPECT_EQ(file.contours.at(0).on.at(0).curve->evaluate(0.5), (Uv{0.25, 0.125}));
  EXPECT_EQ(file.contours.at(1).xyz->evaluate(0.5), Vec3(1, 0, 1));
}

TEST(ReadModelFaults, OfFormulasAtTheirPlace) {
  const auto surface = [](const std::string& keys) {
    return fault(R"({"patches": [{"name": "p", "surface": {)" + keys +
                 R"(}, "domain": {"u": [0, 1], "v": [0, 1]}}]})");
  };
  const std::string at = " /patches/0/surface/";
  EXPECT_TRUE(surface(R"("x": "u", "y": "v*", "z": "0")").starts_with(at + "y: formula \"v*\""));
  EXPECT_TRUE(surface(R"("z": "r", "where": {"r": "s", "s": "u"})")
                  .starts_with(at + "where/r: formula \"s\", column 1: unknown name 's'"));
  EXPECT_EQ(surface(R"("z": "r+q", "where": {"r": "u"})"),
            at + "z: formula \"r+q\", column 3: unknown name 'q'. Names: u v r pi e");
  EXPECT_EQ(surface(R"("z": "0", "where": {"v": "u"})"),
            at + "where/v: the name 'v' would redefine a name of the formulas");
  EXPECT_EQ(surface(R"("z": "0", "where": {"r": 2})"),
            at + "where/r: must be a string, not number");
  EXPECT_EQ(surface(R"("z": "0", "where": "r")"), at + "where: must be an object, not string");
  const std::string field = " /patches/0/sources/0/field/";
  EXPECT_TRUE(fault(source(R"("field": {"size": "1+"})")).starts_with(field + "size: formula"));
  EXPECT_TRUE(fault(source(R"("field": {"m11": "1", "m12": "w", "m22": "1"})"))
                  .starts_with(field + "m12: formula \"w\", column 1: unknown name 'w'"));
  EXPECT_EQ(fault(source(R"("field": {"size": "1", "where": {"x": "u"}})")),
            field + "where/x: the name 'x' is the name of something else");
  EXPECT_EQ(fault(contour(R"("name": "a", "on": [{"patch": "p", "where": {"c": "t"}}])")),
            " /contours/0/on/0/u: this key is missing");
  EXPECT_TRUE(fault(contour(R"("name": "a", "on": [{"patch": "p", "u": "t", "v": "v"}])"))
                  .starts_with(" /contours/0/on/0/v: formula \"v\", column 1: unknown name"));
  EXPECT_EQ(fault(model("", R"("constants": {"step": 3})")),
            " /constants/step: this would redefine a name of the formulas");
}

TEST(ReadModelFaults, OfSourcesOfAllKinds) {
  const std::string front = " /patches/0/sources/0";
  EXPECT_EQ(fault(source(R"("along": [[0, 0]], "size": 1)")),
            front + "/along: needs at least 2 points");
  EXPECT_EQ(fault(source(R"("inside": [[0, 0], [1, 0], [3, 0]], "size": 1)")),
            front + "/inside/2: this point is outside of the domain");
  EXPECT_EQ(fault(source(R"("at": [0, 0], "size": 1, "radius": -1)")),
            front + "/radius: must be 0 or above");
  EXPECT_EQ(fault(source(R"("at": [0, 0], "size": 1, "radius": "-1%")")),
            front + "/radius: must be 0 or above");
  EXPECT_EQ(fault(source(R"("at": [0, 0], "size": 1, "radius": "0%")")), "no error");
  EXPECT_EQ(fault(source(R"("at": [0, 0], "size": 1, "outer": {"size": 1})")),
            front + "/outer/radius: this key is missing");
  EXPECT_EQ(fault(source(R"("at": [0, 0], "size": 1, "precision": 0.2)")),
            front + "/precision: a size that is not of a field or table has no precision");
  EXPECT_EQ(fault(source(R"("everywhere": true, "size": 1, "radius": 1)")),
            front + "/radius: a whole patch has no radius");
  EXPECT_EQ(fault(source(R"("field": {"size": "u", "m11": "1"})")),
            front + "/field/m11: a field of one size has no m11");
  EXPECT_TRUE(fault(source(R"("field": {"size": "u+q"})")).starts_with(front + "/field/size: "));
  EXPECT_EQ(fault(source(R"("field": {"m11": "1", "m22": "1"})")),
            front + "/field/m12: this key is missing");
  EXPECT_EQ(fault(source(R"("field": {"size": "u"}, "precision": 0)")),
            front + "/precision: must be above 0");
  EXPECT_TRUE(fault(source(R"("table": "no.csv")")).starts_with(front + "/table: cannot read"));
  EXPECT_EQ(
      fault(model("", R"("sources": [{"near": [0, 0], "size": 1}])")).find(" /sources/0/near"), 0u);
}

TEST(ReadModel, GivesSourcesTheIndexOfTheirPatch) {
  const std::string rest =
      R"("surface": {"z": "0"}, "domain": {"u": [0, 1], "v": [0, 1]},
         "sources": [{"everywhere": true, "size": 1}]})";
  const ModelFile file =
      read(R"({"patches": [{"name": "a", )" + rest + R"(, {"name": "b", )" + rest + "]}");
  EXPECT_EQ(file.sources.everywhere.at(1).patch, 1);
}

TEST(ReadModel, ReadsContours) {
  const std::string list = R"json("constants": {"r": 0.25}, "contours": [
      {"name": "hole", "range": [0, "2*pi"],
       "on": [{"patch": "p", "u": "1+r*cos(t)", "v": "r*sin(t)"}]},
      {"name": "seam", "xyz": {"x": "t", "y": "r", "z": "0"}, "on": [{"patch": "p"}]}])json";
  const ModelFile file =
      read(model(R"("loops": [["p:v0", "p:u1", "-p:v1", "-p:u0"], ["-hole"]])", list));
  ASSERT_EQ(file.contours.size(), 2u);
  EXPECT_EQ(file.contours[0].name, "hole");
  EXPECT_EQ(file.contours[0].origin, "/contours/0");
  EXPECT_EQ(file.contours[0].range.to, 2 * std::numbers::pi);
  EXPECT_NEAR(file.contours[0].on.at(0).curve->evaluate(0.25).v, 0.25, 1e-15);
  EXPECT_EQ(file.contours[0].xyz, nullptr);
  EXPECT_EQ(file.contours[1].xyz->evaluate(0.5), Vec3(0.5, 0.25, 0));
  EXPECT_EQ(file.contours[1].on.at(0).curve, nullptr);
}

TEST(ReadModel, ReadsLoops) {
  const PatchInput patch = read(model(R"("loops": [["p:v0", "-p:u1"], ["p:u0"]])")).patches[0];
  EXPECT_EQ(patch.loops, (std::vector<std::vector<std::string>>{{"p:v0", "-p:u1"}, {"p:u0"}}));
  EXPECT_EQ(patch.origin, "/patches/0");
}

TEST(ReadModel, ReadsCagesBesideTheFile) {
  const ModelFile file = parse_model(
      R"({"$schema": "surfmesh.schema.json", "cages": [
          {"name": "a", "file": "x.obj", "scheme": "loop", "patches": "faces"},
          {"name": "b", "file": "../y.off"},
          {"name": "c", "file": "z.obj", "patches": "blocks"}]})",
      "some/where/a.json");
  ASSERT_EQ(file.cages.size(), 3u);
  EXPECT_EQ(file.cages[0].patches, PatchKind::Faces);
  EXPECT_EQ(file.cages[1].patches, PatchKind::Auto);
  EXPECT_EQ(file.cages[2].patches, PatchKind::Blocks);
  EXPECT_EQ(file.cages[0].file, std::filesystem::path("some/where/x.obj"));
  EXPECT_EQ(file.cages[0].scheme, Scheme::Loop);
  EXPECT_EQ(file.cages[1].file, std::filesystem::path("some/where/../y.off"));
  EXPECT_EQ(file.cages[1].scheme, Scheme::Auto);
  EXPECT_TRUE(file.patches.empty());
}

TEST(ReadModel, ReadsSourcesOfGroups) {
  const ModelFile file =
      read(model("", R"("sources": [{"group": "wing", "size": [0.2, "1%"], "angle": 90}])"));
  ASSERT_EQ(file.space_sources.size(), 1u);
  EXPECT_EQ(file.space_sources[0].group, "wing");
  const Size& size = std::get<Size>(file.space_sources[0].wish);
  EXPECT_EQ(size.along.value, 0.2);
  EXPECT_TRUE(size.across.is_relative);
  EXPECT_EQ(file.space_sources[0].origin, "/sources/0");
}

TEST(ReadModel, HandsOptionsOnAsText) {
  const ModelFile file =
      read(model("", R"("options": {"nodes": 40000, "interpolation": "auto", "a": [1, true]})"));
  ASSERT_EQ(file.options.size(), 3u);
  EXPECT_EQ(file.options[0].name, "nodes");
  EXPECT_EQ(file.options[0].value, "40000");
  EXPECT_EQ(file.options[1].value, "\"auto\"");
  EXPECT_EQ(file.options[2].value, "[1,true]");
  EXPECT_EQ(file.options[2].origin, "/options/a");
  EXPECT_FALSE(file.options[2].is_in_sizing);
}

TEST(ReadModel, KeepsTheSizingForThePipeline) {
  const ModelFile file = read(sizing(R"("hmin": "1%", "grade": 2)"));
  ASSERT_EQ(file.options.size(), 2u);
  EXPECT_EQ(file.options[1].name, "grade");
  EXPECT_EQ(file.options[1].origin, "/sizing/grade");
  EXPECT_TRUE(file.options[1].is_in_sizing);
}

TEST(ReadModel, AcceptsWhatIsNotBuiltWhereItIsOff) {
  EXPECT_EQ(fault(model(R"("loops": [], "sources": [])",
                        R"("cages": [], "contours": [], "sources": [])")),
            "no error");
  EXPECT_EQ(fault(source(
                R"("everywhere": true, "size": 1, "radius": 0, "outer": {}, "precision": null)")),
            "no error");
}

TEST(ReadModelFaults, OfSyntaxWithLineAndColumn) {
  EXPECT_TRUE(fault("").starts_with("1:1: syntax error")) << fault("");
  EXPECT_TRUE(fault("{\n  \"a\": 1,\n}").starts_with("3:1: syntax error"))
      << fault("{\n  \"a\": 1,\n}");
  EXPECT_TRUE(fault("{\"a\": nan}").starts_with("1:8: syntax error")) << fault("{\"a\": nan}");
  EXPECT_TRUE(fault("{\"a\": 1}\n x").starts_with("2:2: syntax error")) << fault("{\"a\": 1}\n x");
  EXPECT_TRUE(fault("{\"a\": \"\xff\"}").find("UTF-8") != std::string::npos);
}

TEST(ReadModelFaults, OfNumbersOutOfRange) {
  EXPECT_EQ(fault(sizing("\"hmax\": 1e999")), " /sizing/hmax: number overflow parsing '1e999'");
  EXPECT_EQ(fault(R"({"patches": [], "sources": [{"size": 1}, {"size": [1, 1e999]}]})"),
            " /sources/1/size/1: number overflow parsing '1e999'");
}

TEST(ReadModelFaults, OfKeysThatComeTwice) {
  EXPECT_EQ(fault(R"({"patches": [], "patches": []})"), " /patches: this key comes twice");
  EXPECT_EQ(fault(R"({"patches": [{"a": [1, {}]}, {"domain": {"u/v": 1, "u/v": 2}}]})"),
            " /patches/1/domain/u~1v: this key comes twice");
}

TEST(ReadModelFaults, OfNestingWithoutEnd) {
  EXPECT_NE(fault(std::string(100000, '[')).find("the nesting is too deep"), std::string::npos);
}

TEST(ReadModelFaults, OfKeysThatBelongElsewhere) {
  EXPECT_EQ(fault(model("\"cages\": []")),
            " /patches/0/cages: unknown key, cages belongs in the model itself");
  EXPECT_EQ(fault(model("", "\"loops\": []")), " /loops: unknown key, loops belongs in a patch");
  EXPECT_EQ(fault(source("\"size\": 1, \"at\": [0, 0], \"sharpness\": 1")),
            " /patches/0/sources/0/sharpness: unknown key, sharpness belongs in the creases of a "
            "cage");
}

TEST(ReadModelFaults, OfUnknownKeysWithASuggestion) {
  EXPECT_EQ(fault(model("", "\"sizign\": {}")), " /sizign: unknown key, did you mean sizing?");
  EXPECT_EQ(fault(model("\"source\": []")),
            " /patches/0/source: unknown key, did you mean sources?");
  EXPECT_EQ(fault(source("\"size\": 1, \"at\": [0, 0], \"raduis\": 1")),
            " /patches/0/sources/0/raduis: unknown key, did you mean radius?");
}

TEST(ReadModelFaults, OfMissingKeys) {
  EXPECT_EQ(fault("{}"), " a model needs patches, cages or cad");
  EXPECT_EQ(fault(R"({"patches": []})"), " /patches: the model has no patches");
  EXPECT_EQ(fault(R"({"patches": [{}]})"), " /patches/0/name: this key is missing");
  EXPECT_EQ(fault(R"({"patches": [{"name": "p"}]})"), " /patches/0/surface: this key is missing");
  EXPECT_EQ(fault(R"({"patches": [{"name": "p", "surface": {}}]})"),
            " /patches/0/surface/z: this key is missing");
  EXPECT_EQ(fault(R"({"patches": [{"name": "p", "surface": {"z": "0"}}]})"),
            " /patches/0/domain: this key is missing");
  EXPECT_EQ(fault(source("\"at\": [0, 0]")), " /patches/0/sources/0/size: this key is missing");
  EXPECT_EQ(fault(source("\"size\": 1")),
            " /patches/0/sources/0: a source needs one of everywhere, at, along, inside, field, "
            "table, background");
  EXPECT_EQ(fault(source("\"everywhere\": true, \"at\": [0, 0], \"size\": 1")),
            " /patches/0/sources/0: a source cannot have both everywhere and at");
}

TEST(ReadModelFaults, OfTypes) {
  EXPECT_EQ(fault("[]"), " must be an object, not array");
  EXPECT_EQ(fault(R"({"patches": {}})"), " /patches: must be an array, not object");
  EXPECT_EQ(fault(R"({"patches": [{"name": 1}]})"),
            " /patches/0/name: must be a string, not number");
  EXPECT_EQ(fault(source("\"at\": [0], \"size\": 1")),
            " /patches/0/sources/0/at: must be an array of 2 values, not 1");
}

TEST(ReadModelFaults, OfRanges) {
  const std::string place = " /patches/0/sources/0/size: ";
  const auto size = [](const std::string& text) {
    return fault(source("\"everywhere\": true, \"size\": " + text));
  };
  EXPECT_EQ(size("0"), place + "must be above 0");
  EXPECT_EQ(size("\"-1%\""), place + "must be above 0");
  EXPECT_EQ(size("\"500%\""), place + "a share of the diagonal is at most 100%");
  EXPECT_EQ(size("\"1\""), place + "a length in model units is a number, without quotes");
  const std::string reason = " is no length: a number, or a share of the diagonal such as 0.1%";
  EXPECT_EQ(size("\"x%\""), place + "'x%'" + reason);
  EXPECT_EQ(size("\"inf%\""), place + "'inf%'" + reason);
  EXPECT_EQ(fault(source("\"at\": [3, 0], \"size\": 1")),
            " /patches/0/sources/0/at: this point is outside of the domain");
  EXPECT_EQ(fault(source("\"at\": [0, 0], \"size\": [1, 0]")),
            " /patches/0/sources/0/size/1: must be above 0");
  EXPECT_EQ(fault(source("\"everywhere\": false, \"size\": 1")),
            " /patches/0/sources/0/everywhere: must be true");
}

TEST(ReadModelFaults, OfDomains) {
  const auto with = [](const std::string& domain) {
    return R"({"patches": [{"name": "p", "surface": {"z": "0"}, "domain": )" + domain + "}]}";
  };
  EXPECT_EQ(fault(with(R"({"u": [1, 1], "v": [0, 1]})")),
            " /patches/0/domain/u: the second value must be larger than the first");
  EXPECT_EQ(fault(with(R"({"u": [0, 1]})")), " /patches/0/domain/v: this key is missing");
  EXPECT_EQ(fault(with(R"({"u": [0, 1], "v": [0, true]})")),
            " /patches/0/domain/v/1: must be a number, not boolean");
}

TEST(ReadModelFaults, OfNames) {
  const std::string patch =
      R"({"name": "p", "surface": {"z": "0"}, "domain": {"u": [0, 1], "v": [0, 1]}})";
  EXPECT_EQ(fault("{\"patches\": [" + patch + ", " + patch + "]}"),
            " /patches/1/name: there are two patches with the name p");
  EXPECT_EQ(fault(R"({"patches": [{"name": ""}]})"), " /patches/0/name: must not be empty");
  EXPECT_EQ(fault(model("", R"("constants": {"pi": 3})")),
            " /constants/pi: this would redefine a name of the formulas");
  EXPECT_EQ(fault(model("", R"("constants": {"2a": 3})")),
            " /constants/2a: this is not a name of letters, digits and _");
}

TEST(ReadModelFaults, OfContours) {
  const std::string front = " /contours/0";
  EXPECT_EQ(fault(contour("")), front + "/name: this key is missing");
  EXPECT_EQ(fault(contour(R"("name": "a")")),
            front + ": a contour needs xyz, or u and v on a patch");
  EXPECT_EQ(fault(contour(R"("name": "a", "on": [{"patch": "p"}])")),
            front + ": a contour needs xyz, or u and v on a patch");
  EXPECT_EQ(fault(contour(R"("name": "a", "on": [{"patch": "p", "u": "t"}])")),
            front + "/on/0/v: this key is missing");
  EXPECT_EQ(fault(contour(R"("name": "a", "on": [{"patch": "pq", "u": "t", "v": "t"}])")),
            front + "/on/0/patch: there is no patch with formulas pq, did you mean p?");
  EXPECT_EQ(fault(contour(R"("name": "a", "range": [1, 0])")),
            front + "/range: the second value must be larger than the first");
  EXPECT_EQ(fault(contour(R"("name": "-a")")),
            front + "/name: a name must not begin with -, which turns a contour in a loop");
  EXPECT_EQ(fault(contour(R"("name": "a:b")")),
            front + "/name: the name of a contour has no colon, which sides have");
  EXPECT_EQ(fault(contour(R"("name": "a", "xyz": {"x": "t", "y": "0"})")),
            front + "/xyz/z: this key is missing");
  EXPECT_TRUE(fault(contour(R"("name": "a", "xyz": {"x": "t", "y": "u", "z": "0"})"))
                  .starts_with(front + "/xyz/y: formula \"u\", column 1: "));
  const std::string one = R"({"name": "a", "xyz": {"x": "t", "y": "0", "z": "0"}})";
  EXPECT_EQ(fault(contours(one + ", " + one)),
            " /contours/1/name: there are two contours with the name a");
}

TEST(ReadModelFaults, OfLoops) {
  EXPECT_EQ(fault(model(R"("loops": [[]])")), " /patches/0/loops/0: a loop must not be empty");
  EXPECT_EQ(fault(model(R"("loops": [["p:v0", "-p:w1"]])")),
            " /patches/0/loops/0/1: there is no contour p:w1, did you mean p:u1?");
  EXPECT_EQ(fault(model(R"("loops": [["circle"]])")),
            " /patches/0/loops/0/0: there is no contour circle");
  EXPECT_EQ(fault(model(R"("loops": "p:v0")")), " /patches/0/loops: must be an array, not string");
}

TEST(ReadModelFaults, OfCages) {
  EXPECT_EQ(fault(cages(R"("name": "b")")), " /cages/0/file: this key is missing");
  EXPECT_EQ(fault(cages(R"("name": "p", "file": "b.obj")")),
            " /cages/0/name: there are two patches or cages with the name p");
  EXPECT_EQ(fault(cages(R"("name": "b", "file": "b.obj", "scheme": "cat")")),
            " /cages/0/scheme: must be auto, catmark, loop or bilinear");
  EXPECT_EQ(fault(cages(R"("name": "b", "file": "b.obj", "patches": "all")")),
            " /cages/0/patches: must be faces, blocks, regions or auto");
  EXPECT_EQ(fault(cages(R"("name": "b", "fle": "b.obj")")),
            " /cages/0/fle: unknown key, did you mean file?");
}

TEST(ReadModelFaults, OfSourcesOfGroups) {
  const auto group = [](const std::string& keys) {
    return fault(model("", "\"sources\": [{" + keys + "}]"));
  };
  EXPECT_EQ(group(R"("size": 1)"),
            " /sources/0: a source needs one of near, along, inside, field, background, "
            "everywhere, group");
  EXPECT_EQ(group(R"("group": "a", "size": 0)"), " /sources/0/size: must be above 0");
  EXPECT_EQ(group(R"("group": "a")"), " /sources/0/size: this key is missing");
  EXPECT_EQ(group(R"("group": "a", "size": 1, "radius": 2)"),
            " /sources/0/radius: a size everywhere has no radius");
}

TEST(ReadModelFaults, OfSourcesAtTheWrongLevel) {
  const auto of_model = [](const std::string& keys) {
    return fault(model("", "\"sources\": [{" + keys + ", \"size\": 1}]"));
  };
  EXPECT_EQ(of_model(R"("at": [0, 0])"), " /sources/0/at: at belongs in the sources of a patch");
  EXPECT_EQ(of_model(R"("along": [[0, 0], [1, 1]])"),
            " /sources/0/along/0: must be the name of a contour; points in (u,v) belong in the "
            "sources of a patch");
  EXPECT_EQ(of_model(R"("table": "t.csv")"),
            " /sources/0/table: table belongs in the sources of a patch");
  EXPECT_EQ(
      of_model(R"("inside": [[0, 0], [1, 0], [0, 1]])"),
      " /sources/0/inside: a polygon is in the (u,v) of a patch, and belongs in the sources of "
      "that; here it takes a box or a ball");
  EXPECT_EQ(fault(model(R"("sources": [{"near": [0, 0, 0], "size": 1}])")),
            " /patches/0/sources/0/near: near belongs in the sources of the model, beside patches");
  EXPECT_EQ(fault(model(R"("sources": [{"group": "p", "size": 1}])")),
            " /patches/0/sources/0/group: group belongs in the sources of the model, beside "
            "patches");
}

TEST(ReadModelFaults, OfSourcesInSpace) {
  const auto of_model = [](const std::string& keys) {
    return fault(model("", "\"sources\": [{" + keys + "}]"));
  };
  EXPECT_EQ(of_model(R"("field": {"size": "1+u"})"),
            " /sources/0/field: u and v are those of one patch: a field of them belongs in the "
            "sources of that; here it takes x, y and z");
  EXPECT_EQ(of_model(R"("field": {"size": "1+w"})").find(" /sources/0/field/size: "), 0u);
  EXPECT_EQ(
      of_model(R"("field": {"m11": "1", "m12": "0", "m22": "1"})"),
      " /sources/0/field/m11: a metric is in the (u,v) of a patch, and belongs in the sources "
      "of that");
  EXPECT_EQ(of_model(R"("inside": {"box": [[0, 0, 0]]}, "size": 1)").find(" /sources/0/inside/box"),
            0u);
  EXPECT_EQ(of_model(R"("inside": {"ball": [0, 0, 0]}, "size": 1)"),
            " /sources/0/inside/radius: this key is missing");
  EXPECT_EQ(of_model(R"("inside": {}, "size": 1)"),
            " /sources/0/inside: needs either a box or a ball");
  EXPECT_EQ(of_model(R"("inside": {"ball": [0, 0, 0], "radius": 1}, "size": 1, "radius": 1)"),
            " /sources/0/radius: the ball has its own radius");
  EXPECT_EQ(of_model(R"("near": [0, 0, 0], "inside": {"box": [[0,0,0],[1,1,1]]}, "size": 1)"),
            " /sources/0: a source cannot have both near and inside");
}

TEST(ReadModelFaults, OfFiles) {
  EXPECT_EQ(error_of([] { read_model("no such.json"); }),
            "io: cannot read no such.json: it does not exist");
  const TestFolder folder;
  write_text(folder / "a.json", "{}");
  const std::string path = (folder / "a.json").string();
  EXPECT_EQ(error_of([&] { read_model(path); }),
            "invalid input: " + path + ": a model needs patches, cages or cad");
}

TEST(SharedModels, AreRead) {
  const auto bench = std::filesystem::path(SURFMESH_SHARED_DIR) / "bench";
  if (!std::filesystem::exists(bench / "c2.json")) GTEST_SKIP() << "no models in " << bench;
  const ModelFile file = read_model(bench / "c2.json");
  ASSERT_EQ(file.patches.size(), 1u);
  EXPECT_EQ(file.patches[0].name, "wave");
  EXPECT_DOUBLE_EQ(point(file, 0, {1, 0})[2], 1.5 * std::sin(2.0) * std::exp(-0.001));
  EXPECT_EQ(file.patches[0].surface->domain().u0, -6);
  EXPECT_EQ(file.patches[0].surface->domain().v1, 6);
  for (const FileOption& option : file.options) EXPECT_TRUE(option.is_in_sizing) << option.name;
}

TEST(SharedModels, HaveFields) {
  const auto path = std::filesystem::path(SURFMESH_SHARED_DIR) / "bench" / "c1.json";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no model " << path;
  const Sources sources = read_model(path).sources;
  ASSERT_EQ(sources.fields.size(), 1u);
  EXPECT_EQ(sources.fields[0].precision, 0.02);
  EXPECT_NEAR(sources.fields[0].size({0.5, 0.5}, Vec3::Zero()), 0.0275, 1e-15);
}

/// A model of a NURBS patch over [0,2] x [0,1] with a crease at u = 1: other keys of nurbs, of the
/// patch and of the model.
std::string nurbs_model(const std::string& in_nurbs = "", const std::string& in_patch = "",
                        const std::string& in_root = "") {
  const auto after = [](const std::string& keys) { return keys.empty() ? keys : ", " + keys; };
  return R"({"patches": [{"name": "p", "surface": {"nurbs": {"degree": [1, 1],
             "knots": [[0, 0, 1, "1+1", 2], [0, 0, 1, 1]],
             "points": [[[0, 0, 0], [1, 0, 1], [2, 0, 0]], [[0, 1, 0], [1, 1, 1], [2, 1, 0]]])" +
         after(in_nurbs) + "}}" + after(in_patch) + "}]" + after(in_root) + "}";
}

/// The same with this text in place of another one.
std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// The plane patch with the coordinates u and v.
std::string plane_nurbs(const std::string& in_patch = "", const std::string& in_root = "") {
  return changed(changed(nurbs_model("", in_patch, in_root), "[1, 0, 1]", "[1, 0, 0]"), "[1, 1, 1]",
                 "[1, 1, 0]");
}

TEST(ReadModel, ReadsNurbs) {
  const ModelFile file = read(plane_nurbs());
  ASSERT_EQ(file.patches.size(), 1u);
  EXPECT_EQ(file.patches[0].name, "p");
  EXPECT_EQ(file.patches[0].surface->domain().u1, 2);
  EXPECT_EQ(file.patches[0].surface->cells().u, 2);
  EXPECT_EQ(point(file, 0, {0.5, 0.25}), Vec3(0.5, 0.25, 0));
  EXPECT_TRUE(file.divided.empty());
}

TEST(ReadModel, ReadsAPartOfNurbs) {
  const std::string domain = R"("domain": {"u": [0.5, "3/2"], "v": [0, 1]})";
  EXPECT_EQ(read(plane_nurbs(domain)).patches[0].surface->domain().u1, 1.5);
  EXPECT_EQ(
      fault(plane_nurbs(R"("domain": {"u": [0, 3], "v": [0, 1]})")),
      " /patches/0/domain: the domain in u is from 0 to 3, but the knots only reach from 0 to "
      "2");
}

TEST(ReadModel, ReadsWeightsAndPeriods) {
  const std::string weights = R"x("weights": [[1, "sqrt(2)", 1], [1, 1, 1]])x";
  EXPECT_NE(point(read(nurbs_model(weights)), 0, {0.5, 0}).x(), 0.5);
  const std::string periodic = changed(nurbs_model(R"("periodic": [true, false])"),
                                       R"([0, 0, 1, "1+1", 2])", "[0, 1, 2, 3]");
  EXPECT_EQ(read(periodic).divided.at(0).pieces.size(), 3u);
}

TEST(ReadModel, DividesNurbsAtCreases) {
  const ModelFile file = read(nurbs_model("", R"("sources": [{"everywhere": true, "size": 1},
                              {"at": [1.5, 0.5], "size": 2}, {"at": [1, 0.5], "size": 3}])"));
  ASSERT_EQ(file.patches.size(), 2u);
  EXPECT_EQ(file.patches[0].name, "p[0,0]");
  EXPECT_EQ(file.patches[1].name, "p[1,0]");
  EXPECT_EQ(file.patches[1].surface->domain().u0, 1);
  EXPECT_EQ(file.divided.at(0).name, "p");
  EXPECT_EQ(file.divided[0].pieces, (std::vector<int>{0, 1}));
  EXPECT_EQ(file.sources.everywhere.size(), 2u);
  ASSERT_EQ(file.sources.at.size(), 3u);
  EXPECT_EQ(file.sources.at[0].patch, 1);
}

TEST(ReadModel, RefusesWhatIsForOnePatchWhereNurbsAreDivided) {
  EXPECT_EQ(fault(nurbs_model("", R"("loops": [["p:v0"]])")),
            " /patches/0/loops: a surface with creases inside cannot have loops: divide it at its "
            "knots into 2 patches");
  EXPECT_TRUE(fault(nurbs_model("", R"("sources": [{"along": "p:v0", "size": 1}])"))
                  .starts_with(" /patches/0/sources/0/along: along is for one patch"));
  EXPECT_EQ(fault(nurbs_model("", R"("sources": [{"at": [3, 0], "size": 1}])")),
            " /patches/0/sources/0/at: this point is outside of the domain");
}

TEST(ReadModel, NamesTheEntryOfNurbsThatIsWrong) {
  const std::string good = nurbs_model();
  const std::string front = " /patches/0/surface/nurbs/";
  EXPECT_EQ(fault(changed(good, "[0, 0, 1, 1]", "[0, 0, 1]")),
            front +
                "knots/1: 2 points of degree 1 along v need 4 knots (points + degree + 1), here "
                "are 3");
  EXPECT_EQ(fault(changed(good, "[0, 0, 1, 1]", "[0, 2, 1, 1]")),
            front + "knots/1/2: a knot must not be smaller than the one before, 2");
  EXPECT_TRUE(fault(changed(good, "[1, 1]", "[1, 1.5]")).starts_with(front + "degree/1: a degree"));
  EXPECT_TRUE(fault(changed(good, "[1, 0, 1]", "[1, 0]")).starts_with(front + "points/0/1: "));
  EXPECT_EQ(fault(changed(good, ", [2, 1, 0]", "")),
            front + "points/1: this row has 2 points, the first one 3");
  EXPECT_EQ(fault(nurbs_model(R"("weights": [[1, 1, 1], [1, 0, 1]])")),
            front + "weights/1/1: a weight must be finite and above 0");
  EXPECT_TRUE(fault(nurbs_model(R"("weights": [])")).starts_with(front + "weights: "));
  EXPECT_TRUE(fault(nurbs_model(R"("weight": [])")).find("did you mean weights?") !=
              std::string::npos);
}

TEST(ReadModel, DoesNotMixNurbsAndFormulas) {
  EXPECT_TRUE(fault(changed(nurbs_model(), R"("surface": {)", R"("surface": {"z": "u", )"))
                  .starts_with(" /patches/0/surface"));
  EXPECT_TRUE(fault(model("", R"("contours": [{"name": "c", "on": [{"patch": "p", "u": "t",
      "nurbs": {"degree": 1, "knots": [0, 0, 1, 1], "points": [[0, 0], [1, 0]]}}]}])"))
                  .starts_with(" /contours/0/on/0"));
}

/// A contour on the patch p with this curve and these other keys.
std::string nurbs_contour(const std::string& nurbs, const std::string& keys = "") {
  return contour(R"("name": "c", "on": [{"patch": "p", "nurbs": {)" + nurbs + "}}]" + keys);
}

constexpr const char* kPolygon =
    R"("degree": 1, "knots": [0, 0, 1, 4, 4], "points": [[0, 0], ["1/2", 0], [2, 1]])";

TEST(ReadModel, ReadsNurbsOfContours) {
  const ContourInput whole = read(nurbs_contour(kPolygon)).contours.at(0);
  EXPECT_EQ(whole.range.to, 4);
  EXPECT_EQ(whole.breaks, (std::vector<double>{0.25}));
  EXPECT_EQ(whole.on.at(0).curve->evaluate(0.25), (Uv{0.5, 0}));
  EXPECT_EQ(whole.on[0].curve->evaluate(1), (Uv{2, 1}));
  const ContourInput part = read(nurbs_contour(kPolygon, R"(, "range": [0, 1])")).contours.at(0);
  EXPECT_EQ(part.on.at(0).curve->evaluate(1), (Uv{0.5, 0}));
  EXPECT_TRUE(part.breaks.empty());
}

TEST(ReadModel, NamesTheEntryOfNurbsOfContoursThatIsWrong) {
  const std::string front = " /contours/0/on/0/nurbs/";
  EXPECT_EQ(fault(nurbs_contour(std::string(kPolygon) + R"(, "weights": [1, 1])")),
            front + "weights: there must be a weight for each of 3 points, here are 2");
  EXPECT_TRUE(
      fault(nurbs_contour(kPolygon, R"(, "range": [0, 5])")).starts_with(front + "knots: "));
  EXPECT_TRUE(fault(nurbs_contour(R"("degree": 1)")).starts_with(" /contours/0/on/0/nurbs"));
}

}  // namespace
}  // namespace surfmesh
