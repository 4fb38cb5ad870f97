// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/program.hh"

namespace surfmesh {
namespace {

class CheckProgram : public Program {
 protected:
  nlohmann::json check(int status, const std::string& arguments) {
    EXPECT_EQ(run("check --json " + arguments), status) << err_;
    return nlohmann::json::parse(out_);
  }

  void mesh(const std::string& model, const std::string& options = "") {
    EXPECT_EQ(run("mesh '" + own_model(model) + "' -o a.om --quiet " + options), 0) << err_;
  }
};

TEST_F(CheckProgram, FindsNothingWrongWithOurMeshes) {
  for (const std::string model : {"knob.obj", "vault.obj", "icosahedron.off", "sphere.json",
                                  "torus.json", "cylinder.json", "plate.json"}) {
    mesh(model);
    const nlohmann::json json = check(0, "a.om --model '" + own_model(model) + "'");
    EXPECT_TRUE(json["clean"]) << model;
    EXPECT_TRUE(json["manifold"] && json["oriented"]) << model;
    EXPECT_FALSE(json["fit"]["projected"]) << model;
    EXPECT_LT(json["fit"]["distance"]["max_corner"], 1e-6) << model;
  }
}

TEST_F(CheckProgram, ProjectsMeshesWithoutParameters) {
  for (const std::string model : {"knob.obj", "sphere.json", "torus.json", "cylinder.json"}) {
    mesh(model);
    EXPECT_EQ(run("convert a.om a.obj --quiet"), 0);
    // A size among the flags asks for those of a run, by which both are judged then.
    const std::string of_model = " --curvature 0.25 --model '" + own_model(model) + "'";
    const nlohmann::json own = check(0, "a.om" + of_model)["fit"];
    const nlohmann::json projected = check(0, "a.obj" + of_model)["fit"];
    EXPECT_TRUE(projected["projected"]);
    EXPECT_NEAR(projected["edges"]["mean"], own["edges"]["mean"], 2e-3) << model;
    EXPECT_NEAR(projected["quality"]["mean"], own["quality"]["mean"], 2e-3) << model;
    EXPECT_NEAR(projected["distance"]["mean"], own["distance"]["mean"], 1e-4) << model;
    // That of our own mesh is searched for at more places.
    EXPECT_LE(projected["distance"]["max"], 1e-4 + own["distance"]["max"].get<double>()) << model;
  }
}

/// A file without a metric is judged by that of a run, which is the one it was made by.
TEST_F(CheckProgram, TellsAMeshOfAnotherModel) {
  mesh("knob.obj");
  EXPECT_EQ(run("convert a.om a.stl --quiet"), 0) << err_;
  EXPECT_EQ(run("check a.stl --model '" + own_model("cube.obj") + "'"), 3);
  EXPECT_TRUE(says("fault: corner_off_surface: 1, the first: a corner is ")) << err_;
  EXPECT_TRUE(says("this is no mesh of it")) << err_;
}

TEST_F(CheckProgram, JudgesAMeshWithoutAMetricByThatOfARun) {
  for (const std::string& options : {std::string(), std::string(" --hmax 4%")}) {
    EXPECT_EQ(run("mesh '" + own_model("knob.obj") + "' -o a.om --report r.json" + options), 0);
    const nlohmann::json made = nlohmann::json::parse(read_text(folder_ / "r.json"))["edges"];
    for (const char* ending : {"obj", "stl"}) {
      const std::string file = std::string("a.") + ending;
      EXPECT_EQ(run("convert a.om " + file + " --quiet"), 0);
      const std::string arguments = file + " --model '" + own_model("knob.obj") + "'" + options;
      const nlohmann::json fit = check(0, arguments)["fit"];
      EXPECT_FALSE(fit["exact_sizes"]);
      EXPECT_FALSE(fit["stored_metric"]);
      EXPECT_NEAR(fit["edges"]["mean"], made["mean"], 2e-3) << file;
      EXPECT_NEAR(fit["edges"]["unit_fraction"], made["unit_fraction"], 5e-3) << file;
      EXPECT_EQ(run("check " + arguments), 0);
      EXPECT_TRUE(says("the mesh has none: that of a run on the model, with these options"));
    }
  }
}

TEST_F(CheckProgram, TellsAMeshThatIsFartherThanTheSag) {
  mesh("knob.obj");
  EXPECT_EQ(run("convert a.om a.obj --quiet"), 0);
  for (const char* file : {"a.om", "a.obj"}) {
    const std::string arguments = std::string(file) + " --model '" + own_model("knob.obj") + "'";
    const nlohmann::json without = check(0, arguments)["fit"];
    EXPECT_TRUE(without["sag"].is_null());
    const double reached = without["distance"]["max"];
    const nlohmann::json kept = check(0, fmt::format("{} --sag {}", arguments, 1.001 * reached));
    EXPECT_EQ(kept["fit"]["sag"], 1.001 * reached);
    const nlohmann::json missed = check(3, fmt::format("{} --sag {}", arguments, 0.999 * reached));
    ASSERT_EQ(missed["notices"].size(), 1u);
    EXPECT_EQ(missed["notices"][0]["kind"], "sag_not_reached");
    EXPECT_EQ(missed["notices"][0]["severity"], "shortfall");
    EXPECT_EQ(missed["notices"][0]["point"], missed["fit"]["distance"]["max_at"]);
    EXPECT_TRUE(says("not reached: the mesh is ")) << err_;
  }
}

/// However a mesh is measured: a run that reached its sag is not called short of it.
TEST_F(CheckProgram, AgreesWithARunThatReachedItsSag) {
  for (const std::string model : {"knob.obj", "vault.obj", "wave.json", "perforated.json"}) {
    mesh(model, "--sag 0.5% --report r.json");
    const double reached = nlohmann::json::parse(read_text(folder_ / "r.json"))["sag"]["reached"];
    for (const std::string file : {"a.om", "a.obj", "a.stl"}) {
      if (file != "a.om") {
        EXPECT_EQ(run("convert a.om " + file + " --quiet"), 0);
      }
      const nlohmann::json fit =
          check(0, file + " --sag 0.5% --model '" + own_model(model) + "'")["fit"];
      EXPECT_LE(fit["distance"]["max"], fit["sag"]) << model << ' ' << file;
      EXPECT_GT(fit["distance"]["max"], 0.9 * reached) << model << ' ' << file;
    }
  }
}

TEST_F(CheckProgram, MeasuresInTheSizesAskedFor) {
  mesh("torus.json", "--set grade=0");
  const std::string arguments = "a.om --set grade=0 --model '" + own_model("torus.json") + "'";
  const double mean = check(0, arguments + " --set curvature=0.25")["fit"]["edges"]["mean"];
  EXPECT_NEAR(mean, 1, 0.05);
  EXPECT_NEAR(check(0, arguments + " --set curvature=0.125")["fit"]["edges"]["mean"], 2 * mean,
              1e-2);
}

TEST_F(CheckProgram, JudgesAMeshByTheMetricThatItWasMadeBy) {
  mesh("two_scales.json", "--report r.json");
  const nlohmann::json report = nlohmann::json::parse(read_text(folder_ / "r.json"));
  for (const std::string& options :
       {std::string(), " --model '" + own_model("two_scales.json") + "'"}) {
    const nlohmann::json stored = check(0, "a.om" + options)["stored_metric"];
    for (const char* key : {"mean", "min", "max", "unit_fraction", "count"}) {
      EXPECT_EQ(stored["edges"][key], report["edges"][key]) << key;
    }
    EXPECT_EQ(stored["quality"]["min"], report["quality"]["min"]);
  }
}

TEST_F(CheckProgram, JudgesByTheSizesOfARunWhereSizesAreGiven) {
  mesh("torus.json");
  const std::string arguments = "a.om --model '" + own_model("torus.json") + "'";
  EXPECT_TRUE(check(0, arguments + " --set threads=1")["fit"]["stored_metric"]);
  EXPECT_FALSE(check(0, arguments + " --hmax 10%")["fit"]["stored_metric"]);
  // A sag is a distance.
  EXPECT_TRUE(check(0, arguments + " --sag 10%")["fit"]["stored_metric"]);
}

TEST_F(CheckProgram, HasTheDocumentedKeys) {
  mesh("plate.json");
  const nlohmann::json json = check(0, "a.om");
  for (const char* key : {"mesh", "model", "clean", "faults", "notices", "counts", "closed",
                          "manifold", "oriented", "self_intersections", "area", "volume", "box",
                          "angles", "edge_lengths", "shape", "stored_metric", "fit"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_TRUE(json["fit"].is_null());
  EXPECT_EQ(json["counts"]["boundary_loops"], 1);
  EXPECT_EQ(json["counts"]["euler"], 1);
  EXPECT_EQ(json["angles"]["histogram"].size(), 18u);
}

TEST_F(CheckProgram, TellsFaultsAndTheirPlaces) {
  write_text(folder_ / "a.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 2 4\nf 1 2 4\n");
  const nlohmann::json json = check(3, "a.obj");
  EXPECT_FALSE(json["clean"]);
  std::vector<std::string> kinds;
  for (const nlohmann::json& fault : json["faults"]) kinds.push_back(fault["kind"]);
  EXPECT_EQ(kinds,
            (std::vector<std::string>{"non_manifold_edge", "turned_neighbour", "duplicate_face",
                                      "duplicate_vertex", "unused_vertex"}));
  EXPECT_TRUE(says("fault: non_manifold_edge: 1, the first: edge 0-1 at (0.5, 0, 0), of 3 faces"))
      << err_;
  EXPECT_EQ(run("check a.obj"), 3);
  EXPECT_TRUE(says("duplicate_vertex: 1\n            vertices 2 and 4 at (1, 1, 0)")) << out_;
}

TEST_F(CheckProgram, TellsDegenerateFacesOfEveryFormat) {
  const std::string fault =
      "face 1 of the file does not have three different corners, or no inside";
  const auto expect_fault = [&](const std::string& file) {
    const nlohmann::json json = check(3, file);
    ASSERT_EQ(json["faults"].size(), 1u) << file;
    EXPECT_EQ(json["faults"][0]["kind"], "degenerate_face") << file;
    EXPECT_EQ(json["faults"][0]["places"][0], fault) << file;
    EXPECT_TRUE(says("left out")) << err_;
  };
  write_text(folder_ / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 1\n");
  expect_fault("a.obj");
  write_text(folder_ / "a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 0\n");
  expect_fault("a.off");
  write_text(folder_ / "a.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
             "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 0\n");
  expect_fault("a.ply");
  write_text(folder_ / "a.stl",
             "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
             "endfacet\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 0\nendloop\n"
             "endfacet\nendsolid\n");
  expect_fault("a.stl");
}

TEST_F(CheckProgram, TellsMeshesOfAnotherModel) {
  mesh("cylinder.json");
  EXPECT_EQ(run("check a.om --model '" + own_model("wave.json") + "'"), 1);
  EXPECT_TRUE(
      says("lies on patch 1, but the model has 1 patch, counted from 0; was the mesh made of "
           "another model, or with other options of its cages (patches, weld, scheme)?"))
      << err_;
  mesh("wave.json", "--hmax 4 --curvature 0");
  const nlohmann::json json = check(3, "a.om --model '" + own_model("plate.json") + "'");
  EXPECT_FALSE(json["clean"]);
}

TEST_F(CheckProgram, PrintsAShortTableOrALongOne) {
  mesh("knob.obj");
  EXPECT_EQ(run("check a.om --model '" + own_model("knob.obj") + "'"), 0);
  EXPECT_LE(std::count(out_.begin(), out_.end(), '\n'), 25);
  EXPECT_TRUE(says("metric length of edges (1 is wanted)"));
  EXPECT_FALSE(says("angles of corners"));
  EXPECT_EQ(run("check a.om --verbose"), 0);
  EXPECT_TRUE(says("metric length of edges (1 is wanted)"));
  EXPECT_TRUE(says("angles of corners (degrees)"));
}

TEST_F(CheckProgram, TellsErrors) {
  EXPECT_EQ(run("check none.obj"), 1);
  EXPECT_TRUE(says("error: cannot read none.obj: it does not exist")) << err_;
  EXPECT_EQ(run("check none.step"), 1);
  EXPECT_TRUE(says("none.step: this is a model, no mesh: mesh it first; what is read is .obj"))
      << err_;
  EXPECT_EQ(run("check"), 2);
  EXPECT_EQ(run("check a.obj --set hmin=1"), 2);
  EXPECT_TRUE(says("--set requires --model")) << err_;
  EXPECT_EQ(run("check --help"), 0);
  EXPECT_TRUE(says("Example:"));
}

}  // namespace
}  // namespace surfmesh
