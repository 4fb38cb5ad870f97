// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <string>

#include "support/program.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh/formula/formula.hh"
#include "surfmesh/pipeline/option_table.hh"

namespace surfmesh {
namespace {

class MeshProgram : public Program {
 protected:
  /// Run `surfmesh mesh <input> -o out.obj <options>` with a model of ours.
  int mesh(const std::string& model, const std::string& options = "") {
    return run("mesh '" + own_model(model) + "' -o out.obj " + options);
  }

  /// Expect the status of an error, its text, and that no file was left.
  void expect_error(int status, const std::string& text, long files_before = 0) {
    EXPECT_EQ(status, 1);
    EXPECT_TRUE(err_.starts_with("surfmesh: error: ")) << err_;
    EXPECT_NE(err_.find(text), std::string::npos) << err_;
    EXPECT_EQ(folder_.count(), files_before);
  }

  void expect_wrong_usage(int status, const std::string& text) {
    EXPECT_EQ(status, 2);
    EXPECT_NE(err_.find(text), std::string::npos) << err_;
    EXPECT_EQ(folder_.count(), 0);
  }

  nlohmann::json report() const {
    return nlohmann::json::parse(read_text(folder_ / "report.json"));
  }
};

TEST_F(MeshProgram, HelpsWithDefaultsAndAnExample) {
  EXPECT_EQ(run("mesh --help"), 0);
  for (const char* text :
       {"--curvature", "0.25",      "--hmin",         "0.1%",     "--hmax",         "20%",
        "--stretch",   "--grade",   "--size",         "--sag",    "--crease-angle", "--scheme",
        "--patches",   "--threads", "--max-elements", "--report", "--quiet",        "--set",
        "Examples:",   "--help-all"}) {
    EXPECT_NE(out_.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(run("--help"), 0);
  EXPECT_NE(out_.find("mesh"), std::string::npos);
}

TEST_F(MeshProgram, HelpsOnOneScreen) {
  for (const char* command : {"mesh", "control", "check"}) {
    EXPECT_EQ(run(std::string(command) + " --help"), 0);
    EXPECT_LE(std::count(out_.begin(), out_.end(), '\n'), 45) << command;
  }
}

TEST_F(MeshProgram, HelpsWithEveryOption) {
  EXPECT_EQ(run("mesh --help-all"), 0);
  for (const Option& option : option_table()) {
    std::string flag = "  --" + std::string(option.name()) + ' ';
    std::replace(flag.begin(), flag.end(), '_', '-');
    EXPECT_NE(out_.find(flag), std::string::npos) << flag;
    EXPECT_NE(out_.find('=' + option.value_text({})), std::string::npos) << flag;
  }
  std::istringstream lines(out_);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST_F(MeshProgram, HelpsWithTheFunctionsOfFormulas) {
  EXPECT_EQ(run("mesh --help-all"), 0);
  std::replace(out_.begin(), out_.end(), '\n', ' ');
  EXPECT_NE(out_.find(formula_functions()), std::string::npos) << out_;
}

TEST_F(MeshProgram, RefusesWordsOfOneDash) {
  EXPECT_EQ(run("mesh '" + own_model("cube.obj") + "' -o a.obj -hmax 5%"), 2);
  EXPECT_NE(err_.find("there is no option -hmax, did you mean --hmax?"), std::string::npos) << err_;
  EXPECT_EQ(out_, "");
  EXPECT_EQ(run("mesh '" + own_model("cube.obj") + "' -oa.obj --quiet"), 0) << err_;
}

TEST_F(MeshProgram, TakesWhatFollowsASwitchForTheInput) {
  const std::string input = own_model("cube.obj");
  EXPECT_EQ(run("mesh --inner-nodes '" + input + "' -o a.obj --report report.json"), 0) << err_;
  EXPECT_EQ(report()["options"]["inner_nodes"], true);
  EXPECT_EQ(run("mesh --features off '" + input + "' -o a.obj --report report.json"), 0) << err_;
  EXPECT_EQ(report()["options"]["features"], false);
  EXPECT_EQ(run("mesh '" + input + "' -o a.obj --report report.json --features=off"), 0) << err_;
  EXPECT_EQ(report()["options"]["features"], false);
}

TEST_F(MeshProgram, WeldsWithAndWithoutATolerance) {
  const std::string input = own_model("cube.obj");
  const auto weld = [&](const std::string& before, const std::string& after) {
    EXPECT_EQ(run("mesh " + before + " '" + input + "' -o a.obj --report report.json " + after), 0)
        << err_;
    return report()["options"]["weld"];
  };
  EXPECT_EQ(weld("", ""), "off");
  EXPECT_EQ(weld("--weld", ""), "0.0001%");
  EXPECT_EQ(weld("", "--weld"), "0.0001%");
  EXPECT_EQ(weld("--weld 0.001", ""), "0.001");
  EXPECT_EQ(weld("--weld=0.1%", ""), "0.1%");
  EXPECT_EQ(weld("--weld off", ""), "off");
}

TEST_F(MeshProgram, MendsACageForAllCommands) {
  const std::string input = " '" SURFMESH_SOURCE_DIR "/tests/pipeline/turned_face.obj'";
  EXPECT_EQ(run("mesh" + input + " -o a.om"), 0);
  EXPECT_NE(err_.find("1 face is turned against its neighbours"), std::string::npos) << err_;
  EXPECT_EQ(run("mesh" + input + " -o a.om --orient"), 0);
  EXPECT_NE(err_.find("turned 1 face to agree with its neighbours"), std::string::npos) << err_;
  EXPECT_EQ(run("check a.om --model" + input + " --orient"), 0) << err_;
  EXPECT_EQ(run("control" + input + " -o a.vtu --orient --weld"), 0) << err_;
}

TEST_F(MeshProgram, SetsEveryOptionByAFlag) {
  EXPECT_EQ(mesh("cube.obj",
                 "--contour-curvature off --inner-nodes --curvature-from differences "
                 "--smoothing off --report report.json"),
            0)
      << err_;
  const nlohmann::json options = report()["options"];
  EXPECT_EQ(options["contour_curvature"], false);
  EXPECT_EQ(options["inner_nodes"], true);
  EXPECT_EQ(options["curvature_from"], "differences");
  EXPECT_EQ(options["smoothing"], "off");
}

TEST_F(MeshProgram, NamesTheFlagOfABadValue) {
  expect_wrong_usage(mesh("cube.obj", "--features maybe"),
                     "--features: features = maybe is outside its range: on or off");
  expect_wrong_usage(mesh("cube.obj", "--hmax 500%"), "hmax = 500% is outside its range");
}

TEST_F(MeshProgram, WritesTheSameFileWithAnyNumberOfThreads) {
  const auto file_with = [this](const std::string& threads) {
    EXPECT_EQ(mesh("knob.obj", "--quiet --hmax 5% --report report.json --threads " + threads), 0);
    return read_text(folder_ / "out.obj");
  };
  const std::string alone = file_with("1");
  EXPECT_EQ(report()["options"]["threads"], 1);
  EXPECT_TRUE(file_with("3") == alone);
  EXPECT_EQ(report()["options"]["threads"], 3);
  EXPECT_TRUE(file_with("all") == alone);
  EXPECT_EQ(report()["options"]["threads"], "all");
}

TEST_F(MeshProgram, RefusesNoThreadsAndVeryMany) {
  for (const char* threads : {"0", "257", "many"}) {
    expect_wrong_usage(mesh("knob.obj", std::string("--threads ") + threads), "threads");
  }
}

TEST_F(MeshProgram, TakesBlocksOfFacesForPatches) {
  const auto patches = [this](const std::string& flags) {
    EXPECT_EQ(mesh("torus.obj", flags + " --quiet --report report.json"), 0) << err_;
    return report()["mesh"]["patches"].get<int>();
  };
  const int faces = patches("--patches faces");
  const int blocks = patches("--patches blocks");
  EXPECT_LT(blocks, faces);
  EXPECT_EQ(patches(""), blocks);
  EXPECT_EQ(patches("--patches blocks --set patches=faces"), faces);
}

TEST_F(MeshProgram, GroupsItsOptions) {
  EXPECT_EQ(run("mesh --help"), 0);
  std::size_t last = 0;
  for (const char* text : {"Options:", "--output", "Sizes", "--hmax", "Meshing:", "--threads",
                           "Cages and patches:", "--scheme", "Examples:"}) {
    const std::size_t place = out_.find(text, last);
    ASSERT_NE(place, std::string::npos) << text << " after " << out_.substr(0, last);
    last = place;
  }
  EXPECT_EQ(run("--help"), 0);
  EXPECT_NE(out_.find("Examples:\n  surfmesh mesh "), std::string::npos) << out_;
}

TEST_F(MeshProgram, WritesNormalsAndParametersThatCheckReads) {
  EXPECT_EQ(mesh("sphere.json", "--normals --uv"), 0) << err_;
  const std::string with = read_text(folder_ / "out.obj");
  EXPECT_NE(with.find("\nvt "), std::string::npos);
  EXPECT_NE(with.find("\nvn "), std::string::npos);
  EXPECT_EQ(run("check out.obj --model '" + own_model("sphere.json") + "'"), 0) << out_ << err_;
  EXPECT_EQ(err_, "");
  EXPECT_EQ(mesh("sphere.json"), 0) << err_;
  EXPECT_EQ(read_text(folder_ / "out.obj").find("\nvn "), std::string::npos);
}

TEST_F(MeshProgram, TellsWhereNormalsHaveNoPlace) {
  EXPECT_EQ(run("mesh '" + own_model("cube.obj") + "' -o a.stl --normals --report a.json"), 0);
  EXPECT_TRUE(
      says("warning: normals has no effect on a.stl: normals of the corners are written to "
           ".obj, .glb or .om"))
      << err_;
  EXPECT_EQ(nlohmann::json::parse(read_text(folder_ / "a.json"))["notices"][0]["kind"],
            "unused_option");
}

TEST_F(MeshProgram, TellsNamesThatAFileChanges) {
  write_text(folder_ / "a.json", R"({"patches": [
      {"name": "box x", "surface": {"z": "0"}, "domain": {"u": [0, 1], "v": [0, 1]}}]})");
  EXPECT_EQ(run("mesh a.json -o a.obj --report r.json"), 0);
  EXPECT_TRUE(
      says("warning: a.obj: 1 name of a patch, group or contour is changed to be words of their "
           "own, the first: box x is box_x"))
      << err_;
  EXPECT_NE(read_text(folder_ / "r.json").find("changed_names"), std::string::npos);
  EXPECT_EQ(run("mesh a.json -o a.ply"), 0);
  EXPECT_FALSE(says("changed")) << err_;
}

TEST_F(MeshProgram, TellsItsVersion) {
  EXPECT_EQ(run("--version"), 0);
  EXPECT_TRUE(out_.starts_with("surfmesh " SURFMESH_VERSION "\n")) << out_;
}

TEST_F(MeshProgram, MeshesACage) {
  EXPECT_EQ(mesh("torus.obj", "--report report.json"), 0);
  EXPECT_TRUE(read_text(folder_ / "out.obj").starts_with("# surfmesh\nv "));
  EXPECT_TRUE(report()["mesh"]["closed"]);
  EXPECT_EQ(report()["mesh"]["euler"], 0);
}

TEST_F(MeshProgram, MeshesAModelFile) {
  EXPECT_EQ(mesh("plate.json", "--report report.json"), 0);
  EXPECT_FALSE(report()["mesh"]["closed"]);
  EXPECT_EQ(report()["options"]["hmin"], "0.005");
}

TEST_F(MeshProgram, WritesEveryFormat) {
  for (const std::string ending : {".obj", ".OFF", ".ply", ".stl", ".om"}) {
    EXPECT_EQ(run("mesh '" + own_model("cube.obj") + "' -o a" + ending), 0) << err_;
    EXPECT_GT(std::filesystem::file_size(folder_ / ("a" + ending)), 1000u);
  }
}

TEST_F(MeshProgram, PrintsNoProgressWhereThereIsNoTerminal) {
  EXPECT_EQ(mesh("torus.obj"), 0);
  EXPECT_EQ(err_, "");
  EXPECT_NE(out_.find("triangles"), std::string::npos);
}

TEST_F(MeshProgram, PrintsAShortTableOrALongOne) {
  EXPECT_EQ(mesh("knob.obj"), 0);
  EXPECT_LE(std::count(out_.begin(), out_.end(), '\n'), 20);
  for (const char* text : {"quality of triangles", "metric length of edges", "0.9 to 1 ",
                           "below 0.3", "time ", "notices   none"}) {
    EXPECT_NE(out_.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(out_.find("stage"), std::string::npos);
  for (const char* flag : {"-v", "--verbose"}) {
    EXPECT_EQ(mesh("knob.obj", std::string("--hmax 5% ") + flag), 0);
    for (const char* text :
         {"stage ", "worst of 6 patches", "hmax       5%  command line", "0.595 to 0.707"}) {
      EXPECT_NE(out_.find(text), std::string::npos) << text << " in " << out_;
    }
  }
}

TEST_F(MeshProgram, TellsEveryNoticeWithVerbose) {
  const std::string unused =
      "--quads on --placement circumcentre --conformity 0.5 --smoothing laplace --sweeps 3 "
      "--repairs 2";
  EXPECT_EQ(mesh("cube.obj", unused), 0);
  EXPECT_TRUE(err_.ends_with("smoothing has no effect on quads; and 2 more like these\n")) << err_;
  EXPECT_TRUE(says("notices   5 warnings\n")) << out_;
  EXPECT_EQ(mesh("cube.obj", unused + " -v"), 0);
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 5);
  EXPECT_TRUE(err_.ends_with("repairs has no effect on quads\n")) << err_;
}

TEST_F(MeshProgram, EstimatesInADryRun) {
  EXPECT_EQ(run("mesh '" + own_model("wave.json") + "' --dry-run --report report.json"), 0) << err_;
  EXPECT_NE(out_.find("estimate  about 14500 triangles"), std::string::npos) << out_;
  EXPECT_NEAR(report()["estimated_elements"].get<double>(), 14500, 100);
  EXPECT_EQ(folder_.count(), 1);
  for (const char* figure : {"mesh", "edges", "quality", "diagonal", "triangles_per_second"}) {
    EXPECT_TRUE(report()[figure].is_null()) << figure;
  }
  EXPECT_EQ(mesh("wave.json", "--dry-run"), 0);
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(MeshProgram, TellsHowRanksWouldShareTheWork) {
  const std::string dry = "mesh '" + own_model("wave.json") + "' --hmax 1% --tile 500 --dry-run ";
  EXPECT_EQ(run(dry + "--ranks 8 --piece-count 16 --report report.json"), 0) << err_;
  EXPECT_EQ(folder_.count(), 1);
  EXPECT_NE(out_.find("pieces    16 on 8 ranks; "), std::string::npos) << out_;
  EXPECT_NE(out_.find("MB sent in all"), std::string::npos) << out_;
  const nlohmann::json pieces = report()["pieces"];
  EXPECT_EQ(pieces["count"], 16);
  EXPECT_EQ(pieces["ranks"], 8);
  EXPECT_NEAR(pieces["largest_share"].get<double>(), 1.1, 0.1);
  const auto of_ranks = pieces["faces_of_ranks"].get<std::vector<double>>();
  EXPECT_NEAR(std::accumulate(of_ranks.begin(), of_ranks.end(), 0.0),
              report()["estimated_elements"].get<double>(), 10);
  EXPECT_GT(report()["tiles"]["count"], 16);
  EXPECT_TRUE(report()["mesh"].is_null());
}

TEST_F(MeshProgram, TakesRanksInADryRunOnly) {
  const std::string wave = "mesh '" + own_model("wave.json") + "' ";
  expect_wrong_usage(run(wave + "-o a.obj --ranks 4"), "--ranks requires --dry-run");
  expect_wrong_usage(run(wave + "--dry-run --piece-count 4"), "--piece-count requires --ranks");
  expect_wrong_usage(run(wave + "--pieces mesh --deal foo"), "--deal: foo is not ");
  EXPECT_EQ(run(wave + "--pieces mesh.pvtu"), 1);
  EXPECT_EQ(
      err_,
      "surfmesh: error: mesh.pvtu: --pieces takes the name of a folder; -o writes one file\n");
}

TEST_F(MeshProgram, TellsOfPiecesInItsReport) {
  EXPECT_EQ(run("mesh '" + own_model("sphere.json") +
                "' --hmax 3% --tile 500 --pieces mesh --piece-count 3 --report report.json"),
            0)
      << err_;
  const nlohmann::json pieces = report()["pieces"];
  EXPECT_EQ(pieces["count"], 3);
  EXPECT_EQ(pieces["ranks"], 1);
  EXPECT_EQ(pieces["faces_of_ranks"], nlohmann::json::array({report()["mesh"]["triangles"]}));
  EXPECT_EQ(pieces["seconds_of_ranks"].size(), 1u);
  EXPECT_EQ(pieces["bytes_sent"], 0);
  EXPECT_EQ(report()["mesh"]["closed"], true);
  EXPECT_EQ(report()["mesh"]["euler"], 2);
}

TEST_F(MeshProgram, TellsThatASagChangesAnEstimate) {
  EXPECT_EQ(mesh("wave.json", "--dry-run --sag 1%"), 0);
  EXPECT_NE(out_.find("the sag changes sizes"), std::string::npos) << out_;
}

TEST_F(MeshProgram, TellsAnOptionThatIsGivenTwice) {
  expect_wrong_usage(mesh("cube.obj", "-o other.obj"), "--output: it is given twice");
}

TEST_F(MeshProgram, NeedsAnOutputUnlessItOnlyEstimates) {
  expect_wrong_usage(run("mesh '" + own_model("wave.json") + "'"), "--output is required");
}

TEST_F(MeshProgram, RefusesMoreTrianglesThanItMayMake) {
  expect_error(mesh("wave.json", "--hmin 1e-6 --hmax 1e-5"),
               "triangles, more than max_elements = 50000000; size = ");
  expect_error(mesh("wave.json", "--hmin 1e-6 --hmax 1e-5 --dry-run"), "about 6.1e+12 triangles");
}

TEST_F(MeshProgram, IsQuiet) {
  EXPECT_EQ(mesh("torus.obj", "--quiet"), 0);
  EXPECT_EQ(out_ + err_, "");
}

TEST_F(MeshProgram, ReportsWhatItDid) {
  EXPECT_EQ(mesh("wave.json", "--hmax 2 --report report.json"), 0) << err_;
  const nlohmann::json json = report();
  for (const char* key : {"input", "options", "notices", "mesh", "edges", "quality", "quads", "sag",
                          "control", "seconds", "triangles_per_second"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["input"], own_model("wave.json"));
  const nlohmann::json seconds = json["seconds"];
  double sum = 0;
  for (const auto& [key, value] : seconds.items()) {
    if (key != "total" && key != "serial" && key != "wall") sum += value.get<double>();
  }
  EXPECT_NEAR(seconds["total"].get<double>(), sum, 1e-9);
  EXPECT_GT(seconds["write"].get<double>(), 0);
  EXPECT_GT(seconds["serial"].get<double>(), 0);
  EXPECT_LT(seconds["serial"].get<double>(), sum);
  const double outside = seconds["read"].get<double>() + seconds["control"].get<double>() +
                         seconds["write"].get<double>();
  EXPECT_NEAR(json["triangles_per_second"].get<double>() * (sum - outside),
              json["mesh"]["triangles"].get<double>(), 1e-3);
}

TEST_F(MeshProgram, ReachesTheSag) {
  EXPECT_EQ(mesh("knob.obj", "--sag 0.2% --report report.json"), 0) << err_;
  const nlohmann::json sag = report()["sag"];
  EXPECT_LE(sag["reached"].get<double>(), sag["asked"].get<double>());
  EXPECT_EQ(report()["options"]["curvature"], "off");
  EXPECT_NE(out_.find("sag"), std::string::npos);
}

/// A model file of a graph over the unit square.
std::string graph(const std::string& z) {
  return R"({"patches": [{"name": "a", "surface": {"z": ")" + z +
         R"("}, "domain": {"u": [0, 1], "v": [0, 1]}}]})";
}

TEST_F(MeshProgram, EndsWithStatus3WhereTheSurfaceJumps) {
  write_text(folder_ / "cliff.json", graph("if(u<0.37,0,1)"));
  const std::string line =
      "not reached: cliff.json: /patches/0: patch a: its surface jumps by 1 at "
      "(u,v) = (0.37, ";
  for (const char* command :
       {"mesh cliff.json -o out.obj --report report.json", "mesh cliff.json -o out.obj --dry-run",
        "mesh cliff.json -o out.obj --sag 1%", "control cliff.json -o out.vtu",
        "check out.obj --model cliff.json"}) {
    EXPECT_EQ(run(command), 3) << command;
    EXPECT_NE(err_.find(line), std::string::npos) << command << err_;
  }
  const nlohmann::json notices = report()["notices"];
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0]["kind"], "surface_jump");
  EXPECT_EQ(notices[0]["severity"], "shortfall");
  EXPECT_EQ(notices[0]["patch"], "a");
}

/// The sag there is not for want of smaller or flatter triangles.
TEST_F(MeshProgram, TellsThatAJumpKeepsTheSag) {
  write_text(folder_ / "cliff.json", graph("floor(2*u+0.5)"));
  EXPECT_EQ(run("mesh cliff.json -o out.obj --sag 1%"), 3);
  EXPECT_NE(err_.find("the surface jumps in this patch"), std::string::npos) << err_;
}

TEST_F(MeshProgram, RefusesASurfaceThatRunsToInfinity) {
  write_text(folder_ / "pole.json", graph("1/(u-0.3)"));
  for (const char* command : {"mesh pole.json -o out.obj", "mesh pole.json -o out.obj --dry-run",
                              "control pole.json -o out.vtu"}) {
    expect_error(run(command), "runs to infinity at (u,v) = (0.3, ", 1);
  }
}

TEST_F(MeshProgram, EndsWithStatus3WhereTheSagIsNotReached) {
  EXPECT_EQ(mesh("torus.obj", "--sag 0.01% --hmin 5% --quiet"), 3);
  EXPECT_TRUE(err_.starts_with("surfmesh: not reached: ")) << err_;
  EXPECT_NE(err_.find("sag"), std::string::npos) << err_;
}

TEST_F(MeshProgram, BeatsTheModelFileByTheCommandLine) {
  EXPECT_EQ(mesh("plate.json", "--hmax 0.3 --set grade=1.2 --report report.json"), 0) << err_;
  const nlohmann::json options = report()["options"];
  EXPECT_EQ(options["hmax"], "0.3");
  EXPECT_EQ(options["grade"], 1.2);
  EXPECT_EQ(options["curvature"], "off");
}

TEST_F(MeshProgram, TakesTheOptionsOfTheControlSpace) {
  EXPECT_EQ(mesh("torus.json",
                 "--control mesh --interpolation s --epsilon 0.2 --inner-nodes "
                 "--reuse 0.1 --report report.json"),
            0)
      << err_;
  const nlohmann::json options = report()["options"];
  EXPECT_EQ(options["interpolation"], "s");
  EXPECT_EQ(options["epsilon"], 0.2);
  EXPECT_EQ(options["inner_nodes"], true);
  EXPECT_EQ(options["reuse"], 0.1);
}

TEST_F(MeshProgram, GivesTheSameBytesTwice) {
  EXPECT_EQ(mesh("knob.obj", "--quiet"), 0);
  const std::string first = read_text(folder_ / "out.obj");
  EXPECT_EQ(mesh("knob.obj", "--quiet"), 0);
  EXPECT_TRUE(first == read_text(folder_ / "out.obj"));
}

TEST_F(MeshProgram, TellsWhatItDidNotReach) {
  write_text(folder_ / "bellows.json", R"json({"patches": [{"name": "bellows", "surface": {
      "x": "cos(u)*(2+cos(9*v))", "y": "sin(u)*(2+cos(9*v))", "z": "v"},
      "domain": {
  "u" : [ 0, 6 ], "v" : [ 0, 6 ]
}
}],
      "sizing": {"curvature": 0, "hmin": 3, "hmax": 3}
})json");
  EXPECT_EQ(run("mesh bellows.json -o out.obj --report report.json --quiet"), 3) << err_;
  EXPECT_NE(err_.find("not reached: "), std::string::npos) << err_;
  EXPECT_FALSE(report()["notices"].empty());
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out.obj"));
}

TEST_F(MeshProgram, WritesTheMetricBesideTheMesh) {
  const std::string mesh = "mesh '" + own_model("cube.obj") + "' --quiet -o ";
  EXPECT_EQ(run(mesh + "a.mesh"), 0) << err_;
  EXPECT_EQ(read_text(folder_ / "a.sol").substr(0, 23), "MeshVersionFormatted 2\n");
  // Both files appear, or none does.
  std::filesystem::remove(folder_ / "a.mesh");
  std::filesystem::remove(folder_ / "a.sol");
  std::filesystem::create_directory(folder_ / "a.sol");
  EXPECT_EQ(run(mesh + "a.mesh"), 1);
  EXPECT_TRUE(says("cannot write a.sol: it is a folder")) << err_;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.mesh"));
}

TEST_F(MeshProgram, WritesTheVersionOfMshFilesThatIsAskedFor) {
  const std::string mesh = "mesh '" + own_model("cube.obj") + "' --quiet -o a.msh";
  EXPECT_EQ(run(mesh), 0) << err_;
  EXPECT_EQ(read_text(folder_ / "a.msh").substr(0, 20), "$MeshFormat\n4.1 1 8\n");
  EXPECT_EQ(run(mesh + " --msh 2.2-text"), 0) << err_;
  EXPECT_EQ(read_text(folder_ / "a.msh").substr(0, 20), "$MeshFormat\n2.2 0 8\n");
  EXPECT_EQ(run("mesh '" + own_model("cube.obj") + "' --quiet -o a.obj --msh 2.2"), 0);
  EXPECT_TRUE(says("warning: msh has no effect on a.obj: it is of .msh files")) << err_;
}

TEST_F(MeshProgram, ReportsTheOptionsOfACage) {
  write_text(folder_ / "a.json", R"({"cages": [{"name": "cube", "file": ")" +
                                     own_model("cube.obj") + R"(", "crease_angle": 30}]})");
  EXPECT_EQ(run("mesh a.json -o a.obj --report report.json"), 0) << err_;
  EXPECT_EQ(
      report()["given"],
      nlohmann::json::parse(R"({"cube:crease_angle": {"value": "30", "from": "model file"}})"));
  EXPECT_EQ(run("mesh a.json -o a.obj --report report.json --crease-angle 40"), 0) << err_;
  EXPECT_EQ(report()["given"],
            nlohmann::json::parse(R"({"crease_angle": {"value": "40", "from": "command line"}})"));
  EXPECT_EQ(report()["options"]["crease_angle"], 40);
  EXPECT_TRUE(report()["notices"].empty());
}

TEST_F(MeshProgram, TellsWrongUsage) {
  expect_wrong_usage(run(""), "subcommand");
  expect_wrong_usage(run("mess"), "there is no command mess, did you mean mesh?");
  expect_wrong_usage(run("mess --help"), "there is no command mess, did you mean mesh?");
  expect_wrong_usage(run("frob --help"), "there is no command frob");
  expect_wrong_usage(run("mesh"), "INPUT");
  expect_wrong_usage(run("mesh '" + own_model("cube.obj") + "'"), "--output");
  expect_wrong_usage(mesh("cube.obj", "--colour red"), "--colour");
  expect_wrong_usage(mesh("cube.obj", "--hmin -1%"), "hmin = -1% is outside its range");
  expect_wrong_usage(mesh("cube.obj", "--scheme doosabin"), "--scheme");
  expect_wrong_usage(mesh("cube.obj", "--set hmin"), "key=value");
}

TEST_F(MeshProgram, TellsWrongSettings) {
  expect_wrong_usage(mesh("cube.obj", "--set hmn=1"), "did you mean hmin?");
  expect_wrong_usage(mesh("cube.obj", "--set quads=maybe"), "quads = maybe is outside its range");
  expect_wrong_usage(mesh("cube.obj", "--patches all"), "patches = all is outside its range");
  expect_wrong_usage(mesh("cube.obj", "--set smoothing=much"), "outside its range");
}

TEST_F(MeshProgram, SuggestsWhatWasMeant) {
  expect_wrong_usage(mesh("cube.obj", "--hmx 3"),
                     "error: there is no option --hmx, did you mean --hmax?\n"
                     "surfmesh mesh --help tells more\n");
  expect_wrong_usage(mesh("cube.obj", "--max-element=7"), "did you mean --max-elements?");
  expect_wrong_usage(run("mesh --outptu a.obj"), "--outptu, did you mean --output?");
  expect_wrong_usage(run("convert a b --quite"), "--quite, did you mean --quiet?");
  expect_wrong_usage(run("chekc a.obj"), "there is no command chekc, did you mean check?");
  expect_wrong_usage(mesh("cube.obj", "--colour red"), "there is no option --colour\n");
}

TEST_F(MeshProgram, TellsSizesThatContradictEachOther) {
  expect_error(
      mesh("cube.obj", "--hmin 0.5 --hmax 10%"),
      "hmin = 0.5 must not be above hmax = 10%, set both: they are lengths of 0.5 and 0.34641");
  expect_wrong_usage(mesh("cube.obj", "--hmax 0"), "hmax = 0 is outside its range");
  expect_wrong_usage(mesh("cube.obj", "--hmax nan"), "hmax = nan cannot be read");
  expect_wrong_usage(mesh("cube.obj", "--hmax 3%%"),
                     "hmax = 3%% cannot be read, it is a length above 0");
}

TEST_F(MeshProgram, TellsInputThatCannotBeRead) {
  expect_error(run("mesh none.obj -o out.obj"), "cannot read none.obj: it does not exist");
  expect_error(run("mesh . -o out.obj"), "ending");
  std::filesystem::create_directory(folder_ / "a.obj");
  expect_error(run("mesh a.obj -o out.obj"), "it is a folder", 1);
}

TEST_F(MeshProgram, TellsInputThatMakesNoSense) {
  write_text(folder_ / "empty.obj", "");
  expect_error(run("mesh empty.obj -o out.obj"), "empty.obj", 1);
  write_text(folder_ / "empty.json", "");
  expect_error(run("mesh empty.json -o out.obj"), "empty.json", 2);
  write_text(folder_ / "broken.obj", "v 0 0 0\nf 1 2 3\n");
  expect_error(run("mesh broken.obj -o out.obj"), "broken.obj:2", 3);
  write_text(folder_ / "broken.json", "{\"patches\": [}");
  expect_error(run("mesh broken.json -o out.obj"), "broken.json:1", 4);
}

TEST_F(MeshProgram, TellsOutputThatCannotBeWrittenBeforeItReads) {
  expect_error(run("mesh none.obj -o out.step"), "the ending of a mesh");
  expect_error(run("mesh none.obj -o no/out.obj"), "there is no folder no");
  expect_error(run("mesh none.obj -o a.obj --report no/r.json"), "there is no folder no");
  expect_error(run("mesh none.obj -o none.obj"), "is the input");
  expect_error(run("mesh none.obj -o a.obj --report a.obj"), "a.obj is the output, too");
}

TEST_F(MeshProgram, KeepsTheOldFileAfterAnError) {
  write_text(folder_ / "out.obj", "old");
  EXPECT_EQ(mesh("knob.obj", "--max-elements 100"), 1);
  EXPECT_NE(err_.find("max_elements"), std::string::npos) << err_;
  EXPECT_EQ(read_text(folder_ / "out.obj"), "old");
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(MeshProgram, EndsOnSignals) {
  const std::string long_run =
      "mesh '" + own_model("knob.obj") + "' -o out.obj --hmin 0.05% --hmax 0.05% --nodes 400";
  EXPECT_EQ(run(long_run, "timeout --preserve-status -s INT 0.5"), 130) << err_;
  EXPECT_EQ(folder_.count(), 0);
  EXPECT_EQ(run(long_run, "timeout --preserve-status -s TERM 0.5"), 143) << err_;
  EXPECT_EQ(folder_.count(), 0);
}

}  // namespace
}  // namespace surfmesh
