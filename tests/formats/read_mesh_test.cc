// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/read_mesh.hh"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "formats/example_meshes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/notices.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

using Names = std::vector<std::string>;

bool is_same_bits(const Vec3& a, const Vec3& b) {
  for (int k = 0; k < 3; ++k) {
    if (std::bit_cast<std::uint64_t>(a[k]) != std::bit_cast<std::uint64_t>(b[k])) return false;
  }
  return true;
}

/// Expect the same positions, bit by bit, the same faces in the same order, the same patches.
void expect_same(const PolyMesh& mesh, const PolyMesh& read, bool has_patches) {
  const MeshArrays a = mesh_arrays(mesh), b = mesh_arrays(read);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t v = 0; v < a.points.size(); ++v) {
    ASSERT_TRUE(is_same_bits(a.points[v], b.points[v])) << v;
  }
  EXPECT_TRUE(a.faces == b.faces);
  EXPECT_EQ(b.patches, has_patches ? a.patches : std::vector<int>());
  testing::expect_valid(read);
}

PolyMesh extreme_example() {
  PolyMesh mesh = wavy_grid(7, 2);
  mesh.set_point(VertexHandle(3), {-0.0, 5e-324, 1.7976931348623157e308});
  attach_result_properties(mesh);
  return mesh;
}

class MeshRoundTrip : public ::testing::TestWithParam<std::string> {};

TEST_P(MeshRoundTrip, GivesTheSameMeshBitForBit) {
  const TestFolder folder;
  const PolyMesh mesh = extreme_example();
  const auto path = folder / ("a" + GetParam());
  write_mesh(mesh, path, {{"one", "two", "three"}, {}});
  const MeshFile read = read_mesh(path);
  expect_same(mesh, read.mesh, GetParam() != ".off");
  EXPECT_TRUE(texts_of(read.notices).empty());
  const bool has_names = GetParam() != ".off";
  EXPECT_EQ(read.names.patches, has_names ? Names({"one", "two", "three"}) : Names());
}

TEST_P(MeshRoundTrip, GivesTheSameFileTwice) {
  const TestFolder folder;
  write_mesh(extreme_example(), folder / ("a" + GetParam()), {{"one"}, {}});
  const MeshFile read = read_mesh(folder / ("a" + GetParam()));
  write_mesh(read.mesh, folder / ("b" + GetParam()), read.names);
  EXPECT_EQ(read_text(folder / ("a" + GetParam())), read_text(folder / ("b" + GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshRoundTrip, ::testing::Values(".obj", ".off", ".PLY", ".om"),
                         [](const auto& test) { return test.param.substr(1); });

TEST(ReadMesh, KeepsPatchNumbersOfObjWhateverTheOrderOfTheFaces) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(2, 0);
  const auto patch = attach(mesh, keys::face_patch, 5);
  mesh.property(patch, FaceHandle(1)) = -1;
  mesh.property(patch, FaceHandle(2)) = 0;
  write_mesh(mesh, folder / "a.obj", {{"x", "x", "default", "", "patch3"}, {}});
  const MeshFile read = read_mesh(folder / "a.obj");
  expect_same(mesh, read.mesh, true);
  EXPECT_EQ(read.names.patches, Names({"x", "x_2", "default_2", "patch3", "patch3_2", "patch5"}));
}

MeshFile read_obj_text(const std::string& text) {
  const TestFolder folder;
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + text);
  return read_mesh(folder / "a.obj");
}

std::vector<int> patches_of(const MeshFile& file) { return mesh_arrays(file.mesh).patches; }

TEST(ReadMesh, TakesGroupsOfObjForPatches) {
  const MeshFile read = read_obj_text("f 1 2 3\ng b\nusemtl m\nf 1 3 4\n");
  EXPECT_EQ(patches_of(read), (std::vector<int>{-1, 0}));
  EXPECT_EQ(read.names.patches, Names{"b"});
}

TEST(ReadMesh, TakesMaterialsWhereThereAreNoGroups) {
  const MeshFile read = read_obj_text("o body\nusemtl m\nf 1 2 3\nusemtl n\nf 1 3 4\n");
  EXPECT_EQ(patches_of(read), (std::vector<int>{0, 1}));
  EXPECT_EQ(read.names.patches, (Names{"m", "n"}));
}

TEST(ReadMesh, TakesTheLastOfSeveralGroupsForThePatch) {
  const MeshFile read = read_obj_text("g a b\nf 1 2 3\ng b\nf 1 3 4\n");
  EXPECT_EQ(patches_of(read), (std::vector<int>{0, 1}));
  EXPECT_EQ(read.names.patches, (Names{"b", "b_2"}));
  const std::vector<Group> groups = {{"a", {0}}, {"b", {0, 1}}};
  EXPECT_EQ(read.names.groups, groups);
  EXPECT_TRUE(texts_of(read.notices).empty());
}

TEST(ReadMesh, HasNoPatchesWithoutGroups) {
  const MeshFile read = read_obj_text("f 1 2 3 4\n");
  EXPECT_FALSE(find(read.mesh, keys::face_patch).is_valid());
}

TEST(ReadMesh, SeparatesSheetsOfThreeFacesAtAnEdge) {
  const MeshFile read = read_obj_text("v 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
  testing::expect_valid(read.mesh);
  EXPECT_EQ(read.mesh.n_faces(), 3u);
  EXPECT_EQ(read.mesh.n_vertices(), 9u);
  ASSERT_EQ(texts_of(read.notices).size(), 1u);
  EXPECT_NE(texts_of(read.notices)[0].find("3 sides of faces are left open and 4 vertices"),
            std::string::npos)
      << texts_of(read.notices)[0];
}

TEST(ReadMesh, SeparatesFacesThatTouchInAVertex) {
  const MeshFile read = read_obj_text("v 2 2 0\nv 1 2 0\nf 1 2 3 4\nf 3 5 6\n");
  testing::expect_valid(read.mesh);
  EXPECT_EQ(read.mesh.n_vertices(), 7u);
}

TEST(ReadMesh, OpensEdgesOfFacesTurnedAgainstEachOther) {
  const MeshFile read = read_obj_text("f 1 2 3\nf 1 4 3\n");
  testing::expect_valid(read.mesh);
  EXPECT_EQ(read.mesh.n_edges(), 6u);
  EXPECT_EQ(texts_of(read.notices).size(), 1u);
}

TEST(ReadMesh, TakesAVertexOnceThatAFaceHasTwiceInARow) {
  const MeshFile read = read_obj_text("f 1 2 2 3\nf 1 3 4 1\n");
  testing::expect_valid(read.mesh);
  EXPECT_EQ(read.mesh.n_edges(), 5u);
  ASSERT_EQ(texts_of(read.notices).size(), 1u);
  EXPECT_TRUE(texts_of(read.notices)[0].ends_with("taken once (and 1 more)"))
      << texts_of(read.notices)[0];
}

TEST(ReadMesh, TellsBadFiles) {
  const TestFolder folder;
  const auto error = [&](const std::string& name, const std::string& text) {
    write_text(folder / name, text);
    std::string message = error_of([&] { read_mesh(folder / name); });
    const std::string path = (folder / name).string();
    const std::size_t at = message.find(path);
    return at == std::string::npos ? message : message.replace(at, path.size(), name);
  };
  EXPECT_EQ(error("a.obj", ""), "invalid input: a.obj: the file is empty");
  EXPECT_EQ(error("a.obj", "v 0 0 0\n"), "invalid input: a.obj: the file has no faces");
  EXPECT_EQ(error("a.obj", "v 0 0 nan\n"),
            "invalid input: a.obj:1: a coordinate is 'nan', which is not finite");
  EXPECT_EQ(error("a.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n"),
            "invalid input: a.off:4: vertex index 1 is not in 0 to 0");
  EXPECT_EQ(error("a.vtk", ""),
            "invalid input: a.vtk: .vtk files are only written; what is read is .obj, .off, .ply, "
            ".stl, .vtu, .msh, .mesh, .meshb or .om");
  EXPECT_EQ(error("a.vtp", ""),
            "invalid input: a.vtp: the ending of a mesh to read is .obj, .off, .ply, .stl, .vtu, "
            ".msh, .mesh, .meshb or .om");
  EXPECT_EQ(error_of([&] { read_mesh("none.ply"); }),
            "io: cannot read none.ply: it does not exist");
  std::filesystem::create_directory(folder / "b.stl");
  EXPECT_NE(error_of([&] { read_mesh(folder / "b.stl"); }).find("it is a folder"),
            std::string::npos);
}

}  // namespace
}  // namespace surfmesh
