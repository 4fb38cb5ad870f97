// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/png_pixels.hh"
#include "support/program.hh"

namespace surfmesh {
namespace {

using testing::PngPixel;
using testing::PngPixels;

class PictureProgram : public Program {
 protected:
  void mesh(const std::string& model, const std::string& output, const std::string& more = "") {
    ASSERT_EQ(run("mesh '" + own_model(model) + "' --quiet -o " + output + " " + more), 0) << err_;
  }

  std::string read(const char* name) const { return read_text(folder_ / name); }

  /// Expect an error that says so, and no new file.
  void expect_fault(const std::string& arguments, const std::string& text, int status = 1) {
    const auto files = folder_.count();
    EXPECT_EQ(run("picture " + arguments), status) << arguments;
    EXPECT_TRUE(says(text)) << arguments << '\n' << err_;
    EXPECT_EQ(folder_.count(), files) << arguments;
  }
};

TEST_F(PictureProgram, DrawsPixelsAndVectors) {
  mesh("knob.obj", "knob.om");
  EXPECT_EQ(run("picture knob.om -o knob.png"), 0) << err_;
  EXPECT_TRUE(out_.starts_with("knob.png: 900 x 600 pixels")) << out_;
  const PngPixels pixels(read("knob.png"));
  EXPECT_EQ(pixels.width(), 900U);
  EXPECT_EQ(pixels.height(), 600U);
  EXPECT_EQ(pixels.at(2, 2), (PngPixel{255, 255, 255, 255}));
  EXPECT_NE(pixels.at(400, 300), (PngPixel{255, 255, 255, 255}));
  EXPECT_EQ(run("picture knob.om -o KNOB.SVG --size 300x200 --quiet"), 0) << err_;
  EXPECT_TRUE(out_.empty());
  const std::string svg = read("KNOB.SVG");
  EXPECT_NE(svg.find("width=\"300\" height=\"200\""), svg.npos);
  EXPECT_NE(svg.find(">patch<"), svg.npos) << "several patches have colours of their own";
  EXPECT_NE(svg.find(">f36<"), svg.npos);
}

TEST_F(PictureProgram, ColoursByEveryFieldOfAnOmFile) {
  mesh("knob.obj", "knob.om", "--sag 1%");
  for (const char* field : {"patch", "group", "quality", "shape", "size", "stretch", "length",
                            "valence", "sag", "plain"}) {
    EXPECT_EQ(run(std::string("picture knob.om --size 300x200 -o a.svg --colour ") + field), 0)
        << field << err_;
  }
  EXPECT_EQ(run("picture knob.om -o a.svg --color group"), 0) << err_;
  EXPECT_NE(read("a.svg").find(">grip<"), std::string::npos);
  EXPECT_EQ(run("picture knob.om -o a.svg --color group --key off"), 0) << err_;
  EXPECT_EQ(read("a.svg").find("<text"), std::string::npos);
}

TEST_F(PictureProgram, SaysHowAMeshComesToHaveAField) {
  mesh("knob.obj", "knob.om");
  ASSERT_EQ(run("convert knob.om knob.off --quiet"), 0);
  expect_fault("knob.off -o a.png --colour quality",
               "knob.off: no colours of quality: it has no metric: mesh the model, and write the "
               "mesh to an .om file");
  expect_fault("knob.off -o a.png --colour patch", "it has no patches");
  expect_fault("knob.off -o a.png --colour group", "it has no groups");
  expect_fault("knob.om -o a.png --colour sag", "mesh the model with --sag");
  expect_fault("knob.off -o a.png --plane 0", "no plane of parameters: the mesh has no (u,v)");
  expect_fault("knob.om -o a.png --colour qualty", "a mesh has no field \"qualty\"", 2);
}

TEST_F(PictureProgram, ShowsThePlaneOfAPatch) {
  mesh("wave.json", "wave.om", "--hmin 0.3");
  EXPECT_EQ(run("picture wave.om -o a.svg --plane wave --ellipses"), 0) << err_;
  EXPECT_NE(read("a.svg").find(">-6<"), std::string::npos) << "the range of u";
  EXPECT_NE(read("a.svg").find("#b2182b"), std::string::npos) << "an ellipse";
  EXPECT_EQ(run("picture wave.om -o b.svg --plane 0 --ellipses"), 0) << err_;
  EXPECT_EQ(read("a.svg"), read("b.svg"));
  expect_fault("wave.om -o c.svg --plane wave --ellipses --size 24x24", "it takes at least 45x34");
  expect_fault("wave.om -o c.svg --plane wavy", "there is no patch wavy, did you mean wave?");
  expect_fault("wave.om -o c.svg --plane 1", "there is no patch 1: there is wave");
  expect_fault("wave.om -o c.svg --plane -1", "there is no patch -1");
  expect_fault("wave.om -o c.svg --ellipses", "--ellipses requires --plane", 2);
  expect_fault("wave.om -o c.svg --plane wave --azimuth 3", "excludes", 2);
}

TEST_F(PictureProgram, LooksFromEverywhere) {
  mesh("knob.obj", "knob.om");
  std::vector<std::string> pictures;
  for (const char* view : {"", "--azimuth 30", "--elevation -20", "--up y", "--perspective",
                           "--zoom 2", "--look-at 0,0,0", "--fit grip", "--fit f36"}) {
    ASSERT_EQ(run(std::string("picture knob.om -o a.svg --size 200x200 --quiet ") + view), 0)
        << view << err_;
    pictures.push_back(read("a.svg"));
  }
  for (std::size_t i = 1; i < pictures.size(); ++i) EXPECT_NE(pictures[i], pictures[0]) << i;
  expect_fault("knob.om -o b.svg --fit gripp",
               "there is no patch or group gripp, did you mean grip");
  expect_fault("knob.om -o b.svg --elevation 91", "--elevation", 2);
  expect_fault("knob.om -o b.svg --zoom 0", "--zoom", 2);
  expect_fault("knob.om -o b.svg --perspective --azimuth 0 --look-at 1e6,0,1e6",
               "the point to look at (1e+06, 0, 1e+06) is not in front of the eye");
  expect_fault("knob.om -o b.svg --look-at 1,2", "--look-at", 2);
}

TEST_F(PictureProgram, LetsThroughWithoutABackground) {
  mesh("knob.obj", "knob.om");
  EXPECT_EQ(run("picture knob.om -o a.png --background none"), 0) << err_;
  EXPECT_EQ(PngPixels(read("a.png")).at(2, 2)[3], 0);
  EXPECT_EQ(PngPixels(read("a.png")).at(400, 300)[3], 255);
}

TEST_F(PictureProgram, TellsErrors) {
  write_text(folder_ / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_fault("a.obj -o b.gif", "b.gif: the ending of a picture is .svg or .png");
  expect_fault("a.obj -o no/b.png", "there is no folder no");
  expect_fault("none.obj -o b.png", "cannot read none.obj: it does not exist");
  expect_fault("a.step -o b.png", "a.step: the ending of a mesh is");
  expect_fault("a.obj -o b.png --size 0x0", "a picture of 0x0 pixels: sides are from 16 to 16384");
  expect_fault("a.obj -o b.png --size 100000x100000", "at most 33 million pixels");
  expect_fault("a.obj -o b.png --size 16000x16000", "at most 33 million pixels");
  expect_fault("a.obj -o b.png --size 900", "900 is no size: give WIDTHxHEIGHT", 2);
  expect_fault("a.obj -o b.png --size -3x4", "-3x4 is no size", 2);
  expect_fault("a.obj -o b.png --edges maybe", "--edges", 2);
  expect_fault("a.obj", "--output is required", 2);
  std::filesystem::copy_file(folder_ / "a.obj", folder_ / "a.png");
  EXPECT_EQ(run("picture a.png -o a.png"), 1);
  EXPECT_EQ(folder_.count(), 2);
}

TEST_F(PictureProgram, DrawsOddMeshes) {
  const std::vector<std::string> meshes = {
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
      "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 4 0\nv 0 4 0\nf 1 2 3 4 5 6\n",
      "v 1e9 1e9 1e9\nv 1000000001 1e9 1e9\nv 1e9 1000000001 1e9\nf 1 2 3\n",
      "v 0 0 0\nv 1e300 0 0\nv 0 1e300 1e300\nf 1 2 3\n",
      "v 0 0 0\nv 1e-300 0 0\nv 0 1e-300 1e-300\nf 1 2 3\n",
      "v 0 0 0\nv 1e6 0 0\nv 0 1e-6 0\nf 1 2 3\n"};
  for (const std::string& text : meshes) {
    write_text(folder_ / "a.obj", text);
    EXPECT_EQ(run("picture a.obj -o a.png"), 0) << text << err_;
    EXPECT_EQ(PngPixels(read("a.png")).width(), 900U);
    EXPECT_EQ(run("picture a.obj -o a.svg --colour shape"), 0) << text << err_;
  }
}

TEST_F(PictureProgram, KeepsAnOldPictureWhereItFails) {
  write_text(folder_ / "a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
  write_text(folder_ / "a.png", "old");
  EXPECT_EQ(run("picture a.obj -o a.png"), 1);
  EXPECT_EQ(read("a.png"), "old");
}

}  // namespace
}  // namespace surfmesh
