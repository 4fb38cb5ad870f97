// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cad/meshed.hh"
#include "cad/own_shapes.hh"
#include "support/folders.hh"

namespace surfmesh {
namespace {

class CadParts : public ::testing::Test {
 protected:
  Model read(const std::string& name, const CadOptions& options = {}) const {
    return read_cad(write_shape(testing::own_shape(name), folder_.path()), options);
  }

  Model assembly() const {
    testing::write_assembly(folder_ / "machine.step");
    return read_cad(folder_ / "machine.step");
  }

  TestFolder folder_;
};

std::size_t group_size(const Model& model, const std::string& name) {
  return find_group(model, name).size();
}

TEST_F(CadParts, AreGroupsWithNames) {
  const Model model = assembly();
  EXPECT_EQ(group_size(model, "plate"), 6u);
  EXPECT_EQ(group_size(model, "bolt"), 6u);
  EXPECT_EQ(group_size(model, "bolt.1"), 3u);
  EXPECT_EQ(group_size(model, "bolt.2"), 3u);
}

TEST_F(CadParts, AreWhereTheAssemblyPutsThem) {
  const Model model = assembly();
  EXPECT_NEAR(model.box.max().z(), 4, 1e-6);
  EXPECT_NEAR(model.box.min().norm(), 0, 1e-6);
  EXPECT_NEAR((model.box.max() - Vec3(10, 10, 4)).norm(), 0, 1e-6);
}

TEST_F(CadParts, GiveTheirColoursToFacesWithoutOne) {
  const Model model = assembly();
  EXPECT_EQ(group_size(model, "colour #ff0000"), 6u);
  EXPECT_EQ(group_size(model, "colour #0000ff"), 5u);
  EXPECT_EQ(find_group(model, "colour #00ff00"), std::vector{find_patch(model, "plate:top")});
}

TEST_F(CadParts, GiveTheirNameToFaces) {
  const Model model = assembly();
  EXPECT_EQ(model.patches.size(), 12u);
  EXPECT_NO_THROW(find_patch(model, "bolt.1:face1"));
  EXPECT_NO_THROW(find_patch(model, "bolt.2:face3"));
}

TEST_F(CadParts, AreNotNamedWhereThereIsOne) {
  const Model model = read("box");
  for (int i = 1; i <= 6; ++i) EXPECT_EQ(find_patch(model, "face" + std::to_string(i)), i - 1);
  EXPECT_TRUE(model.groups.empty());
  EXPECT_EQ(model.contours.front().name, "edge1");
  EXPECT_FALSE(model.contours.front().is_named);
}

TEST_F(CadParts, AreSolidsWhereAFileHasNoNames) {
  const Model model = read("glued");
  EXPECT_EQ(model.patches.size(), 11u);
  EXPECT_EQ(group_size(model, "solid1"), 6u);
  EXPECT_EQ(group_size(model, "solid2"), 6u);
}

TEST_F(CadParts, ShareTheirContours) {
  std::size_t most = 0;
  for (const Model model = read("glued"); const Contour& contour : model.contours) {
    most = std::max(most, contour.uses.size());
  }
  EXPECT_EQ(most, 3u);
}

TEST_F(CadParts, ComeInMillimetres) {
  EXPECT_NEAR(read("inches").diagonal, 25.4 * std::sqrt(3.0), 1e-6);
}

TEST_F(CadParts, HaveTheOutsideOutside) {
  int reversed = 0;
  for (const Model model = read("fillets"); const Patch& patch : model.patches) {
    reversed += patch.is_reversed ? 1 : 0;
  }
  EXPECT_GT(reversed, 0);
}

TEST_F(CadParts, AreSewnWhereFacesAreLoose) {
  const Model model = read("loose_box");
  EXPECT_EQ(model.contours.size(), 12u);
  ASSERT_TRUE(testing::has(model.notices, NoticeKind::HealedShape));
  EXPECT_NE(model.notices.front().text.find("of 24 edges 12 are left, 0 of them with one face"),
            std::string::npos)
      << model.notices.front().text;
}

TEST_F(CadParts, AreNotSewnIfThatIsOff) {
  const Model model = read("loose_box", {.sew = Length::units(0)});
  EXPECT_EQ(model.contours.size(), 24u);
  EXPECT_TRUE(model.notices.empty());
}

TEST_F(CadParts, AreLeftAsTheyAreWhereTheyAreSolids) {
  const Model model = read("hollow_box", {.sew = Length::units(0.01)});
  EXPECT_EQ(model.contours.size(), 24u);
  EXPECT_TRUE(model.notices.empty());
}

TEST_F(CadParts, AreDividedWhereSplinesHaveCorners) {
  const Model model = read("cornered_prism");
  EXPECT_EQ(model.patches.size(), 7u);
  EXPECT_TRUE(testing::has(model.notices, NoticeKind::HealedShape));
}

TEST_F(CadParts, AreLeftAsTheyAreWhereSplinesHaveNone) {
  const Model model = read("nurbs_sphere");
  EXPECT_EQ(model.patches.size(), 1u);
  EXPECT_TRUE(model.notices.empty());
}

TEST_F(CadParts, LoseTheirTinyEdges) {
  const Model model = read("micro_edge");
  EXPECT_EQ(model.patches.size(), 7u);
  for (const Contour& contour : model.contours) EXPECT_NE(contour.start, contour.end);
  EXPECT_TRUE(testing::has(model.notices, NoticeKind::HealedShape));
}

TEST_F(CadParts, GetThePolesThatTheFileLeavesOut) {
  const Model model = read("sphere_without_poles");
  EXPECT_EQ(std::count_if(model.contours.begin(), model.contours.end(),
                          [](const Contour& contour) { return contour.is_degenerate; }),
            2);
}

TEST_F(CadParts, GetTheSeamThatTheFileLeavesOut) {
  const Model model = read("tube_without_seam");
  ASSERT_EQ(model.patches.size(), 1u);
  EXPECT_EQ(model.patches.front().loops.size(), 1u);
  EXPECT_EQ(model.contours.size(), 3u);
  ASSERT_TRUE(testing::has(model.notices, NoticeKind::HealedShape));
}

TEST_F(CadParts, LoseEdgesThatBoundNothing) {
  const Model model = read("inner_edge");
  EXPECT_EQ(model.contours.size(), 12u);
  ASSERT_TRUE(testing::has(model.notices, NoticeKind::HealedShape));
  EXPECT_NE(model.notices.front().text.find("1 edges that bound no face"), std::string::npos);
}

TEST_F(CadParts, AreNotToldOfWhereNothingIsMended) {
  for (const char* name : {"box", "thread", "open_box", "hollow_sphere"}) {
    EXPECT_TRUE(read(name).notices.empty()) << name;
  }
}

TEST_F(CadParts, MayBeInAnyVersionOfBrepFilesWithTriangles) {
  for (const char* name : {"fillets", "torus_part", "glued"}) {
    const std::size_t patches = read(name).patches.size();
    for (const int version : {1, 2, 3}) {
      testing::write_brep(testing::own_shape(name), folder_ / "part.brep", version);
      EXPECT_EQ(read_cad(folder_ / "part.brep").patches.size(), patches) << name << version;
    }
  }
}

TEST(CadVersion, IsThatOfOpenCascade) { EXPECT_EQ(cad_version().substr(0, 2), "7."); }

}  // namespace
}  // namespace surfmesh
