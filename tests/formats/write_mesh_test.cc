// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/write_mesh.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "formats/example_meshes.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/meshes.hh"
#include "support/notices.hh"
#include "surfmesh/formats/read_cage.hh"

namespace surfmesh {
namespace {

std::vector<int> corners(const PolyMesh& mesh, int face) {
  std::vector<int> vertices;
  for (const VertexHandle vh : mesh.fv_range(FaceHandle(face))) vertices.push_back(vh.idx());
  return vertices;
}

void expect_equal_points(const PolyMesh& mesh, const Cage& cage) {
  ASSERT_EQ(cage.points.size(), mesh.n_vertices());
  for (const VertexHandle vh : mesh.vertices()) {
    EXPECT_EQ(cage.points[static_cast<std::size_t>(vh.idx())], to_eigen(mesh.point(vh)));
  }
}

/// A face turned so that its least vertex comes first: which one leads means nothing.
std::vector<int> turned(std::vector<int> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

void expect_equal_faces(const PolyMesh& mesh, const Cage& cage) {
  ASSERT_EQ(cage.faces.size(), mesh.n_faces());
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    EXPECT_EQ(turned(cage.faces[f]), turned(corners(mesh, static_cast<int>(f))));
  }
}

PolyMesh one_triangle(double x) {
  PolyMesh mesh;
  const auto a = mesh.add_vertex({x, -0.0, 1e300});
  const auto b = mesh.add_vertex({1, 0.1, 5e-324});
  const auto c = mesh.add_vertex({-123456789.125, 1.0 / 3, std::numeric_limits<double>::max()});
  mesh.add_face(std::vector{a, b, c});
  return mesh;
}

TEST(WriteObj, ReadsBackExactly) {
  const TestFolder folder;
  const PolyMesh mesh = wavy_grid(9, 2);
  write_mesh(mesh, folder / "a.obj");
  const Cage cage = read_cage(folder / "a.obj");
  expect_equal_points(mesh, cage);
  expect_equal_faces(mesh, cage);
  EXPECT_TRUE(cage.groups.empty());
  EXPECT_TRUE(texts_of(cage.notices).empty());
}

TEST(WriteObj, IsPlainText) {
  const TestFolder folder;
  PolyMesh mesh = one_triangle(0.5);
  attach(mesh, keys::face_patch, 0);
  write_mesh(mesh, folder / "a.obj", {{"wave"}, {}});
  EXPECT_EQ(read_text(folder / "a.obj"),
            "# surfmesh\nv 0.5 -0 1e+300\nv 1 0.1 5e-324\n"
            "v -123456789.125 0.3333333333333333 1.7976931348623157e+308\ng wave\nf 1 2 3\n");
}

TEST(WriteObj, NamesAllGroupsFirstWhereFacesAreNotInTheirOrder) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(1, 0);
  const auto patch = attach(mesh, keys::face_patch, 2);
  mesh.property(patch, FaceHandle(1)) = 0;
  write_mesh(mesh, folder / "a.obj", {{"first", "", "third one"}, {}});
  const std::string text = read_text(folder / "a.obj");
  EXPECT_EQ(text.substr(text.find("\ng")),
            "\ng first\ng patch1\ng third_one\ng third_one\nf 1 2 4\ng first\nf 1 4 3\n");
}

TEST(WriteObj, MakesWordsOfAllNames) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(1, 0);
  attach(mesh, keys::face_patch, 0);
  for (const auto& [name, word] : std::vector<std::pair<std::string, std::string>>{
           {"a\tb\n", "a_b_"}, {"#1", "_1"}, {"c\\", "c_"}, {"Flügel", "Flügel"}, {" ", "_"}}) {
    write_mesh(mesh, folder / "a.obj", {{name}, {}});
    const Cage cage = read_cage(folder / "a.obj");
    ASSERT_EQ(cage.groups.size(), 1u) << name;
    EXPECT_EQ(cage.groups[0].name, word);
    EXPECT_EQ(cage.groups[0].faces.size(), 2u);
  }
}

TEST(WriteObj, GroupsFacesWithoutPatch) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(1, 0);
  attach(mesh, keys::face_patch, -1);
  write_mesh(mesh, folder / "a.obj", {{"x"}, {}});
  EXPECT_EQ(read_cage(folder / "a.obj").groups.at(0).name, "default");
}

TEST(WriteOff, ReadsBackExactly) {
  const TestFolder folder;
  const PolyMesh mesh = wavy_grid(9, 2);
  write_mesh(mesh, folder / "a.OFF");
  const Cage cage = read_cage(folder / "a.OFF");
  expect_equal_points(mesh, cage);
  expect_equal_faces(mesh, cage);
  EXPECT_TRUE(texts_of(cage.notices).empty());
}

TEST(WriteOff, IsPlainText) {
  const TestFolder folder;
  write_mesh(one_triangle(0.5), folder / "a.off");
  EXPECT_EQ(read_text(folder / "a.off"),
            "OFF\n3 1 0\n0.5 -0 1e+300\n1 0.1 5e-324\n"
            "-123456789.125 0.3333333333333333 1.7976931348623157e+308\n3 0 1 2\n");
}

TEST(WriteMesh, WritesTheSameBytesTwice) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(5, 2);
  attach_result_properties(mesh);
  for (const std::string ending : {".obj", ".off", ".ply", ".stl", ".om"}) {
    write_mesh(mesh, folder / ("a" + ending), {{"p"}, {}});
    write_mesh(mesh, folder / ("b" + ending), {{"p"}, {}});
    EXPECT_EQ(read_text(folder / ("a" + ending)), read_text(folder / ("b" + ending)));
  }
}

TEST(WriteMesh, RefusesUnknownEndings) {
  EXPECT_EQ(error_of([] { write_mesh(PolyMesh(), "a.vtp"); }),
            "invalid input: a.vtp: the ending of a mesh is .obj, .off, .ply, .stl, .vtu, .vtk, "
            ".msh, .mesh, .meshb, .glb, .inp, .bdf or .om");
}

TEST(WriteMesh, RefusesPositionsThatAreNotFiniteAndLeavesTheOldFile) {
  const TestFolder folder;
  for (const std::string name : {"a.obj", "a.off", "a.ply", "a.stl"}) {
    write_text(folder / name, "old");
    EXPECT_EQ(error_of([&] { write_mesh(one_triangle(kUnset), folder / name); }),
              "geometry: the position of vertex 0 is (nan, -0, 1e+300)");
    EXPECT_EQ(read_text(folder / name), "old");
  }
  EXPECT_EQ(folder.count(), 4);
}

TEST(WhatIsLost, TellsWhatAFormatCannotHold) {
  using Lost = std::vector<std::string>;
  PolyMesh mesh = wavy_grid(3, 2);
  const std::string digits =
      "the digits of positions beyond single precision: vertices move by up to 2.36e-08";
  const std::string quads = "5 faces of more than three corners, which are split";
  EXPECT_EQ(what_is_lost(mesh, "a.obj"), Lost());
  EXPECT_EQ(what_is_lost(mesh, "a.stl"), (Lost{digits, quads}));
  attach_result_properties(mesh);
  const Lost corners = {"the parameters (u,v) of the corners", "the metric of the corners",
                        "the contours of the edges"};
  const Lost patch = {"the patches of the faces", corners[0], corners[1], corners[2]};
  EXPECT_EQ(what_is_lost(mesh, "a.OBJ", {{"x"}, {}}), corners);
  EXPECT_EQ(what_is_lost(mesh, "a.ply", {{"x y"}, {}}), corners);
  EXPECT_EQ(what_is_lost(mesh, "a.off", {{"x"}, {}}), patch);
  EXPECT_EQ(what_is_lost(mesh, "a.om", {{"x"}, {}}), Lost());
  EXPECT_EQ(what_is_lost(mesh, "a.obj", {{"x y"}, {}}).size(), 4u);
  EXPECT_EQ(what_is_lost(mesh, "a.off", {{"x"}, {{"all", {0}}}}).at(1),
            "the groups of the patches");
}

TEST(RoundingOf, IsHowFarVerticesMoveInSinglePrecision) {
  PolyMesh mesh = testing::mesh_of({{4e5, 0, 0}, {4e5 + 1.01, 0, 0}, {4e5, 2, 0}}, {{0, 1, 2}});
  const Rounding rounding = rounding_of(mesh, "a.stl");
  const double move = std::abs(double(float(4e5 + 1.01)) - (4e5 + 1.01));
  EXPECT_GT(move, 0);
  EXPECT_EQ(rounding.greatest_move, move);
  EXPECT_NEAR(rounding.share, move / 1.01, 1e-9);
  EXPECT_EQ(rounding_of(mesh, "a.obj").greatest_move, 0);
}

TEST(WriteMesh, TellsThatADeviceIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const TestFolder folder;
  // The smaller one fits into the buffer of the file, the larger one does not.
  for (const int side : {40, 200}) {
    PolyMesh mesh = wavy_grid(side, 2);
    attach_result_properties(mesh);
    for (const std::string ending : {".obj", ".off", ".ply", ".stl", ".om"}) {
      const std::string path = (folder / (std::to_string(side) + ending)).string();
      std::filesystem::create_symlink("/dev/full", path);
      EXPECT_EQ(error_of([&] { write_mesh(mesh, path); }),
                "io: cannot write " + path + ": No space left on device");
    }
  }
}

}  // namespace
}  // namespace surfmesh
