// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/program.hh"

namespace surfmesh {
namespace {

using ConvertProgram = Program;

TEST_F(ConvertProgram, KeepsWhatBothFormatsHold) {
  write_text(folder_ / "a.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\ng left\nf 1 2 3\ng right\nf 1 3 4\n");
  EXPECT_EQ(run("convert a.obj a.ply"), 0) << err_;
  EXPECT_EQ(out_, "a.ply: 4 vertices, 2 faces\n");
  EXPECT_EQ(err_, "");
  EXPECT_EQ(run("convert a.ply b.obj --quiet"), 0) << err_;
  EXPECT_EQ(out_ + err_, "");
  EXPECT_EQ(
      read_text(folder_ / "b.obj"),
      "# surfmesh\nv 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\ng left\nf 1 2 3\ng right\nf 1 3 4\n");
}

TEST_F(ConvertProgram, TellsThePatchesWithVerbose) {
  write_text(folder_ / "a.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng left\nf 1 2 3\ng right\nf 1 3 4\n");
  EXPECT_EQ(run("convert a.obj a.ply -v"), 0) << err_;
  EXPECT_EQ(out_,
            "a.ply: 4 vertices, 2 faces\n         1 faces, area 0.5         left\n"
            "         1 faces, area 0.5         right\n");
}

TEST_F(ConvertProgram, ConvertsBetweenAllFormats) {
  EXPECT_EQ(run("mesh '" + own_model("knob.obj") + "' -o a.om --quiet"), 0) << err_;
  EXPECT_EQ(run("convert a.om b.om"), 0) << err_;
  const std::string counts = out_.substr(out_.find(": "));
  std::string before = "a.om";
  int count = 0;
  for (const char* ending : {"ply", "obj", "off", "om", "stl", "ply", "stl", "off", "ply"}) {
    std::string name = std::to_string(count++);
    name.append(".").append(ending);
    EXPECT_EQ(run("convert " + before + " " + name), 0) << err_;
    EXPECT_TRUE(says(counts)) << out_;
    before = name;
  }
}

TEST_F(ConvertProgram, WritesFormatsOfViewersAndSolvers) {
  EXPECT_EQ(run("mesh '" + own_model("cylinder.json") + "' -o a.om --quiet"), 0) << err_;
  for (const char* ending : {"vtu", "vtk", "msh", "mesh", "meshb", "glb", "inp", "bdf"}) {
    const std::string name = std::string("a.") + ending;
    EXPECT_EQ(run("convert a.om " + name), 0) << err_;
    EXPECT_TRUE(says(name + ": ")) << out_;
  }
  EXPECT_EQ(run("convert a.om b.msh --msh 4.1-text"), 0) << err_;
  EXPECT_EQ(read_text(folder_ / "b.msh").substr(0, 20), "$MeshFormat\n4.1 0 8\n");
  EXPECT_EQ(run("convert a.om b.msh --msh 3"), 2);
  EXPECT_EQ(run("convert a.glb b.obj"), 1);
  EXPECT_TRUE(says("a.glb: .glb files are only written; what is read is ")) << err_;
}

TEST_F(ConvertProgram, LeavesAMetricOfAnotherMeshWithAWarning) {
  write_text(folder_ / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  write_text(folder_ / "a.sol", "old");
  EXPECT_EQ(run("convert a.obj a.mesh"), 0) << err_;
  EXPECT_TRUE(says("warning: a.sol is there already and stays, but it is not of this mesh"))
      << err_;
  EXPECT_EQ(read_text(folder_ / "a.sol"), "old");
}

TEST_F(ConvertProgram, WarnsOfWhatIsLost) {
  EXPECT_EQ(run("mesh '" + own_model("cylinder.json") + "' -o a.om --quiet"), 0) << err_;
  EXPECT_EQ(run("convert a.om a.off"), 0);
  EXPECT_TRUE(says("warning: a.off does not hold the patches of the faces")) << err_;
  EXPECT_TRUE(says("a.off does not hold the parameters (u,v) of the corners")) << err_;
  EXPECT_TRUE(says("a.off does not hold the metric of the corners")) << err_;
}

TEST_F(ConvertProgram, WritesNormalsAndParametersThatAFileHas) {
  const std::string mesh = "mesh '" + own_model("sphere.json") + "' --normals --uv --quiet -o ";
  EXPECT_EQ(run(mesh + "a.obj"), 0) << err_;
  EXPECT_EQ(run(mesh + "a.om"), 0) << err_;
  EXPECT_EQ(run("convert a.om b.obj --normals --uv"), 0);
  EXPECT_EQ(read_text(folder_ / "a.obj"), read_text(folder_ / "b.obj"));
  EXPECT_FALSE(says("(u,v)")) << err_;
  EXPECT_EQ(run("convert a.om b.obj"), 0);
  EXPECT_TRUE(says("b.obj does not hold the normals of the corners")) << err_;
  EXPECT_TRUE(says("b.obj does not hold the parameters (u,v) of the corners")) << err_;
}

TEST_F(ConvertProgram, TellsThatNormalsAndTexturesOfObjFilesAreLeftOut) {
  write_text(folder_ / "a.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n");
  EXPECT_EQ(run("convert a.obj b.obj"), 0);
  EXPECT_TRUE(says("warning: the normals (vn) of a.obj are left out")) << err_;
  EXPECT_TRUE(says("warning: the texture coordinates (vt) of a.obj are left out")) << err_;
  EXPECT_EQ(read_text(folder_ / "b.obj"), "# surfmesh\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  EXPECT_EQ(run("convert a.obj c.obj --normals --uv"), 0);
  EXPECT_TRUE(says("warning: normals has no effect: the mesh has no normals")) << err_;
  EXPECT_TRUE(says("warning: uv has no effect: the mesh has no parameters (u,v)")) << err_;
}

TEST_F(ConvertProgram, TellsHowFarVerticesMoveFarFromTheOrigin) {
  write_text(folder_ / "a.obj", "v 400000 0 0\nv 400001.01 0 0\nv 400000 2 0\nf 1 2 3\n");
  EXPECT_EQ(run("convert a.obj a.stl"), 0);
  EXPECT_TRUE(says("beyond single precision: vertices move by up to 0.01")) << err_;
}

TEST_F(ConvertProgram, WarnsOfWhatIsMended) {
  write_text(folder_ / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 0 1\nf 1 2 3\nf 1 2 4\n");
  EXPECT_EQ(run("convert a.obj a.off"), 0);
  EXPECT_TRUE(says("warning: a.obj: the faces do not make a manifold mesh: 2 sides")) << err_;
}

TEST_F(ConvertProgram, TellsErrors) {
  EXPECT_EQ(run("convert a.obj b.off"), 1);
  EXPECT_TRUE(says("error: cannot read a.obj: it does not exist")) << err_;
  EXPECT_EQ(run("convert a.obj b.step"), 1);
  EXPECT_TRUE(says("b.step: the ending of a mesh is")) << err_;
  EXPECT_EQ(run("convert a.obj no/b.off"), 1);
  EXPECT_TRUE(says("there is no folder no")) << err_;
  write_text(folder_ / "a.obj", "v 0 0 0\nf 1 2 3\n");
  EXPECT_EQ(run("convert a.obj a.obj"), 1);
  EXPECT_TRUE(says("a.obj is the input, it is not overwritten")) << err_;
  EXPECT_EQ(run("convert a.obj b.off"), 1);
  EXPECT_TRUE(says("error: a.obj:2: vertex index 2")) << err_;
  EXPECT_EQ(folder_.count(), 1);
  EXPECT_EQ(run("convert a.obj"), 2);
}

}  // namespace
}  // namespace surfmesh
