// SPDX-License-Identifier: BSD-3-Clause
//
// Whether other programs read what is written. They are run where they are installed: Debian's
// python3-meshio, python3-vtk9 and gmsh.
#include <gtest/gtest.h>

#include <cstdlib>

#include "formats/example_meshes.hh"
#include "support/folders.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

constexpr const char* kPython = "/usr/bin/python3";

bool runs(const std::string& line) { return std::system((line + " >/dev/null 2>&1").c_str()) == 0; }

/// The mesh as text, by a program that prints numbers of points and faces and what it knows of
/// patches.
class ForeignReader : public ::testing::Test {
 protected:
  std::string printed(const std::string& program) {
    write_text(folder_ / "read.py", program);
    const std::string line =
        std::string("cd '") + folder_.path().string() + "' && " + kPython + " read.py >out 2>err";
    EXPECT_EQ(std::system(line.c_str()), 0) << read_text(folder_ / "err");
    return read_text(folder_ / "out");
  }

  /// A grid of so many cells with two patches in a group.
  void write_example(const std::string& name, int quad_every) const {
    PolyMesh mesh = wavy_grid(4, quad_every);
    const auto patch = attach(mesh, keys::face_patch, 0);
    for (const FaceHandle fh : mesh.faces()) mesh.property(patch, fh) = fh.idx() < 10 ? 0 : 1;
    write_mesh(mesh, folder_ / name,
               {{"the first", std::string(1000, 'x') + "\xC3\xBC"}, {{"all of it", {0, 1}}}});
  }

  TestFolder folder_;
};

constexpr const char* kMeshio = R"(
import meshio
mesh = meshio.read("a.ply")
print(len(mesh.points), sum(len(c.data) for c in mesh.cells), mesh.points[7][1] == 1 / 7)
for values in mesh.cell_data.get("patch", []): print(sum(values))
)";

TEST_F(ForeignReader, MeshioReadsPlyWithPatches) {
  if (!runs(std::string(kPython) + " -c 'import meshio'")) GTEST_SKIP() << "no meshio here";
  write_example("a.ply", 0);
  EXPECT_EQ(printed(kMeshio), "25 32 True\n22\n");
  write_example("a.ply", 2);
  EXPECT_EQ(printed(kMeshio), "25 24 True\n");
}

TEST_F(ForeignReader, MeshioReadsObj) {
  if (!runs(std::string(kPython) + " -c 'import meshio'")) GTEST_SKIP() << "no meshio here";
  write_example("a.obj", 0);
  EXPECT_EQ(printed("import meshio\nmesh = meshio.read('a.obj')\n"
                    "print(len(mesh.points), sum(len(c.data) for c in mesh.cells))\n"),
            "25 32\n");
}

constexpr const char* kVtk = R"(
import sys
from vtkmodules.vtkIOPLY import vtkPLYReader
reader = vtkPLYReader()
reader.SetFileName("a.ply")
reader.Update()
print(reader.GetOutput().GetNumberOfPoints(), reader.GetOutput().GetNumberOfPolys())
)";

TEST_F(ForeignReader, VtkReadsPly) {
  if (!runs(std::string(kPython) + " -c 'import vtkmodules.vtkIOPLY'")) {
    GTEST_SKIP() << "no VTK here";
  }
  write_example("a.ply", 0);
  EXPECT_EQ(printed(kVtk), "25 32\n");
  write_example("a.ply", 2);
  EXPECT_EQ(printed(kVtk), "25 24\n");
}

/// Gmsh takes the first three corners of all faces: meshes are of triangles.
TEST_F(ForeignReader, GmshReadsPly) {
  if (!runs("gmsh --version")) GTEST_SKIP() << "no gmsh here";
  write_example("a.ply", 0);
  ASSERT_TRUE(runs("cd '" + folder_.path().string() + "' && gmsh -0 a.ply -o a.msh -format msh22"));
  const std::string text = read_text(folder_ / "a.msh");
  EXPECT_NE(text.find("$Nodes\n25\n"), std::string::npos) << text.substr(0, 200);
  EXPECT_NE(text.find("$Elements\n32\n"), std::string::npos);
  EXPECT_NE(text.find(" 0.1428571428571428 "), std::string::npos);
}

}  // namespace
}  // namespace surfmesh
