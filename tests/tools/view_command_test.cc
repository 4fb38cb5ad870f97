// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.hh"
#include "support/pseudo_terminal.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "view/viewer_script.hh"

namespace surfmesh {
namespace {

using testing::PseudoTerminal;
using testing::shown_lines;

/// A model of ours as a word of a command line.
std::string quoted_model(const std::string& name) {
  return std::string("'").append(own_model(name)).append("'");
}

/// Runs the program as if it were installed, with a short script in place of the viewer: no test
/// here needs npm.
class ViewProgram : public Program {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "a/bin");
    std::filesystem::create_directories(folder_ / "a/share/surfmesh");
    std::filesystem::copy_file(SURFMESH_PROGRAM, folder_ / "a/bin/surfmesh");
    write_text(folder_ / "a/share/surfmesh/viewer.js", "/* the viewer */");
  }

  int view(const std::string& arguments) { return shell("a/bin/surfmesh view " + arguments); }

  std::string page(const std::string& name = "p.html") { return read_text(folder_ / name); }

  /// What stands between two texts of the page, once.
  std::string between(const std::string& from, const std::string& to) {
    const std::string text = page();
    const std::size_t begin = text.find(from);
    if (begin == std::string::npos) return {};
    EXPECT_EQ(text.find(from, begin + 1), std::string::npos) << from;
    const std::size_t start = begin + from.size();
    return text.substr(start, text.find(to, start) - start);
  }

  nlohmann::json facts() { return nlohmann::json::parse(between("id=\"facts\">", "</script>")); }

  std::vector<std::string> fields() {
    std::vector<std::string> names;
    const nlohmann::json all = facts();
    for (const nlohmann::json& field : all.at("fields")) names.push_back(field.at("name"));
    return names;
  }

  std::size_t count_of(const std::string& array) {
    return facts().at("arrays").at(array).at("count").get<std::size_t>();
  }
};

using Names = std::vector<std::string>;

constexpr const char* kTwoTriangles =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng left\nf 1 2 3\ng right\nf 1 3 4\n";

TEST_F(ViewProgram, ShowsAMeshAsItIs) {
  write_text(folder_ / "m.obj", kTwoTriangles);
  EXPECT_EQ(view("m.obj -o p.html"), 0) << err_;
  EXPECT_EQ(out_, "p.html: 4 vertices, 2 faces, 0.0 MB\n");
  EXPECT_EQ(err_, "surfmesh: m.obj is shown as it is; to mesh it as a cage, add --mesh\n");
  const nlohmann::json all = facts();
  EXPECT_EQ(all.at("title"), "m.obj");
  EXPECT_EQ(all.at("patches").at(1).at("name"), "right");
  EXPECT_EQ(all.at("centre"), nlohmann::json({0.5, 0.5, 0.0}));
  EXPECT_EQ(all.at("report"), nullptr);
  EXPECT_EQ(all.at("control"), nullptr);
  EXPECT_EQ(all.at("edges"), nullptr);
  EXPECT_FALSE(all.at("closed").get<bool>());
  EXPECT_EQ(fields(), (Names{"patch", "shape", "valence"}));
  EXPECT_EQ(count_of("points"), 12u);
  EXPECT_EQ(count_of("corners"), 6u);
  EXPECT_EQ(count_of("lines"), 10u);  // the open edges, and the one between the patches
  EXPECT_FALSE(all.at("arrays").contains("sizes"));
}

TEST_F(ViewProgram, MeshesACageIfMeshingIsAskedFor) {
  const std::string knob = quoted_model("knob.obj");
  EXPECT_EQ(view(knob + " -o p.html"), 0) << err_;
  EXPECT_EQ(facts().at("report"), nullptr);
  EXPECT_EQ(view(knob + " --mesh -o p.html"), 0) << err_;
  EXPECT_TRUE(says("is meshed as a cage; to see the file itself, leave out the options")) << err_;
  const nlohmann::json all = facts();
  EXPECT_EQ(all.at("report").at("mesh").at("patches"), 6);
  EXPECT_EQ(all.at("control").size(), 6u);
  EXPECT_EQ(all.at("groups").at(0).at("name"), "flange");
  EXPECT_TRUE(all.at("closed").get<bool>());
  EXPECT_EQ(fields(), (Names{"patch", "group", "quality", "shape", "size", "stretch", "length",
                             "valence", "sag"}));
  for (const char* options : {"--hmax 5%", "--set hmax=5%", "--scheme catmark", "--quads"}) {
    EXPECT_EQ(view(knob + " --quiet -o p.html " + options), 0) << err_;
    EXPECT_EQ(out_ + err_, "");
    EXPECT_NE(facts().at("report"), nullptr) << options;
  }
}

TEST_F(ViewProgram, MeshesModels) {
  EXPECT_EQ(view(quoted_model("cylinder.json") + " -o p.html"), 0) << err_;
  EXPECT_EQ(err_, "");
  const nlohmann::json all = facts();
  const nlohmann::json& control = all.at("control").at(0);
  EXPECT_GT(control.at("nodes").get<int>(), 3);
  std::size_t nodes = 0, faces = 0;
  for (const nlohmann::json& part : all.at("control")) {
    nodes += part.at("nodes").get<std::size_t>();
    faces += part.at("faces").get<std::size_t>();
  }
  EXPECT_EQ(count_of("control_uv"), 2 * nodes);
  EXPECT_EQ(count_of("control_metric"), 3 * nodes);
  EXPECT_EQ(count_of("control_class"), faces);
  EXPECT_EQ(count_of("uv") / 2, count_of("metric") / 3);
  EXPECT_EQ(count_of("uv") / 2, count_of("points") / 3 + count_of("extra"));
  EXPECT_EQ(all.at("edges").at("count"), all.at("report").at("edges").at("count"));
}

TEST_F(ViewProgram, AddsWhatOnlyAModelKnows) {
  const std::string model = quoted_model("cylinder.json");
  EXPECT_EQ(run("mesh " + model + " -o m.om --quiet"), 0) << err_;
  EXPECT_EQ(view("m.om -o p.html"), 0) << err_;
  Names names = fields();
  EXPECT_EQ(std::count(names.begin(), names.end(), "sag"), 0);
  EXPECT_EQ(std::count(names.begin(), names.end(), "quality"), 1);
  EXPECT_EQ(view("m.om --model " + model + " -o p.html"), 0) << err_;
  names = fields();
  EXPECT_EQ(std::count(names.begin(), names.end(), "sag"), 1);
  EXPECT_FALSE(facts().at("control").empty());
  // Without (u,v) the corners are projected.
  EXPECT_EQ(run("convert m.om m.stl --quiet"), 0);
  EXPECT_EQ(view("m.stl --model " + model + " -o p.html"), 0) << err_;
  names = fields();
  EXPECT_EQ(std::count(names.begin(), names.end(), "sag"), 1);
  EXPECT_EQ(facts().at("patches").size(), facts().at("control").size());
}

TEST_F(ViewProgram, RefusesAModelOfAnotherMesh) {
  EXPECT_EQ(run("mesh " + quoted_model("knob.obj") + " -o m.om --quiet"), 0) << err_;
  EXPECT_EQ(view("m.om --model " + quoted_model("wave.json") + " -o p.html"), 1);
  EXPECT_TRUE(says("m.om is no mesh of ")) << err_;
  EXPECT_TRUE(says("and the model has 1")) << err_;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "p.html"));
}

TEST_F(ViewProgram, TellsWrongUsage) {
  write_text(folder_ / "m.vtu", "");
  for (const char* arguments :
       {"", "m.vtu", "m.vtu -o p.html --hmax 5%", "m.vtu -o p.html --mesh",
        "m.json -o p.html --model m.json", "m.obj --mesh --model m.json -o p.html",
        "m.obj -o p.html --hmax nothing", "m.obj -o p.html --no-such"}) {
    EXPECT_EQ(view(arguments), 2) << arguments;
    EXPECT_TRUE(says("surfmesh view --help tells more")) << err_;
  }
}

TEST_F(ViewProgram, HelpsOnOneScreen) {
  EXPECT_EQ(view("--help"), 0);
  EXPECT_LE(std::count(out_.begin(), out_.end(), '\n'), 45);
  EXPECT_EQ(out_.find("\n\n\n"), std::string::npos);
  EXPECT_EQ(out_.find("--hmax "), out_.rfind("--hmax ")) << "in an example only";
  EXPECT_EQ(view("--help-all"), 0);
  EXPECT_TRUE(says("  --max-elements"));
}

TEST_F(ViewProgram, TellsBadInput) {
  write_text(folder_ / "bad.obj", "v 0 0 0\nf 1 2 3\n");
  EXPECT_EQ(view("bad.obj -o p.html"), 1);
  EXPECT_TRUE(says("bad.obj:2")) << err_;
  EXPECT_EQ(view("missing.om -o p.html"), 1);
  EXPECT_TRUE(says("missing.om")) << err_;
  EXPECT_EQ(view("a.txt -o p.html"), 1);
  EXPECT_TRUE(says("a.txt")) << err_;
  write_text(folder_ / "m.obj", kTwoTriangles);
  EXPECT_EQ(view("m.obj -o m.obj"), 1);
  EXPECT_TRUE(says("a page is written as .html")) << err_;
  EXPECT_EQ(view("m.obj -o none/p.html"), 1);
  EXPECT_TRUE(says("there is no folder none")) << err_;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "p.html"));
}

TEST_F(ViewProgram, ShowsQuadsPolygonsAndASingleTriangle) {
  write_text(folder_ / "m.off",
             "OFF\n8 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n1.5 2 0\n1 2 0\n"
             "4 0 1 2 3\n5 2 5 6 7 3\n3 1 4 5\n");
  EXPECT_EQ(view("m.off -o p.html"), 0) << err_;
  EXPECT_EQ(count_of("sizes"), 3u);
  EXPECT_EQ(count_of("corners"), 12u);
  EXPECT_EQ(fields(), (Names{"shape", "valence"}));
  EXPECT_TRUE(facts().at("patches").empty());
  write_text(folder_ / "one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(view("one.off -o p.html"), 0) << err_;
  EXPECT_EQ(count_of("corners"), 3u);
}

TEST_F(ViewProgram, ShowsAMeshInAPoint) {
  write_text(folder_ / "m.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n");
  EXPECT_EQ(view("m.off -o p.html"), 0) << err_;
  EXPECT_EQ(facts().at("radius"), 1.0);
  EXPECT_EQ(facts().at("centre"), nlohmann::json({1.0, 1.0, 1.0}));
}

TEST_F(ViewProgram, ShowsPatchesWithoutNames) {
  PolyMesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}),
             c = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, c);
  attach(mesh, keys::face_patch, 2);
  write_mesh(mesh, folder_ / "m.om", {.patches = {"", "named"}, .groups = {}});
  EXPECT_EQ(view("m.om -o p.html"), 0) << err_;
  const nlohmann::json all = facts();
  ASSERT_EQ(all.at("patches").size(), 3u);
  EXPECT_EQ(all.at("patches").at(0).at("name"), "");
  EXPECT_EQ(all.at("patches").at(1).at("name"), "named");
  EXPECT_EQ(all.at("patches").at(2).at("name"), "");
}

TEST_F(ViewProgram, RefusesPatchNumbersThatNoMeshHas) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "property int patch\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ";
  write_text(folder_ / "m.ply", head + "10000000\n");
  EXPECT_EQ(view("m.ply -o p.html"), 1);
  EXPECT_EQ(err_,
            "surfmesh: error: m.ply: face 0 is on patch 10000000: a page has no patch of a number "
            "above 99999\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "p.html"));
  // A picture needs no room for numbers.
  for (const char* options : {"", " --colour patch", " --fit 10000000"}) {
    EXPECT_EQ(
        shell(std::string("ulimit -v 2000000; a/bin/surfmesh picture m.ply -o p.svg") + options), 0)
        << options << err_;
  }
  write_text(folder_ / "m.ply", head + "99999\n");
  EXPECT_EQ(view("m.ply -o p.html"), 0) << err_;
  EXPECT_EQ(facts().at("patches").size(), 100'000u);
}

TEST_F(ViewProgram, HasTheLinesOfPictures) {
  // Two squares without patches that meet at a right angle: the fold is a line like the borders.
  write_text(folder_ / "m.off",
             "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 1\n1 1 1\n4 0 1 2 3\n4 1 4 5 2\n");
  EXPECT_EQ(view("m.off -o p.html"), 0) << err_;
  EXPECT_EQ(count_of("lines"), 2u * 7);
  EXPECT_FALSE(facts().at("arrays").contains("line_contour"));
  // Where a mesh knows its contours, its other borders are lines, too.
  PolyMesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}),
             c = mesh.add_vertex({0, 1, 0}), d = mesh.add_vertex({1, 1, 0});
  mesh.add_face(a, b, c);
  mesh.add_face(b, d, c);
  const auto contour_of = attach(mesh, keys::edge_contour, -1);
  mesh.property(contour_of, EdgeHandle(0)) = 3;
  write_mesh(mesh, folder_ / "m.om");
  EXPECT_EQ(view("m.om -o p.html"), 0) << err_;
  EXPECT_EQ(count_of("lines"), 2u * 4);
  EXPECT_EQ(count_of("line_contour"), 4u);
}

TEST_F(ViewProgram, CountsWhatItWritesToAPipe) {
  write_text(folder_ / "m.obj", kTwoTriangles);
  EXPECT_EQ(
      shell("{ mkfifo p.html; cat p.html >seen & a/bin/surfmesh view m.obj -o p.html; wait; }"), 0);
  EXPECT_EQ(out_, "p.html: 4 vertices, 2 faces, 0.0 MB\n");
  EXPECT_TRUE(page("seen").ends_with("</html>\n"));
  // The size is that of the file.
  write_text(folder_ / "a/share/surfmesh/viewer.js", std::string(2'000'000, ' '));
  EXPECT_EQ(view("m.obj -o q.html"), 0) << err_;
  EXPECT_EQ(out_, "q.html: 4 vertices, 2 faces, 2.0 MB\n");
}

TEST_F(ViewProgram, ShowsNamesThatAreNoText) {
  write_text(folder_ / "m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\ng caf\xE9\nf 1 2 3\n");
  std::filesystem::rename(folder_ / "m.obj", folder_ / "caf\xE9\x02.obj");
  EXPECT_EQ(view("caf*.obj -o p.html"), 0) << err_;
  EXPECT_NE(page().find("<title>caf\xEF\xBF\xBD\xEF\xBF\xBD.obj</title>"), std::string::npos);
  EXPECT_EQ(facts().at("patches").at(0).at("name"), "caf\xEF\xBF\xBD");
}

TEST_F(ViewProgram, TellsStagesAndTakesThemAway) {
  const std::string program = folder_.path().string() + "/a/bin/surfmesh view ";
  const std::string output = " -o " + folder_.path().string() + "/p.html";
  const auto stages = [&](const std::string& arguments) {
    PseudoTerminal terminal("env TERM=dumb " + program + arguments + output, 80);
    EXPECT_EQ(terminal.wait(), 0) << terminal.output();
    Names names;
    for (const std::string& line : shown_lines(terminal.output())) {
      if (!line.starts_with("surfmesh: ")) continue;
      const std::string name = line.substr(line.find(' ') + 1);
      names.push_back(name.substr(0, name.find(' ')));
    }
    return names;
  };
  const std::string model = quoted_model("cylinder.json");
  EXPECT_EQ(run("mesh " + model + " -o m.om --quiet"), 0) << err_;
  const std::string mesh = folder_.path().string() + "/m.om";
  EXPECT_EQ(stages(mesh), (Names{"read", "write"}));
  EXPECT_EQ(stages(mesh + " --model " + model), (Names{"read", "control", "compare", "write"}));
  const Names of_model = stages(model);
  EXPECT_EQ(of_model.front(), "read");
  EXPECT_EQ((Names{of_model.end() - 2, of_model.end()}), (Names{"compare", "write"}));
}

TEST_F(ViewProgram, TellsEveryWarningIfAsked) {
  const std::string unused = quoted_model("cube.obj") +
                             " -o p.html --quads on --placement circumcentre --conformity 0.5 "
                             "--smoothing laplace --sweeps 3 --repairs 2";
  EXPECT_EQ(view(unused), 0) << err_;
  EXPECT_TRUE(err_.ends_with("smoothing has no effect on quads; and 2 more like these\n")) << err_;
  EXPECT_EQ(view(unused + " -v"), 0) << err_;
  EXPECT_TRUE(err_.ends_with("repairs has no effect on quads\n")) << err_;
}

TEST_F(ViewProgram, RefusesOptionsOfMeshingForAMeshWithItsModel) {
  const std::string model = quoted_model("cylinder.json");
  EXPECT_EQ(run("mesh " + model + " -o m.om --quiet"), 0) << err_;
  for (const auto& [option, name] : {std::pair("--quads on", "--quads"),
                                     {"--max-elements 9", "--max-elements"},
                                     {"--set quads=on", "--set quads"}}) {
    EXPECT_EQ(view("m.om -o p.html --model " + model + " " + option), 2) << option;
    EXPECT_TRUE(says(std::string(name) + ": a mesh with its --model is not meshed")) << err_;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "p.html"));
  for (const char* option : {"--hmax 20%", "--nodes 100", "--threads 1"}) {
    EXPECT_EQ(view("m.om -o p.html --model " + model + " " + option), 0) << option << err_;
  }
}

TEST_F(ViewProgram, HoldsNamesThatWouldEndItsScript) {
  const std::string name = "</script><b>";
  write_text(folder_ / "m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\ng " + name + "\nf 1 2 3\n");
  std::filesystem::rename(folder_ / "m.obj", folder_ / "<i>.obj");
  EXPECT_EQ(view("'<i>.obj' -o p.html"), 0) << err_;
  EXPECT_EQ(facts().at("patches").at(0).at("name"), name);
  EXPECT_EQ(facts().at("title"), "<i>.obj");
  EXPECT_EQ(page().find("<b>"), std::string::npos);
  EXPECT_EQ(page().find("<i>"), std::string::npos);
  EXPECT_NE(page().find("<title>&lt;i&gt;.obj</title>"), std::string::npos);
}

TEST_F(ViewProgram, AsksForNothingFromElsewhere) {
  write_text(folder_ / "m.obj", kTwoTriangles);
  EXPECT_EQ(view("m.obj -o p.html"), 0) << err_;
  EXPECT_TRUE(
      between("Content-Security-Policy\" content=\"", "\"").starts_with("default-src 'none'"));
  EXPECT_EQ(page().find("http"), page().find("http-equiv"));
  EXPECT_NE(page().find(">\n/* the viewer */\n</script>"), std::string::npos);
  const std::string first = page();
  EXPECT_EQ(view("m.obj -o p.html"), 0);
  EXPECT_EQ(page(), first);
}

TEST_F(ViewProgram, HoldsMeshesFarFromTheOrigin) {
  write_text(folder_ / "m.obj", "v 1e9 0 0\nv 1000000001 0 0\nv 1e9 1 0\nf 1 2 3\n");
  EXPECT_EQ(view("m.obj -o p.html"), 0) << err_;
  EXPECT_EQ(facts().at("centre").at(0), 1e9 + 0.5);
}

TEST(ViewerScript, IsTakenFromTheFirstPlace) {
  const TestFolder folder;
  const ViewerPlaces places = {folder / "a.js", folder / "b.js", folder / "setup.sh"};
  write_text(places.built, "built");
  EXPECT_EQ(read_viewer_script(places), "built");
  write_text(places.installed, "installed");
  EXPECT_EQ(read_viewer_script(places), "installed");
}

std::string fault_of_places(const ViewerPlaces& places) {
  try {
    read_viewer_script(places);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Io);
    return error.what();
  }
  ADD_FAILURE() << "there is a script";
  return {};
}

TEST(ViewerScript, IsToldToBeMissingWithTheCommandThatMakesIt) {
  const TestFolder folder;
  const ViewerPlaces places = {folder / "a.js", folder / "b.js", folder / "setup.sh"};
  EXPECT_NE(fault_of_places(places).find("\"tools/setup.sh --viewer\" in the sources"),
            std::string::npos);
  write_text(places.setup, "");
  EXPECT_NE(fault_of_places(places).find(places.setup.string() + " --viewer\""), std::string::npos);
  EXPECT_NE(fault_of_places(places).find(places.built.string()), std::string::npos);
}

TEST(ViewerScript, IsBesideAnInstalledProgramOnly) {
  const ViewerPlaces places = viewer_places("/opt/a/bin/surfmesh");
  EXPECT_EQ(places.installed.filename(), "viewer.js");
  EXPECT_TRUE(places.installed.string().starts_with("/opt/a/")) << places.installed;
  EXPECT_TRUE(places.built.empty());
  EXPECT_TRUE(places.setup.empty());
}

TEST(ViewerScript, HasItsPlacesInTheSourcesAndBesideTheProgram) {
  const ViewerPlaces places = viewer_places();
  EXPECT_TRUE(std::filesystem::is_regular_file(places.setup));
  EXPECT_EQ(places.built.filename(), "viewer.js");
  EXPECT_EQ(places.installed.parent_path().filename(), "surfmesh");
}

}  // namespace
}  // namespace surfmesh
