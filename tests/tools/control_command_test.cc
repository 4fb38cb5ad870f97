// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/program.hh"

namespace surfmesh {
namespace {

using ControlProgram = Program;

TEST_F(ControlProgram, WritesTheControlMeshesOfAModel) {
  EXPECT_EQ(run("control '" + own_model("wave.json") + "' -o a.vtu --nodes 400 --grade 0"), 0)
      << err_;
  EXPECT_TRUE(says("a.vtu: ")) << out_;
  const std::string text = read_text(folder_ / "a.vtu");
  for (const char* name : {"uv", "sizes", "size", "radii", "patch", "class"}) {
    EXPECT_NE(text.find(std::string("Name=\"") + name + "\""), std::string::npos) << name;
  }
}

TEST_F(ControlProgram, TakesTheOptionsOfControlSpaces) {
  EXPECT_EQ(run("control '" + own_model("wave.json") +
                "' -o a.obj --control grid --nodes 100 --set blend=log"),
            0)
      << err_;
  EXPECT_EQ(out_, "a.obj: 100 nodes, 81 faces\n");
}

TEST_F(ControlProgram, TellsThePatchesWithVerbose) {
  EXPECT_EQ(run("control '" + own_model("wave.json") + "' -o a.obj --control grid --nodes 100 -v"),
            0)
      << err_;
  EXPECT_TRUE(out_.starts_with("a.obj: 100 nodes, 81 faces\n       100 nodes         81 faces  "))
      << out_;
}

TEST_F(ControlProgram, MakesOneMeshForEachPatchOfACage) {
  EXPECT_EQ(run("control '" + own_model("cube.obj") + "' -o a.obj --quiet --patches faces"), 0)
      << err_;
  EXPECT_EQ(out_ + err_, "");
  const std::string text = read_text(folder_ / "a.obj");
  std::size_t groups = 0;
  for (std::size_t i = text.find("\ng "); i != std::string::npos; i = text.find("\ng ", i + 1)) {
    ++groups;
  }
  EXPECT_EQ(groups, 6U);
}

TEST_F(ControlProgram, RefusesOtherEndings) {
  EXPECT_EQ(run("control '" + own_model("wave.json") + "' -o a.ply"), 1);
  EXPECT_TRUE(says("a.ply: control meshes are written as .vtu or .obj")) << err_;
}

TEST_F(ControlProgram, HasNoFlagsOfMeshing) {
  EXPECT_EQ(run("control '" + own_model("wave.json") + "' -o a.vtu --placement frontal"), 2);
}

}  // namespace
}  // namespace surfmesh
