// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/read_cage.hh"

#include <gtest/gtest.h>

#include <map>

#include "support/errors.hh"
#include "support/folders.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

const std::string kTriangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string kTriangleOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(ReadCage, ChoosesByEndingInAnyCase) {
  const TestFolder folder;
  write_text(folder / "a.obj", kTriangleObj);
  write_text(folder / "b.OBJ", kTriangleObj);
  write_text(folder / "c.off", kTriangleOff);
  write_text(folder / "d.Off", kTriangleOff);
  for (const char* name : {"a.obj", "b.OBJ", "c.off", "d.Off"}) {
    EXPECT_EQ(read_cage(folder / name).faces.size(), 1u) << name;
  }
}

TEST(ReadCage, RefusesUnknownEndings) {
  EXPECT_EQ(error_of([] { read_cage("cage.vtu"); }),
            "invalid input: cage.vtu: the ending of a cage is .obj, .off, .ply, .stl or .om");
  EXPECT_EQ(error_of([] { read_cage("cage"); }),
            "invalid input: cage: the ending of a cage is .obj, .off, .ply, .stl or .om");
}

/// Two triangles, on the patches "left" and "right" of the groups "both" and "left".
PolyMesh two_triangles(MeshNames& names) {
  PolyMesh mesh;
  std::vector<VertexHandle> v;
  for (const auto& point : {OpenMesh::Vec3d(0, 0, 0), OpenMesh::Vec3d(1, 0, 0),
                            OpenMesh::Vec3d(1, 1, 0), OpenMesh::Vec3d(0, 1, 0.5)}) {
    v.push_back(mesh.add_vertex(point));
  }
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[0], v[2], v[3]);
  const auto patch_of = attach(mesh, keys::face_patch, 0);
  mesh.property(patch_of, FaceHandle(1)) = 1;
  names.patches = {"left", "right"};
  names.groups = {{"both", {0, 1}}, {"left", {0}}};
  return mesh;
}

TEST(ReadCage, TakesMeshesWithTheirPatchesAndGroups) {
  const TestFolder folder;
  MeshNames names;
  const PolyMesh mesh = two_triangles(names);
  for (const char* ending : {".ply", ".om", ".stl"}) {
    const auto path = folder / (std::string("a") + ending);
    write_mesh(mesh, path, names);
    const Cage cage = read_cage(path);
    EXPECT_EQ(cage.points.size(), 4u) << ending;  // also of triangles by themselves
    EXPECT_EQ(cage.faces, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}})) << ending;
    EXPECT_TRUE(cage.texture.faces.empty());
    std::map<std::string, std::vector<int>> groups;
    for (const Cage::FaceGroup& group : cage.groups) groups[group.name] = group.faces;
    if (ending == std::string(".stl")) continue;
    EXPECT_EQ(groups, (std::map<std::string, std::vector<int>>{
                          {"left", {0}}, {"right", {1}}, {"both", {0, 1}}}))
        << ending;
  }
}

TEST(ReadCage, RefusesFilesThatDoNotExist) {
  EXPECT_EQ(error_of([] { read_cage("no such.obj"); }),
            "io: cannot read no such.obj: it does not exist");
}

TEST(ReadCage, RefusesFolders) {
  const TestFolder folder;
  std::filesystem::create_directory(folder / "a.obj");
  const std::string path = (folder / "a.obj").string();
  EXPECT_EQ(error_of([&] { read_cage(path); }), "io: cannot read " + path + ": it is a folder");
}

TEST(ReadCage, NamesThePathInMessages) {
  const TestFolder folder;
  write_text(folder / "bad.obj", "v 0 0 0\nv 1 x 0\n");
  const std::string path = (folder / "bad.obj").string();
  EXPECT_EQ(error_of([&] { read_cage(path); }),
            "invalid input: " + path + ":2: a coordinate is 'x', which is not a number");
}

}  // namespace
}  // namespace surfmesh
