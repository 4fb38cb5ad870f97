// SPDX-License-Identifier: BSD-3-Clause
// Small inputs that went wrong once, through the program: what it makes of them, and that `check`
// agrees.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/program.hh"

namespace surfmesh {
namespace {

struct SharedCase {
  const char* file;
  const char* topology;     ///< as the summary has it
  const char* notice = "";  ///< the start of a line on standard error; none at all if empty
  const char* options = "";
  int status = 0;  ///< of `mesh`, and of `check` where there is a mesh
};

void PrintTo(const SharedCase& shared, std::ostream* out) { *out << shared.file; }

std::string test_name(const ::testing::TestParamInfo<SharedCase>& info) {
  std::string name = info.param.file;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

class SharedCases : public Program, public ::testing::WithParamInterface<SharedCase> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(path_)) GTEST_SKIP() << "no file " << path_;
  }

  std::string path_ =
      (std::filesystem::path(SURFMESH_SHARED_DIR) / "cases" / GetParam().file).string();
};

class MeshedCases : public SharedCases {};

TEST_P(MeshedCases, AreMeshedAndCheckAgrees) {
  const SharedCase& shared = GetParam();
  ASSERT_EQ(run("mesh '" + path_ + "' -o out.om " + shared.options), shared.status) << err_;
  EXPECT_TRUE(says(shared.topology)) << out_;
  if (*shared.notice) {
    EXPECT_NE(err_.find(shared.notice), std::string::npos) << err_;
  } else {
    EXPECT_EQ(err_, "");
  }
  EXPECT_EQ(run("check out.om --model '" + path_ + "' " + shared.options), shared.status)
      << out_ << err_;
}

constexpr char kDisc[] = "open, Euler characteristic 1\n";
constexpr char kTube[] = "open, Euler characteristic 0\n";
constexpr char kPlateWithTwoHoles[] = "open, Euler characteristic -1\n";
constexpr char kBall[] = "closed, Euler characteristic 2\n";
constexpr char kTwoBalls[] = "closed, Euler characteristic 4\n";
constexpr char kTorus[] = "closed, Euler characteristic 0\n";

constexpr char kFlatInCorner[] = "triangles are as flat as quality";

INSTANTIATE_TEST_SUITE_P(
    Soak, MeshedCases,
    ::testing::Values(SharedCase{"soak/cone_through_tip.json", kPlateWithTwoHoles},
                      SharedCase{"soak/cube_corners.obj", kBall},
                      SharedCase{"soak/cube_thin.obj", kBall, "--weld removes these sides"},
                      SharedCase{"soak/cylinder_coarse.json", kTube},
                      SharedCase{"soak/fan_100.obj", kDisc},
                      SharedCase{"soak/fold.json", kTube, "where the surface turns over", "", 3},
                      SharedCase{"soak/ngon_400.obj", kDisc},
                      SharedCase{"soak/pipe_thin.json", kTube},
                      SharedCase{"soak/torus_inner_nodes.obj", kTorus, kFlatInCorner},
                      SharedCase{"soak/voxels_loop_grid.obj", kBall}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Trial, MeshedCases,
    ::testing::Values(SharedCase{"trial/blade_closed.json", kBall},
                      SharedCase{"trial/flip.obj", kBall, "--orient turns back what is turned"},
                      SharedCase{"trial/flip.obj", kBall, "turned 1 face to agree", "--orient"},
                      SharedCase{"trial/mug.obj", kTorus},
                      SharedCase{"trial/mug_blender34.obj", kTorus},
                      SharedCase{"trial/split.obj", "Euler characteristic 6\n",
                                 "--weld joins them"},
                      SharedCase{"trial/split.obj", kBall, "welded 16 vertices", "--weld 0.1%"}),
    [](const auto& test) { return test_name(test) + (*test.param.options ? "_mended" : ""); });

INSTANTIATE_TEST_SUITE_P(
    Cad, MeshedCases,
    ::testing::Values(SharedCase{"cad/pinch.json", kDisc, "vertices that are taken apart"},
                      SharedCase{"cad/flatcorner.json", kDisc, "", "--sag 0.05%"},
                      SharedCase{"cad/micro.json", kDisc,
                                 "contours that are shorter than the tolerance are left out: 1"}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Field, MeshedCases,
    ::testing::Values(SharedCase{"field/big-domain-boundary/ocean.json", kDisc},
                      SharedCase{"field/bore-across-seam/off_seam.json", kPlateWithTwoHoles},
                      SharedCase{"field/cage-two-blends/box.obj", kBall},
                      SharedCase{"field/cage-two-blends/box4.obj", kBall},
                      SharedCase{"field/cage-two-blends/box_low.obj", kBall},
                      SharedCase{"field/cage-two-quads-two-edges/flat.off", kDisc},
                      SharedCase{"field/collapsed-side/cusp.json", kDisc},
                      SharedCase{"field/collapsed-side/flat.json", kDisc},
                      SharedCase{"field/collapsed-side/octants.json", kBall},
                      SharedCase{"field/cone-apex/closed.json", kBall},
                      SharedCase{"field/cone-apex/cone.json", kDisc},
                      SharedCase{"field/cone-apex/needle10.json", kDisc},
                      SharedCase{"field/cone-apex/needle20.json", kDisc},
                      SharedCase{"field/cone-apex/needle200.json", kDisc},
                      SharedCase{"field/far-from-origin/near.json", kTube},
                      SharedCase{"field/far-from-origin/utm.json", kTube},
                      SharedCase{"field/far-from-origin/very.json", kTube},
                      SharedCase{"field/groups-kept/box.obj", kBall},
                      SharedCase{"field/helical-pipe/turns3.json", kTube},
                      SharedCase{"field/helical-pipe/turns40.json", kTube},
                      SharedCase{"field/narrow-table/one_row.json", kDisc},
                      SharedCase{"field/narrow-table/w2e-2.json", kDisc},
                      SharedCase{"field/obj-concave-polygons/ell.obj", kBall},
                      SharedCase{"field/obj-negative-blocks/two.obj", kTwoBalls},
                      SharedCase{"field/point-and-line-inside/plate.json", kDisc},
                      SharedCase{"field/size-function/f.json", kDisc},
                      SharedCase{"field/size-function/f_grade0.json", kDisc},
                      SharedCase{"field/thin-slit/bridge.json", kDisc, "nearly meet"},
                      SharedCase{"field/thin-slit/slit.json", kDisc},
                      SharedCase{"field/two-regions/plates.json", kDisc}),
    test_name);

TEST_F(Program, TellsHowFarVerticesOfAFarModelMoveInStl) {
  const auto path =
      std::filesystem::path(SURFMESH_SHARED_DIR) / "cases/field/far-from-origin/utm.json";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no file " << path;
  EXPECT_EQ(run("mesh '" + path.string() + "' -o out.stl"), 0);
  EXPECT_TRUE(says("out.stl holds positions in single precision: vertices move by up to 0.25"))
      << err_;
  EXPECT_EQ(run("mesh '" + path.string() + "' -o out.om"), 0);
  EXPECT_EQ(run("convert out.om out.stl"), 0);
  EXPECT_TRUE(says("beyond single precision: vertices move by up to 0.25")) << err_;
}

class RefusedCases : public SharedCases {};

TEST_P(RefusedCases, SayWhyAndLeaveNothing) {
  EXPECT_EQ(run("mesh '" + path_ + "' -o out.obj " + GetParam().options), 1);
  EXPECT_TRUE(says(GetParam().notice)) << err_;
  EXPECT_EQ(folder_.count(), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, RefusedCases,
    ::testing::Values(SharedCase{"soak/cube_far.obj", "", "the model lies too far from the origin"},
                      SharedCase{"trial/blade0.json", "", "the position of the surface at (u,v)"},
                      SharedCase{"field/runaway/units.json", "", "hmin = 0.129 (in model units)"},
                      SharedCase{"field/runaway/line.json", "", "more than max_elements = 1000000",
                                 "--max-elements 1e6"}),
    test_name);

}  // namespace
}  // namespace surfmesh
