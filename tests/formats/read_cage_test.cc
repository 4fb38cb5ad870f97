// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/read_cage.hh"

#include <gtest/gtest.h>

#include "support/errors.hh"
#include "support/folders.hh"

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
  EXPECT_EQ(error_of([] { read_cage("cage.stl"); }),
            "invalid input: cage.stl: the ending of a cage is .obj or .off");
  EXPECT_EQ(error_of([] { read_cage("cage"); }),
            "invalid input: cage: the ending of a cage is .obj or .off");
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
