// SPDX-License-Identifier: BSD-3-Clause
//
// What the formats of viewers and solvers share: failures, losses, names, files beside the mesh.
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "formats/named_example.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/meshes.hh"
#include "support/notices.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

using Texts = std::vector<std::string>;

class SolverFormat : public ::testing::TestWithParam<std::string> {
 protected:
  std::string written(const PolyMesh& mesh, const MeshNames& names = {},
                      const OutputOptions& options = {}) const {
    write_mesh(mesh, folder_ / ("a" + GetParam()), names, options);
    return read_text(folder_ / ("a" + GetParam()));
  }

  TestFolder folder_;
};

TEST_P(SolverFormat, RefusesPositionsThatAreNotFiniteAndLeavesTheOldFile) {
  PolyMesh mesh = named_example(2);
  mesh.set_point(VertexHandle(3), {kUnset, 0, 1});
  write_text(folder_ / ("a" + GetParam()), "old");
  EXPECT_EQ(error_of([&] { written(mesh); }), "geometry: the position of vertex 3 is (nan, 0, 1)");
  EXPECT_EQ(read_text(folder_ / ("a" + GetParam())), "old");
  EXPECT_EQ(folder_.count(), 1);
}

TEST_P(SolverFormat, TellsThatADeviceIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  for (const int side : {4, 200}) {
    const std::string path = (folder_ / (std::to_string(side) + GetParam())).string();
    std::filesystem::create_symlink("/dev/full", path);
    EXPECT_EQ(error_of([&] { write_mesh(named_example(2, side), path); }),
              "io: cannot write " + path + ": No space left on device");
  }
}

TEST_P(SolverFormat, DoesNotDependOnThreads) {
  const PolyMesh mesh = named_example(2, 100);
  std::string of_one, of_three;
  with_threads(1, [&] { of_one = written(mesh, example_names()); });
  with_threads(3, [&] { of_three = written(mesh, example_names()); });
  EXPECT_TRUE(of_one == of_three);
}

TEST_P(SolverFormat, WritesMeshesWithoutPatchesNamesAndMetric) {
  EXPECT_FALSE(written(testing::octahedron()).empty());
  EXPECT_FALSE(written(testing::octahedron(), example_names()).empty());
  EXPECT_EQ(companion_of(testing::octahedron(), "a" + GetParam()), std::nullopt);
}

TEST_P(SolverFormat, LeavesOutGroupsWithoutPatches) {
  const PolyMesh mesh = named_example(0);
  const MeshNames with = {{"x", "y"}, {{"empty", {}}, {"both", {0, 1}}}};
  EXPECT_NE(written(mesh, with), "");
}

INSTANTIATE_TEST_SUITE_P(Of, SolverFormat,
                         ::testing::Values(".vtu", ".vtk", ".msh", ".mesh", ".meshb", ".glb",
                                           ".inp", ".bdf"),
                         [](const auto& test) { return test.param.substr(1); });

TEST(CompanionOf, IsTheMetricBesideAMeditFile) {
  const PolyMesh mesh = named_example(0);
  EXPECT_EQ(companion_of(mesh, "x/a.mesh"), std::filesystem::path("x/a.sol"));
  EXPECT_EQ(companion_of(mesh, "a.MESHB"), std::filesystem::path("a.solb"));
  EXPECT_EQ(companion_of(mesh, "a.msh"), std::nullopt);
}

TEST(CompanionOf, AppearsTogetherWithTheMesh) {
  const TestFolder folder;
  write_text(folder / "a.mesh", "old");
  std::filesystem::create_directory(folder / "a.sol");
  const std::string error = error_of([&] { write_mesh(named_example(0), folder / "a.mesh"); });
  EXPECT_NE(error.find("a.sol: it is a folder"), std::string::npos) << error;
  EXPECT_EQ(read_text(folder / "a.mesh"), "old");
}

TEST(StaleCompanion, IsToldAndStays) {
  const TestFolder folder;
  EXPECT_TRUE(stale_companion(testing::octahedron(), folder / "a.mesh").empty());
  write_text(folder / "a.sol", "old");
  EXPECT_EQ(stale_companion(testing::octahedron(), folder / "a.mesh").size(), 1U);
  EXPECT_TRUE(stale_companion(named_example(0), folder / "a.mesh").empty());
  EXPECT_TRUE(stale_companion(testing::octahedron(), folder / "a.msh").empty());
  write_mesh(testing::octahedron(), folder / "a.mesh");
  EXPECT_EQ(read_text(folder / "a.sol"), "old");
}

TEST(WhatIsLost, InFormatsOfViewersAndSolvers) {
  const PolyMesh mesh = named_example(2);
  const std::string uv = "the parameters (u,v) of the corners";
  const std::string metric = "the metric of the corners";
  const Texts in_grid = {metric, "the parameters (u,v) of corners where those at a vertex differ",
                         "the contours of the edges, but for those of their ends"};
  EXPECT_EQ(what_is_lost(mesh, "a.vtu"), in_grid);
  EXPECT_EQ(what_is_lost(mesh, "a.vtk"), in_grid);
  EXPECT_EQ(what_is_lost(mesh, "a.msh", {{"x", "y"}, {}}), (Texts{uv, metric}));
  EXPECT_EQ(what_is_lost(mesh, "a.mesh", {{"x", "y"}, {}}),
            (Texts{uv, "the metric of corners where those at a vertex differ"}));
  EXPECT_EQ(what_is_lost(mesh, "a.meshb", {{"x", "y"}, {}}).back(),
            "the names of patches, groups and contours");
  EXPECT_EQ(what_is_lost(mesh, "a.glb"),
            (Texts{"the digits of positions beyond single precision: vertices move by up to "
                   "4.72e-08",
                   "8 faces of more than three corners, which are split", uv, metric,
                   "the contours of the edges"}));
  EXPECT_EQ(what_is_lost(mesh, "a.glb", {}, {.uv = true}).size(), 4U);
  const std::string nodes = "the contours of the edges, but for the vertices of those with names";
  EXPECT_EQ(what_is_lost(mesh, "a.inp", {{"x", "y"}, {}}).at(2), nodes);
  EXPECT_EQ(what_is_lost(mesh, "a.bdf", {{"x", "y"}, {}}).at(2), nodes);
  EXPECT_EQ(what_is_lost(mesh, "a.bdf", {{"x", "y", "z"}, {{"none", {5}}}}).at(3),
            "2 names of patches and groups without faces");
}

TEST(WhatIsLost, OfGroupsInVersion22OfMsh) {
  const PolyMesh mesh = named_example(0);
  EXPECT_EQ(what_is_lost(mesh, "a.msh", {{"x", ""}, {{"both", {0, 1}}, {"one", {0}}}},
                         {.msh = MshVersion::Text22}),
            (Texts{"the parameters (u,v) of the corners", "the metric of the corners",
                   "the names of 1 patches, which have the name of a group in version 2.2",
                   "the groups but the first of 1 patches in version 2.2"}));
}

TEST(WhatIsLost, OfFacesWithFiveCorners) {
  const PolyMesh mesh =
      testing::mesh_of({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4}});
  const Texts split = {"1 faces of more than four corners, which are split"};
  for (const char* name : {"a.msh", "a.mesh", "a.inp", "a.bdf"}) {
    EXPECT_EQ(what_is_lost(mesh, name), split) << name;
  }
  EXPECT_EQ(what_is_lost(mesh, "a.vtu"), Texts());
}

TEST(ChangedNames, AreWordsOfTheirOwn) {
  const PolyMesh mesh = named_example(0);
  const MeshNames names = {{"a \"b\"", "RIM"}, {{"rim", {0}}}, {"rim"}};
  EXPECT_EQ(texts_of(changed_names(mesh, "a.msh", names)),
            Texts{"a.msh: 2 names are changed to be words of their own, the first: a \"b\" is a "
                  "'b'"});
  EXPECT_EQ(texts_of(changed_names(mesh, "a.inp", names)),
            Texts{"a.inp: 3 names are changed to be words of their own, the first: a \"b\" is "
                  "a__b_"});
  EXPECT_EQ(texts_of(changed_names(mesh, "a.bdf", names)).size(), 1U);
  EXPECT_TRUE(changed_names(mesh, "a.vtu", names).empty());
  EXPECT_TRUE(changed_names(mesh, "a.glb", names).empty());
}

TEST(ChangedNames, AreOfCharactersInFilesOfVtk) {
  const PolyMesh mesh = named_example(0);
  const MeshNames names = {{"a\xFF", "a\xEF\xBF\xBD"}, {{"\x01", {0}}}, {"rim"}};
  for (const char* file : {"a.vtu", "a.vtk"}) {
    EXPECT_EQ(texts_of(changed_names(mesh, file, names)),
              Texts{std::string(file) +
                    ": 2 names are changed to be words of their own, the first: a\xFF is "
                    "a\xEF\xBF\xBD_2"});
    EXPECT_EQ(what_is_lost(mesh, file, names).back(),
              "2 names as they are, the first: a\xFF is a\xEF\xBF\xBD_2");
  }
  const TestFolder folder;
  write_mesh(mesh, folder / "a.vtu", names);
  const MeshNames read = read_mesh(folder / "a.vtu").names;
  EXPECT_EQ(read.patches, (std::vector<std::string>{"a\xEF\xBF\xBD_2", "a\xEF\xBF\xBD"}));
  ASSERT_EQ(read.groups.size(), 1u);
  EXPECT_EQ(read.groups[0].name, "\xEF\xBF\xBD");
}

TEST(UnusedOptions, TellThatOnlyMshFilesHaveVersions) {
  EXPECT_EQ(texts_of(unused_options(testing::octahedron(), "a.vtu", {.msh = MshVersion::Text22})),
            Texts{"msh has no effect on a.vtu: it is of .msh files"});
  EXPECT_TRUE(unused_options(testing::octahedron(), "a.msh", {.msh = MshVersion::Text22}).empty());
}

TEST(MeditFile, HasRidgesWhereFacesMeetSharply) {
  const TestFolder folder;
  PolyMesh mesh = testing::octahedron();
  const auto contour = attach(mesh, keys::edge_contour, -1);
  mesh.property(contour, EdgeHandle(0)) = 0;
  write_mesh(mesh, folder / "a.mesh");
  const std::string text = read_text(folder / "a.mesh");
  EXPECT_NE(text.find("\nRidges\n1\n 1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nCorners\n2\n"), std::string::npos) << text;
}

TEST(GlbFile, RefusesGreatNumbersOfPatches) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(1, 0);
  attach(mesh, keys::face_patch, std::numeric_limits<int>::max());
  EXPECT_EQ(
      error_of([&] { write_mesh(mesh, folder / "a.glb"); }),
      "invalid input: a face is of patch 2147483647, but .glb files hold them up to 10000000");
}

TEST(GlbFile, RefusesWhatSinglePrecisionCannotHold) {
  const TestFolder folder;
  PolyMesh mesh = testing::octahedron();
  mesh.set_point(VertexHandle(0), {1e300, 0, 0});
  EXPECT_EQ(error_of([&] { write_mesh(mesh, folder / "a.glb"); }),
            "geometry: the position of vertex 0 is (1e+300, 0, 0), too large for .glb");
}

}  // namespace
}  // namespace surfmesh
