// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/named_example.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/notices.hh"
#include "surfmesh/formats/ply_file.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

/// Two triangles a patch, patches in their order.
PolyMesh patched() {
  PolyMesh mesh = wavy_grid(2, 0);
  const auto patch = attach(mesh, keys::face_patch, 0);
  for (const FaceHandle fh : mesh.faces()) mesh.property(patch, fh) = fh.idx() / 2;
  return mesh;
}

const MeshNames kNames = {{"left", "right", "upper", "lower"},
                          {{"wing", {0, 1}}, {"all", {0, 1, 2, 3}}, {"lower", {2}}}};

class GroupsRoundTrip : public ::testing::TestWithParam<std::string> {};

TEST_P(GroupsRoundTrip, GivesTheSameNamesAndGroups) {
  const TestFolder folder;
  const auto path = folder / ("a" + GetParam());
  const PolyMesh mesh = patched();
  write_mesh(mesh, path, kNames);
  const MeshFile read = read_mesh(path);
  EXPECT_EQ(read.names, kNames);
  EXPECT_EQ(mesh_arrays(read.mesh).patches, mesh_arrays(mesh).patches);
  EXPECT_TRUE(texts_of(read.notices).empty());
  EXPECT_TRUE(what_is_lost(mesh, path, kNames).empty());
  write_mesh(read.mesh, folder / ("b" + GetParam()), read.names);
  EXPECT_EQ(read_text(path), read_text(folder / ("b" + GetParam())));
}

TEST_P(GroupsRoundTrip, KeepsPatchesOfFacesOfDifferentSizes) {
  const TestFolder folder;
  const auto path = folder / ("a" + GetParam());
  PolyMesh mesh = wavy_grid(4, 2);
  const auto patch = attach(mesh, keys::face_patch, 0);
  for (const FaceHandle fh : mesh.faces()) mesh.property(patch, fh) = fh.idx() % 3;
  const MeshNames names = {{"a", "b", "c"}, {{"most", {0, 2}}}};
  write_mesh(mesh, path, names);
  const MeshFile read = read_mesh(path);
  EXPECT_EQ(read.names, names);
  EXPECT_EQ(mesh_arrays(read.mesh).patches, mesh_arrays(mesh).patches);
}

INSTANTIATE_TEST_SUITE_P(Formats, GroupsRoundTrip, ::testing::Values(".obj", ".ply", ".om"),
                         [](const auto& test) { return test.param.substr(1); });

TEST(GroupsInObj, StandBeforeThePatch) {
  const TestFolder folder;
  write_mesh(patched(), folder / "a.obj", kNames);
  const std::string text = read_text(folder / "a.obj");
  for (const char* line : {"\ng wing all left\n", "\ng wing all right\n", "\ng all lower upper\n",
                           "\ng all lower\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

TEST(GroupsInObj, AreGroupsOfACage) {
  const TestFolder folder;
  write_mesh(patched(), folder / "a.obj", kNames);
  const Cage cage = read_cage(folder / "a.obj");
  ASSERT_EQ(cage.groups.size(), 6u);
  EXPECT_EQ(cage.groups[0].name, "wing");
  EXPECT_EQ(cage.groups[0].faces, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(cage.groups[4].name, "lower");
  EXPECT_EQ(cage.groups[4].faces, (std::vector<int>{4, 5, 6, 7}));
}

TEST(GroupsInObj, AreWordsThatDiffer) {
  const TestFolder folder;
  const MeshNames names = {{"p", "q"}, {{"the wing", {0}}, {"the_wing", {1}}, {"", {1}}}};
  PolyMesh mesh = wavy_grid(1, 0);
  attach(mesh, keys::face_patch, 1);
  write_mesh(mesh, folder / "a.obj", names);
  EXPECT_NE(read_text(folder / "a.obj").find("\ng the_wing p\ng the_wing_2 group q\n"),
            std::string::npos);
  EXPECT_EQ(what_is_lost(mesh, "a.obj", names).at(0),
            "3 names of patches and groups, which are changed to be words of their own");
}

TEST(GroupsInObj, RefusePatchNumbersThatWouldFillTheDisk) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(1, 0);
  attach(mesh, keys::face_patch, 2000000000);
  EXPECT_EQ(error_of([&] { write_mesh(mesh, folder / "a.obj"); }),
            "invalid input: a face is of patch 2000000000, but OBJ files hold patches up to "
            "10000000");
}

MeshArrays read_obj(const std::string& faces) {
  const TestFolder folder;
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 1 0\n" + faces);
  return read_mesh_arrays(folder / "a.obj").mesh;
}

TEST(GroupsInObj, TakeObjectsAndMaterials) {
  const MeshArrays mesh = read_obj("o my body\ng a\nusemtl steel\nf 1 2 3\ng b\nf 1 3 4\n");
  EXPECT_EQ(mesh.names.patches, (std::vector<std::string>{"a", "b"}));
  const std::vector<Group> groups = {{"my body", {0, 1}}, {"steel", {0, 1}, true}};
  EXPECT_EQ(mesh.names.groups, groups);
}

TEST(GroupsInObj, ArePatchesWhereOnlyObjectsAreNamed) {
  const MeshArrays mesh = read_obj("f 1 2 3\no lid\nf 1 3 4\n");
  EXPECT_EQ(mesh.names, (MeshNames{{"lid"}, {}}));
  EXPECT_EQ(mesh.patches, (std::vector<int>{-1, 0}));
}

/// A solver can apply a condition to either name.
TEST(GroupsInObj, SplitAPatchOfTwoMaterials) {
  const MeshArrays mesh = read_obj("g a\nusemtl m\nf 1 2 3\nusemtl n\nf 1 3 4\n");
  EXPECT_EQ(mesh.names.patches, (std::vector<std::string>{"a", "a_2"}));
  const std::vector<Group> groups = {{"m", {0}, true}, {"a", {0, 1}}, {"n", {1}, true}};
  EXPECT_EQ(mesh.names.groups, groups);
  EXPECT_EQ(mesh.patches, (std::vector<int>{0, 1}));
}

TEST(GroupsInPly, AreKeptWhateverTheirNames) {
  const TestFolder folder;
  std::string umlauts = "x";
  for (int i = 0; i < 300; ++i) umlauts += "\xC3\xBC";
  const MeshNames names = {{"", " a b ", umlauts, std::string(100000, 'y')},
                           {{"the wing", {1, 2}}, {umlauts, {0}}}};
  PolyMesh mesh = wavy_grid(2, 0);
  attach(mesh, keys::face_patch, 3);
  write_mesh(mesh, folder / "a.ply", names);
  EXPECT_EQ(read_mesh(folder / "a.ply").names, names);
  EXPECT_TRUE(what_is_lost(mesh, "a.ply", names).empty());
}

class GroupsOfGrids : public ::testing::TestWithParam<std::string> {};

TEST_P(GroupsOfGrids, AreReadBackWithTheNamesOfPatches) {
  const TestFolder folder;
  const std::filesystem::path path = folder / ("a" + GetParam());
  MeshNames names = example_names();
  names.patches = {"left wing \xC3\xBC", ""};
  const PolyMesh mesh = named_example(0);
  write_mesh(mesh, path, names);
  const MeshFile file = read_mesh(path);
  ASSERT_GE(file.names.patches.size(), 1u);
  EXPECT_EQ(file.names.patches[0], names.patches[0]);
  for (std::size_t p = 1; p < file.names.patches.size(); ++p) EXPECT_EQ(file.names.patches[p], "");
  EXPECT_EQ(file.names.groups, names.groups);
  const auto patch_of = require(file.mesh, keys::face_patch);
  const auto& patches = file.mesh.property(patch_of).data_vector();
  const auto& given = mesh.property(require(mesh, keys::face_patch)).data_vector();
  EXPECT_EQ(std::count(patches.begin(), patches.end(), 1),
            std::count(given.begin(), given.end(), 1));
  if (GetParam() != ".vtu") {
    EXPECT_EQ(file.names.contours, names.contours);
  }
}

/// A patch without faces keeps its number; faces of no patch stay so, but for .msh, where all are
/// in a surface.
TEST_P(GroupsOfGrids, KeepTheNumbersOfPatches) {
  const TestFolder folder;
  const std::filesystem::path path = folder / ("a" + GetParam());
  PolyMesh mesh = wavy_grid(2, 0);
  const auto patch_of = attach(mesh, keys::face_patch, 0);
  auto& given = mesh.property(patch_of).data_vector();
  given = {0, 2, 2, 3, -1, -1, 3, 0};
  write_mesh(mesh, path);
  const MeshFile file = read_mesh(path);
  auto patches = file.mesh.property(require(file.mesh, keys::face_patch)).data_vector();
  std::vector<int> expected = given;
  if (GetParam() == ".msh") std::replace(expected.begin(), expected.end(), -1, 4);
  std::sort(patches.begin(), patches.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(patches, expected);
}

TEST(GroupsInVtu, HaveNoGreatNumbers) {
  const TestFolder folder;
  const std::filesystem::path path = folder / "a.vtu";
  PolyMesh mesh = wavy_grid(1, 0);
  attach(mesh, keys::face_patch, 2000000000);
  write_mesh(mesh, path);
  EXPECT_EQ(error_of([&] { read_mesh(path); }),
            "invalid input: " + path.string() +
                ": patch 2000000000 is not a number from 0 to 10000000, or -1 for none");
}

INSTANTIATE_TEST_SUITE_P(Formats, GroupsOfGrids, ::testing::Values(".vtu", ".msh", ".mesh"),
                         [](const auto& format) { return format.param.substr(1); });

TEST(GroupsInPly, StandInShortLines) {
  const TestFolder folder;
  MeshNames names = {{std::string(1000, 'y')}, {{"many", {}}}};
  for (int p = 0; p < 1000; ++p) names.groups[0].patches.push_back(p);
  PolyMesh mesh = wavy_grid(1, 0);
  attach(mesh, keys::face_patch, 0);
  write_mesh(mesh, folder / "a.ply", names);
  const std::string text = read_text(folder / "a.ply");
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos;
       begin = end + 1) {
    EXPECT_LT(end - begin, 255u);
  }
}

TEST(GroupsInPly, LoseControlCharactersOfNames) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(1, 0);
  attach(mesh, keys::face_patch, 0);
  const MeshNames names = {{"a\nelement face 7"}, {{std::string("b\0c", 3), {0}}}};
  write_mesh(mesh, folder / "a.ply", names);
  const MeshNames read = read_mesh(folder / "a.ply").names;
  EXPECT_EQ(read.patches.at(0), "a element face 7");
  EXPECT_EQ(read.groups.at(0).name, "b c");
  EXPECT_EQ(what_is_lost(mesh, "a.ply", names).at(0),
            "the control characters in 2 names of patches and groups");
}

TEST(GroupsInPly, AreNotBelievedWhereTheyDoNotFit) {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string rest =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* comment :
       {"comment faces 2 0\n", "comment faces 0 0\n", "comment faces 1\n",
        "comment faces of cats\n", "comment faces 1 -2\n", "comment faces 4000000000 0\n",
        "comment group 4000000000 x\n", "comment patches 0 -1\n"}) {
    const MeshArraysFile file = parse_ply(head + comment + rest, "a.ply");
    EXPECT_TRUE(file.mesh.patches.empty()) << comment;
    EXPECT_EQ(file.mesh.names, MeshNames()) << comment;
  }
  EXPECT_EQ(parse_ply(head + "comment faces 1 4\n" + rest, "a.ply").mesh.patches,
            std::vector<int>{4});
}

}  // namespace
}  // namespace surfmesh
