// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/load_model.hh"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/cancelling.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/notices.hh"

namespace surfmesh {
namespace {

std::filesystem::path own_model(const std::string& name) {
  return std::filesystem::path(SURFMESH_SOURCE_DIR) / "models" / name;
}

/// A model file of one patch with other keys at its root.
std::string model(const std::string& in_root) {
  return R"({"patches": [{"name": "p", "surface": {"z": "u*v"},
             "domain": {"u": [0, 2], "v": [-1, 1]}}], )" +
         in_root + "}";
}

std::string fault(const std::filesystem::path& path, const CageOptions& options = {}) {
  return error_of([&] { load_model(path, {.cages = options}); });
}

TEST(LoadModel, ReadsCages) {
  const ModelInput input = load_model(own_model("torus.obj"));
  EXPECT_EQ(input.model.patches.size(), 1u);
  EXPECT_EQ(input.options.sizing.curvature, Sizing{}.curvature);
}

TEST(LoadModel, ReadsModelFiles) {
  const ModelInput input = load_model(own_model("plate.json"));
  EXPECT_EQ(input.model.patches.size(), 1u);
  EXPECT_EQ(input.sources.at.size(), 2u);
  EXPECT_EQ(input.options.sizing.least_size().value, 0.005);
}

TEST(LoadModel, NamesAllFilesThatItReads) {
  const TestFolder folder;
  write_text(folder / "sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  write_text(folder / "sizes.csv", "u,v,size\n0,0,0.2\n");
  write_text(folder / "model.json",
             R"({"patches": [{"name": "a", "surface": {"z": "1"}, "domain": {"u": [0, 1],
                 "v": [0, 1]}, "sources": [{"table": "sizes.csv"}]}],
                 "cages": [{"name": "b", "file": "sheet.obj"}]})");
  const auto files = load_model(folder / "model.json").files;
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0], folder / "model.json");
  EXPECT_EQ(files[1], folder / "sheet.obj");
  EXPECT_EQ(files[2], folder / "sizes.csv");
}

TEST(LoadModel, EndsOnceItIsCancelled) {
  testing::Cancelling observer;
  const TestFolder folder;
  write_text(folder / "sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ(error_of([&] { load_model(folder / "sheet.obj", {}, &observer); }),
            testing::kCancelled);
}

TEST(LoadModel, RefusesCagesTooFarFromTheOrigin) {
  const TestFolder folder;
  const std::string path = (folder / "far.obj").string();
  write_text(path,
             "v 1e15 0 0\nv 1000000000000002 0 0\nv 1000000000000002 2 0\nv 1e15 2 0\n"
             "f 1 2 3 4\n");
  const std::string fault = "invalid input: " + path + ": the model lies too far from the origin";
  EXPECT_TRUE(error_of([&] { load_model(path); }).starts_with(fault));
}

TEST(LoadModel, TakesTheOptionsOfAModelFile) {
  const TestFolder folder;
  write_text(folder / "a.json", model(R"("options": {"nodes": 400, "placement": "circumcentre",
                                         "quads": false, "precision": null})"));
  const ModelInput input = load_model(folder / "a.json");
  EXPECT_EQ(input.options.control.regular_nodes, 400);
  EXPECT_EQ(input.options.refine.placement, Placement::Circumcentre);
  EXPECT_EQ(input.options.control.precision, ControlOptions{}.precision);
}

TEST(LoadModel, NamesThePlaceOfAWrongOption) {
  const TestFolder folder;
  const std::string front = "invalid input: " + (folder / "a.json").string() + ": /options/";
  write_text(folder / "a.json", model(R"("options": {"node": 400})"));
  EXPECT_EQ(fault(folder / "a.json"),
            front + "node: there is no option 'node'; did you mean nodes?");
  write_text(folder / "a.json", model(R"("options": {"nodes": 1})"));
  EXPECT_EQ(fault(folder / "a.json"), front +
                                          "nodes: nodes = 1 is outside its range: auto, or a "
                                          "whole number from 4 to 4000000");
  write_text(folder / "a.json", model(R"("options": {"hmin": 1})"));
  EXPECT_EQ(fault(folder / "a.json"), front + "hmin: it belongs in sizing");
}

/// The sizing of a model file, and its fault without the place of the file.
Sizing sizing(const std::string& keys) {
  const TestFolder folder;
  write_text(folder / "a.json", model("\"sizing\": {" + keys + "}"));
  return load_model(folder / "a.json").options.sizing;
}

std::string sizing_fault(const std::string& keys) {
  const std::string text = error_of([&] { sizing(keys); });
  const std::size_t place = text.find(": /sizing/");
  return place == text.npos ? text : text.substr(place + 10);
}

TEST(LoadModel, ReadsTheSizing) {
  const Sizing read = sizing(R"("hmin": 0.02, "hmax": "7%", "stretch": 5, "grade": "off",
      "curvature": 0.06858261876789555, "curvature_from": "differences", "features": "off",
      "contour_curvature": false, "proximity": 0)");
  EXPECT_EQ(read.hmin, Length::units(0.02));
  EXPECT_EQ(read.hmax, Length::share(0.07));
  EXPECT_EQ(read.stretch, 5);
  EXPECT_EQ(read.grade, 0);
  EXPECT_EQ(read.curvature, 0.06858261876789555);
  EXPECT_EQ(read.curvature_from, CurvatureFrom::Differences);
  EXPECT_FALSE(read.features || read.contour_curvature);
  EXPECT_EQ(read.proximity, 0);
}

TEST(LoadModel, ReadsTheSag) {
  EXPECT_EQ(sizing(R"("sag": "0.1%")").sag, Length::share(0.001));
  EXPECT_EQ(sizing(R"("sag": 2)").sag, Length::units(2));
  for (const char* off : {R"("sag": 0)", R"("sag": "off")", R"("sag": null)"}) {
    EXPECT_FALSE(sizing(off).sag.has_value()) << off;
  }
}

TEST(LoadModel, TellsFaultsOfTheSizingAsAllOthers) {
  const std::string length =
      " is outside its range: a length above 0 in model units, or a share of the diagonal up to "
      "100%";
  const std::string unread = " cannot be read, it is" + length.substr(22);
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"("hmin": 0)", "hmin: hmin = 0" + length},
      {R"("hmin": true)", "hmin: hmin = true" + unread},
      {R"("hmin": [1])", "hmin: hmin = [1]" + unread},
      {R"("hmax": "1")", "hmax: hmax = \"1\": a number stands without quotes"},
      {R"("hmax": "500%")", "hmax: hmax = 500%" + length},
      {R"("hmax": "x%")", "hmax: hmax = x%" + unread},
      {R"("sag": -1)", "sag: sag = -1 is outside its range: off, " + length.substr(23)},
      {R"("grade": 0.5)",
       "grade: grade = 0.5 is outside its range: off, or a number from 1 to 1000000"},
      {R"("grade": "1.5")", "grade: grade = \"1.5\": a number stands without quotes"},
      {R"("features": 1)", "features: features = 1 is outside its range: on or off"},
      {R"("Hmin": 1)", "Hmin: there is no option 'Hmin'; did you mean hmin?"},
      {R"("nodes": 9)", "nodes: it belongs in options"},
      {R"("hmin": 2, "hmax": 1)", "hmax: hmin = 2 must not be above hmax = 1"},
      {R"("hmin": "30%", "hmax": "20%")", "hmax: hmin = 30% must not be above hmax = 20%"},
      {R"("hmin": 1, "hmin": 1)", "hmin: this key comes twice"}};
  for (const auto& [keys, text] : cases) EXPECT_EQ(sizing_fault(keys), text) << keys;
}

/// hmax may still come from the command line; what holds then is checked when the model is meshed.
TEST(LoadModel, LeavesABoundThatTheFileDoesNotGiveToOthers) {
  EXPECT_EQ(sizing_fault(R"("hmin": "30%")"), "no error");
}

TEST(LoadModel, HasNoSchemeForModelFiles) {
  const std::string error = fault(own_model("wave.json"), {.scheme = Scheme::Loop});
  EXPECT_NE(error.find("only cages have a subdivision scheme"), std::string::npos) << error;
}

TEST(LoadModel, HasNoKindOfPatchesForModelFilesWithoutCages) {
  const std::string error = fault(own_model("wave.json"), {.patches = PatchKind::Faces});
  EXPECT_NE(error.find("only cages have faces, blocks or regions"), std::string::npos) << error;
}

TEST(LoadModel, HasNoKindOfPatchesInTheOptionsOfFilesWithoutCages) {
  const TestFolder folder;
  const auto fault_with = [&](const std::string& kind) {
    write_text(folder / "a.json",
               R"({"patches": [{"name": "a", "domain": {"u": [0, 1], "v": [0, 1]},
                                "surface": {"z": "0"}}], "options": {"patches": ")" +
                   kind + "\"}}");
    return fault(folder / "a.json");
  };
  const std::string error = fault_with("faces");
  EXPECT_NE(
      error.find("a.json: /options/patches: only cages have faces, blocks or regions as patches"),
      std::string::npos)
      << error;
  EXPECT_EQ(fault_with("auto"), "no error");
}

TEST(LoadModel, TellsThePatchesOfACageInItsOptions) {
  const ModelInput input =
      load_model(own_model("cube.obj"), {.cages = {.patches = PatchKind::Faces}});
  EXPECT_EQ(input.options.patches, PatchKind::Faces);
}

/// A model file of cages of ours, with other keys at its root.
std::string cages(const std::string& scheme, const std::string& in_root = "") {
  return R"({"cages": [{"name": "a", "file": ")" + own_model("cube.obj").string() +
         R"("}, {"name": "b", "file": ")" + own_model("cube.obj").string() + R"(", "scheme": ")" +
         scheme + "\"}]" + in_root + "}";
}

TEST(LoadModel, ReadsSeveralCages) {
  const TestFolder folder;
  write_text(folder / "a.json", cages("bilinear"));
  const Model model = load_model(folder / "a.json", {.cages = {.patches = PatchKind::Faces}}).model;
  EXPECT_EQ(model.patches.size(), 12u);
  EXPECT_EQ(model.patches[6].name, "b:f0");
  EXPECT_EQ(model.contours[12].uses[0].patch, 6);
  ASSERT_EQ(model.groups.size(), 2u);
  EXPECT_EQ(model.groups[1].name, "b");
  EXPECT_EQ(model.groups[1].patches.front(), 6);
  // The vertices of the cube itself, not of its Catmull-Clark limit.
  EXPECT_EQ(model.vertices.back().position.cwiseAbs(), Vec3(1, 1, 1));
  EXPECT_LT(model.vertices.front().position.cwiseAbs().maxCoeff(), 0.9);
}

TEST(LoadModel, ReplacesTheSchemeOfCages) {
  const TestFolder folder;
  write_text(folder / "a.json", cages("catmark"));
  const Model model = load_model(folder / "a.json", {.cages = {.scheme = Scheme::Bilinear}}).model;
  EXPECT_EQ(model.vertices.front().position.cwiseAbs(), Vec3(1, 1, 1));
}

/// Patches of the torus in a model file with these keys for the cage and for the options.
std::size_t torus_patches(const std::string& key, const std::string& option,
                          PatchKind given = PatchKind::Auto) {
  const TestFolder folder;
  write_text(folder / "a.json", R"({"cages": [{"name": "a", "file": ")" +
                                    own_model("torus.obj").string() + "\"" + key +
                                    R"(}], "options": {)" + option + "}}");
  return load_model(folder / "a.json", {.cages = {.patches = given}}).model.patches.size();
}

TEST(LoadModel, TakesBlocksOfCagesForPatches) {
  EXPECT_EQ(torus_patches("", ""), 1u);
  EXPECT_EQ(torus_patches(R"(, "patches": "faces")", ""), 48u);
  EXPECT_EQ(torus_patches("", R"("patches": "faces")"), 48u);
}

TEST(LoadModel, PutsTheKeyOfACageBeforeTheOptionOfTheFile) {
  EXPECT_EQ(torus_patches(R"(, "patches": "blocks")", R"("patches": "faces")"), 1u);
  EXPECT_EQ(torus_patches(R"(, "patches": "blocks")", "", PatchKind::Faces), 48u);
  EXPECT_EQ(torus_patches(R"(, "patches": "auto")", R"("patches": "faces")"), 48u);
}

/// Kinds of the notices about a cage with a turned face, in a model file with these keys for the
/// cage and for the options.
std::vector<NoticeKind> kinds_of_turned_face(const std::string& key, const std::string& option,
                                             const CageOptions& given = {}) {
  const TestFolder folder;
  const std::filesystem::path source(SURFMESH_SOURCE_DIR);
  write_text(folder / "a.json", R"({"cages": [{"name": "a", "file": ")" +
                                    (source / "tests/pipeline/turned_face.obj").string() + "\"" +
                                    key + R"(}], "options": {)" + option + "}}");
  std::vector<NoticeKind> kinds;
  for (const Notice& notice : load_model(folder / "a.json", {.cages = given}).model.notices) {
    kinds.push_back(notice.kind);
  }
  return kinds;
}

TEST(LoadModel, MendsCagesAsTheyAskForIt) {
  const std::vector told = {NoticeKind::TurnedFaces}, mended = {NoticeKind::IgnoredInput};
  EXPECT_EQ(kinds_of_turned_face("", ""), told);
  EXPECT_EQ(kinds_of_turned_face(R"(, "orient": true)", ""), mended);
  EXPECT_EQ(kinds_of_turned_face("", R"("orient": true)"), mended);
  EXPECT_EQ(kinds_of_turned_face(R"(, "orient": false)", R"("orient": true)"), told);
  EXPECT_EQ(kinds_of_turned_face(R"(, "orient": true)", "", {.orient = false}), told);
  const std::vector welded = {NoticeKind::IgnoredInput, NoticeKind::TurnedFaces};
  EXPECT_EQ(kinds_of_turned_face(R"(, "weld": true)", ""), told);
  EXPECT_EQ(kinds_of_turned_face(R"(, "weld": 2)", "").front(), welded.front());
  EXPECT_EQ(kinds_of_turned_face("", R"("weld": "60%")").front(), welded.front());
  EXPECT_EQ(kinds_of_turned_face(R"(, "weld": false)", R"("weld": 2)"), told);
  EXPECT_EQ(kinds_of_turned_face(R"(, "weld": 2)", "", {.weld = Length()}), told);
}

TEST(LoadModel, RefusesToMendWhereThereIsNoCage) {
  EXPECT_NE(fault(own_model("wave.json"), {.weld = Length::units(1)})
                .find("only cages have vertices to weld"),
            std::string::npos);
  EXPECT_NE(fault(own_model("wave.json"), {.orient = true}).find("only cages have faces to orient"),
            std::string::npos);
  EXPECT_EQ(fault(own_model("wave.json"), {.weld = Length(), .orient = false}), "no error");
}

TEST(LoadModel, NamesThePlaceOfABadCage) {
  const TestFolder folder;
  const std::string place = (folder / "a.json").string() + ": /cages/";
  write_text(folder / "a.json", cages("loop"));
  EXPECT_TRUE(fault(folder / "a.json").starts_with("invalid input: " + place + "1/file: "));
  write_text(folder / "a.json", R"({"cages": [{"name": "a", "file": "no.obj"}]})");
  EXPECT_EQ(fault(folder / "a.json"), "io: " + place + "0/file: cannot read " +
                                          (folder / "no.obj").string() + ": it does not exist");
  write_text(folder / "a.json", R"({"cages": [{"name": "a", "file": "a.json"}]})");
  EXPECT_NE(fault(folder / "a.json").find("the ending of a cage is .obj, .off, .ply, .stl or .om"),
            std::string::npos);
}

TEST(LoadModel, JoinsSidesWithinTheJoiningOfTheFileOrThatGiven) {
  const TestFolder folder;
  const auto contours = [&](const std::string& option, const LoadOptions& given = {}) {
    write_text(folder / "a.json", R"({"patches": [
        {"name": "left", "surface": {"z": "0"}, "domain": {"u": [0, 1], "v": [0, 1]}},
        {"name": "right", "surface": {"x": "u+1e-6", "y": "v", "z": "0"},
         "domain": {"u": [1, 2], "v": [0, 1]}}], "options": {)" +
                                      option + "}}");
    return load_model(folder / "a.json", given).model.contours.size();
  };
  EXPECT_EQ(contours(""), 8u);
  EXPECT_EQ(contours(R"("joining": 1e-5)"), 7u);
  EXPECT_EQ(contours("", {.joining = Length::units(1e-5)}), 7u);
  EXPECT_EQ(contours(R"("joining": 1e-5)", {.joining = Length::units(1e-8)}), 8u);
  EXPECT_NE(error_of([&] {
              contours(R"("joining": "2%")");
            }).find("joining = 2% must not be above 1 % of the diagonal"),
            std::string::npos);
  EXPECT_NE(error_of([&] {
              load_model(own_model("cube.obj"), {.joining = Length::units(1e-5)});
            }).find("only patches of formulas have sides to join"),
            std::string::npos);
}

/// A box of 2 × 2 quads in a plane, the right half with vertices of its own and in a group.
constexpr const char* kTornSheet =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\n"
    "g left\nf 1 2 3 4\ng right\nf 5 6 7 8\n";

TEST(LoadModel, MakesCreasesAroundGroupsWhereVerticesAreWelded) {
  const TestFolder folder;
  write_text(folder / "a.obj", kTornSheet);
  const auto write = [&](const std::string& weld, const std::string& group) {
    write_text(folder / "a.json", R"({"cages": [{"name": "a", "file": "a.obj", "weld": )" + weld +
                                      R"(, "creases": [{"group": ")" + group + R"("}]}]})");
  };
  write("false", "right");
  EXPECT_NE(fault(folder / "a.json").find("vertices that are not welded make none"),
            std::string::npos);
  write("true", "right");
  const Model model = load_model(folder / "a.json").model;
  ASSERT_EQ(model.patches.size(), 2u);
  std::size_t shared = 0;
  for (const Contour& contour : model.contours) {
    if (contour.uses.size() != 2) continue;
    ++shared;
    EXPECT_FALSE(contour.is_smooth) << contour.name;
  }
  EXPECT_EQ(shared, 1u);
}

TEST(LoadModel, TakesTheSurfaceOfEachCageFromTheFile) {
  const TestFolder folder;
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.3\nf 1 2 3 4\n");
  write_text(folder / "a.json",
             R"({"cages": [{"name": "a", "file": "a.obj", "surface": "interpolate"},
                           {"name": "b", "file": "a.obj", "surface": "limit"},
                           {"name": "c", "file": "a.obj", "fit": "1%"}],
                 "options": {"surface": "limit"}})");
  const Model model = load_model(folder / "a.json").model;
  ASSERT_EQ(model.fits.size(), 1U);
  EXPECT_EQ(model.fits[0].part, "a:");
  EXPECT_EQ(model.fits[0].vertices, 4U);
  const Model all =
      load_model(folder / "a.json", {.cages = {.surface = SurfaceKind::Interpolate}}).model;
  ASSERT_EQ(all.fits.size(), 3U);
  EXPECT_EQ(all.fits[0].fit, 0);
  EXPECT_NEAR(all.fits[2].fit, 0.01 * std::sqrt(2.09), 1e-12);
}

TEST(LoadModel, TakesNoFitAndNullForAFitOfACage) {
  const TestFolder folder;
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.3\nf 1 2 3 4\n");
  for (const auto& [fit, expected] :
       {std::pair{"null", 0.1}, {"false", 0.0}, {"0", 0.0}, {"\"off\"", 0.0}, {"0.2", 0.2}}) {
    write_text(folder / "a.json",
               fmt::format(R"({{"cages": [{{"name": "a", "file": "a.obj", "fit": {}}}],
                                "options": {{"surface": "interpolate", "fit": 0.1}}}})",
                           fit));
    const Model model = load_model(folder / "a.json").model;
    ASSERT_EQ(model.fits.size(), 1U) << fit;
    EXPECT_EQ(model.fits[0].fit, expected) << fit;
  }
}

TEST(LoadModel, RefusesSurfacesWithoutCages) {
  const TestFolder folder;
  write_text(folder / "a.json", model(R"("options": {"fit": "1%"})"));
  EXPECT_NE(error_of([&] { load_model(folder / "a.json"); }).find("only cages have points to fit"),
            std::string::npos);
  EXPECT_NE(error_of([&] {
              load_model(own_model("wave.json"), {.cages = {.surface = SurfaceKind::Limit}});
            }).find("only cages have a surface to choose"),
            std::string::npos);
}

TEST(LoadModel, TellsThatAWholeCageHasNoBorderForACrease) {
  const TestFolder folder;
  write_text(folder / "a.obj", kTornSheet);
  write_text(folder / "a.json", R"({"cages": [{"name": "sheet", "file": "a.obj",
                                               "creases": [{"group": "sheet"}]}]})");
  EXPECT_EQ(fault(folder / "a.json"),
            "invalid input: " + (folder / "a.json").string() +
                ": /cages/0/creases/0: sheet is the whole cage; a crease is the border of a group "
                "in its file, which has left, right");
}

/// The notices of names that mean two things, for a source of this group.
std::vector<std::string> ambiguous(const std::string& group) {
  const TestFolder folder;
  write_text(folder / "a.obj", kTornSheet);
  write_text(folder / "a.json", R"({"patches": [{"name": "left", "surface": {"z": "3"},
      "domain": {"u": [0, 1], "v": [0, 1]}}], "cages": [{"name": "right", "file": "a.obj"},
      {"name": "other", "file": "a.obj"}], "sources": [{"group": ")" +
                                    group + R"(", "size": 0.1}]})");
  std::vector<std::string> texts;
  for (const Notice& notice : load_model(folder / "a.json").model.notices) {
    if (notice.kind != NoticeKind::AmbiguousName) continue;
    texts.push_back(notice.text.substr(notice.location_size));
    EXPECT_EQ(notice.text.substr(0, notice.location_size),
              (folder / "a.json").string() + ": /sources/0/group: ");
  }
  return texts;
}

TEST(LoadModel, TellsNamesThatMeanTwoThings) {
  EXPECT_EQ(ambiguous("left"),
            std::vector<std::string>{
                "left is the name of a patch and of a group; the source applies to all of them"});
  EXPECT_EQ(ambiguous("right"),
            std::vector<std::string>{
                "right is the name of a cage and of a group; the source applies to all of them"});
  EXPECT_TRUE(ambiguous("other").empty());
}

/// Two unit squares, side by side.
std::string two_squares(const std::string& sources) {
  return R"({"patches": [
      {"name": "left", "surface": {"z": "0"}, "domain": {"u": [0, 1], "v": [0, 1]}},
      {"name": "right", "surface": {"z": "0"}, "domain": {"u": [1, 2], "v": [0, 1]}}],
      "sources": )" +
         sources + "}";
}

TEST(LoadModel, GivesSourcesOfTheModelToAllPatchesOrToThoseOfAGroup) {
  const TestFolder folder;
  write_text(folder / "a.json", two_squares(R"([
      {"field": {"size": "1+x"}}, {"group": "right", "field": {"size": "2"}},
      {"everywhere": true, "size": 3}, {"near": [0, 0, 0], "size": 1},
      {"group": "right", "near": [0, 0, 0], "size": 1},
      {"group": "left", "inside": {"box": [[0, 0, 0], [1, 1, 1]]}, "size": 1}])"));
  const Sources sources = load_model(folder / "a.json").sources;
  ASSERT_EQ(sources.fields.size(), 3u);
  EXPECT_EQ(sources.fields[0].patch, 0);
  EXPECT_EQ(sources.fields[1].patch, 1);
  EXPECT_EQ(sources.fields[2].patch, 1);
  EXPECT_EQ(sources.everywhere.size(), 2u);
  ASSERT_EQ(sources.near.size(), 2u);
  EXPECT_TRUE(sources.near[0].patches.empty());
  EXPECT_EQ(sources.near[1].patches, (std::vector<int>{1}));
  ASSERT_EQ(sources.boxes.size(), 1u);
  EXPECT_EQ(sources.boxes[0].patches, (std::vector<int>{0}));
}

TEST(LoadModel, MakesAGroupOfThePartsOfAPatchWithCreases) {
  const TestFolder folder;
  write_text(folder / "roof.json", R"({"patches": [{"name": "roof", "surface": {"nurbs": {
      "degree": [1, 1], "knots": [[0, 0, 1, 2, 2], [0, 0, 1, 1]],
      "points": [[[0, 0, 0], [1, 0, 1], [2, 0, 0]], [[0, 1, 0], [1, 1, 1], [2, 1, 0]]]}}}],
      "sources": [{"group": "roof", "size": 0.2}]})");
  const ModelInput input = load_model(folder / "roof.json");
  ASSERT_EQ(input.model.groups.size(), 1u);
  EXPECT_EQ(input.model.groups[0].name, "roof");
  EXPECT_EQ(input.model.groups[0].patches, (std::vector<int>{0, 1}));
  EXPECT_EQ(input.model.patches.at(1).name, "roof[1,0]");
  EXPECT_EQ(input.sources.everywhere.size(), 2u);
  EXPECT_EQ(texts_of(input.model.notices, Severity::Warning), std::vector<std::string>{});
}

TEST(LoadModel, NamesThePlaceOfAnUnknownGroup) {
  const TestFolder folder;
  write_text(folder / "a.json",
             model(R"("sources": [{"group": "p", "size": 1}, {"group": "pq", "size": 1}])"));
  EXPECT_EQ(fault(folder / "a.json"),
            "invalid input: " + (folder / "a.json").string() +
                ": /sources/1/group: there is no group or patch pq, did you mean p?");
}

/// A model file of one patch that has loops besides its sides, and contours.
std::string trimmed(const std::string& loops, const std::string& contours) {
  return R"({"patches": [{"name": "p", "surface": {"z": "u*v"},
             "domain": {"u": [0, 2], "v": [-1, 1]},
             "loops": [["p:v0", "p:u1", "-p:v1", "-p:u0"])" +
         loops + R"(]}], "contours": [)" + contours + "]}";
}

TEST(LoadModel, FindsTheSidesThatSizesAreAlong) {
  const TestFolder folder;
  const auto load = [&](const std::string& name) {
    write_text(folder / "a.json",
               R"({"patches": [{"name": "p", "surface": {"z": "0"},
                   "domain": {"u": [0, 1], "v": [0, 2]},
                   "sources": [{"along": ")" +
                   name + R"(", "size": 0.1}]}]})");
    return load_model(folder / "a.json").sources.along;
  };
  const auto along = load("p:v1");
  ASSERT_EQ(along.at(0).curves.size(), 1u);
  EXPECT_EQ(along[0].curves[0]->evaluate(0.5), (Uv{0.5, 2}));
  const std::string front = "/patches/0/sources/0/along: ";
  EXPECT_NE(error_of([&] { load("q:v1"); }).find(front + "there is no side q:v1"),
            std::string::npos);
  EXPECT_NE(error_of([&] { load("rim"); }).find(front + "rim is no contour or side of this patch"),
            std::string::npos);
}

TEST(LoadModel, NamesThePlaceOfBadLoops) {
  const TestFolder folder;
  const std::string front = (folder / "a.json").string() + ": ";
  const auto fault_of = [&](const std::string& loops, const std::string& contours) {
    write_text(folder / "a.json", trimmed(loops, contours));
    const std::string text = fault(folder / "a.json");
    const std::size_t start = text.find(front);
    return start == std::string::npos ? text : text.substr(start + front.size());
  };
  const std::string arc =
      R"json({"name": "a", "range": [0, 3],
              "on": [{"patch": "p", "u": "1+cos(t)/2", "v": "sin(t)/2"}]})json";
  EXPECT_TRUE(fault_of(R"(, ["-a"])", arc)
                  .starts_with("/patches/0/loops/1: patch p: the loop does not close, the gap"));
  const std::string high =
      R"json({"name": "a",
              "xyz": {"x": "1+0.1*cos(2*pi*t)", "y": "0.1*sin(2*pi*t)", "z": "9"}})json";
  EXPECT_TRUE(fault_of(R"(, ["-a"])", high)
                  .starts_with("/contours/0: contour a on patch p: its distance from the patch"));
  EXPECT_EQ(fault_of("", arc), "no error");
}

TEST(LoadModel, WarnsOfUnusedContours) {
  const TestFolder folder;
  write_text(folder / "a.json",
             trimmed("", R"({"name": "a", "on": [{"patch": "p", "u": "t", "v": "0"}]})"));
  const std::vector<std::string> warnings = texts_of(load_model(folder / "a.json").model.notices);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], (folder / "a.json").string() +
                             ": /contours/0: contour a: no loop names it, it is left out");
}

TEST(LoadModel, NamesTheFileOfACageThatCannotBeSubdivided) {
  const std::string error = fault(own_model("cube.obj"), {.scheme = Scheme::Loop});
  EXPECT_NE(error.find("cube.obj: "), std::string::npos) << error;
}

TEST(LoadModel, RefusesUnknownEndings) {
  EXPECT_EQ(fault("a.vtu"),
            "invalid input: a.vtu: this is a mesh, no model; the ending of a cage is .obj, .off, "
            ".ply, .stl or .om, that of a CAD file .step, "
            ".stp, .iges, .igs or .brep, that of a model file .json");
}

}  // namespace
}  // namespace surfmesh
