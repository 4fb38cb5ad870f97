// SPDX-License-Identifier: BSD-3-Clause
//
// Whether what other programs write is read. They are run where they are installed: Debian's
// python3-meshio, python3-vtk9 and gmsh, which `tools/setup.sh --readers` installs.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "formats/foreign_programs.hh"
#include "support/folders.hh"
#include "surfmesh/formats/grid_file.hh"

namespace surfmesh {
namespace {

/// A folder where other programs write files.
class ForeignGrid : public ::testing::Test {
 protected:
  void run_python(const std::string& program) {
    write_text(folder_ / "write.py", program);
    const std::string line =
        std::string("cd '") + folder_.path().string() + "' && " + kPython + " write.py >out 2>err";
    ASSERT_EQ(std::system(line.c_str()), 0) << read_text(folder_ / "err");
  }

  TestFolder folder_;
};

/// meshio writes eleven digits where it writes .vtu files as text.
double tolerance_of(const std::string& name) { return name == "a.vtu" ? 1e-11 : 0; }

/// The grid that the scripts below write: a triangle and a quad with a value at each point.
void expect_example(const GridFile& grid, const std::string& name) {
  ASSERT_EQ(grid.points.size(), 5u) << name;
  EXPECT_EQ(grid.points[1], Vec3(1, 0, 0)) << name;
  EXPECT_LE((grid.points[4] - Vec3(0.1, 2, 1.0 / 3)).norm(), tolerance_of(name)) << name;
  ASSERT_EQ(grid.faces.size(), 2u) << name;
  EXPECT_EQ(std::vector<int>(grid.faces[0].begin(), grid.faces[0].end()),
            (std::vector<int>{3, 2, 4}))
      << name;
  EXPECT_EQ(std::vector<int>(grid.faces[1].begin(), grid.faces[1].end()),
            (std::vector<int>{0, 1, 2, 3}))
      << name;
}

void expect_values(const GridFile& grid, const std::string& name) {
  ASSERT_EQ(grid.at_points.size(), 2u) << name;
  EXPECT_EQ(grid.at_points[0].name, "h") << name;
  EXPECT_EQ(grid.at_points[0].components, 1) << name;
  const std::vector<double>& h = grid.at_points[0].numbers;
  ASSERT_EQ(h.size(), 5u) << name;
  EXPECT_EQ(h[3], 0.4) << name;
  EXPECT_NEAR(h[4], 1.0 / 7, tolerance_of(name)) << name;
  EXPECT_EQ(grid.at_points[1].components, 9) << name;
  EXPECT_EQ(grid.at_points[1].numbers[9 * 2 + 5], 2.0 * 5) << name;
}

constexpr const char* kWriteByMeshio = R"(
import meshio, numpy as np
points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.1, 2, 1 / 3]])
cells = [("triangle", np.array([[3, 2, 4]])), ("quad", np.array([[0, 1, 2, 3]]))]
h = np.array([0.1, 0.2, 0.3, 0.4, 1 / 7])
t = np.array([[float(i * j) for j in range(9)] for i in range(5)])
def mesh(values, cell_data):
    return meshio.Mesh(points, cells, point_data=values, cell_data=cell_data)
refs = [np.array([7]), np.array([3])]
tags = {"gmsh:physical": refs, "gmsh:geometrical": refs}
for name, format, binary in [("a22", "gmsh22", False), ("b22", "gmsh22", True),
                             ("a41", "gmsh", False), ("b41", "gmsh", True)]:
    values = {"h": h, "t": t}
    # Version 4.1 has entities at nodes.
    if "41" in name: values["gmsh:dim_tags"] = np.array([[2, 7]] * 5)
    m = mesh(values, tags)
    meshio.write(name + ".msh", m, file_format=format, binary=binary)
for name, binary, compression in [("a", False, None), ("b", True, None), ("z", True, "zlib")]:
    meshio.write(name + ".vtu", mesh({"h": h, "t": t}, {"patch": refs}), binary=binary,
                 compression=compression)
meshio.write("a.mesh", mesh({}, {"medit:ref": refs}))
)";

TEST_F(ForeignGrid, IsReadAsMeshioWritesIt) {
  if (!has_module("meshio")) GTEST_SKIP() << "no meshio here";
  run_python(kWriteByMeshio);
  for (const std::string name :
       {"a22.msh", "b22.msh", "a41.msh", "b41.msh", "a.vtu", "b.vtu", "z.vtu", "a.mesh"}) {
    const GridFile grid = read_grid(folder_ / name);
    expect_example(grid, name);
    if (!name.ends_with("mesh")) expect_values(grid, name);
  }
  EXPECT_EQ(read_grid(folder_ / "a.mesh").patches, (std::vector<int>{1, 0}));
  EXPECT_EQ(read_grid(folder_ / "a22.msh").patches, (std::vector<int>{1, 0}));
  EXPECT_EQ(read_grid(folder_ / "b22.msh").patches, (std::vector<int>{1, 0}));
  EXPECT_EQ(read_grid(folder_ / "z.vtu").patches, (std::vector<int>{7, 3}));
}

constexpr const char* kWriteByVtk = R"(
from itertools import product
from vtkmodules.vtkCommonCore import vtkPoints, vtkDoubleArray, vtkShortArray
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter as Writer
grid, points = vtkUnstructuredGrid(), vtkPoints()
points.SetDataTypeToDouble()
for p in [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.1, 2, 1 / 3)]: points.InsertNextPoint(p)
grid.SetPoints(points)
grid.InsertNextCell(5, 3, [3, 2, 4])
grid.InsertNextCell(8, 4, [0, 1, 3, 2])
h, t, patch = vtkDoubleArray(), vtkDoubleArray(), vtkShortArray()
h.SetName("h"); t.SetName("t"); patch.SetName("patch")
t.SetNumberOfComponents(9)
for value in [0.1, 0.2, 0.3, 0.4, 1 / 7]: h.InsertNextValue(value)
for i in range(5): t.InsertNextTuple([i * j for j in range(9)])
for value in [1, -1]: patch.InsertNextValue(value)
grid.GetPointData().AddArray(h); grid.GetPointData().AddArray(t)
grid.GetCellData().AddArray(patch)
modes = [(Writer.Ascii, 0), (Writer.Binary, 0), (Writer.Appended, 0), (Writer.Appended, 1)]
for n, ((mode, encoded), big, header, packed) in enumerate(product(modes, [0, 1], [0, 1], [0, 1])):
    writer = Writer()
    writer.SetFileName(f"a{n}.vtu")
    writer.SetInputData(grid)
    writer.SetDataMode(mode)
    writer.SetEncodeAppendedData(encoded)
    writer.SetByteOrder(Writer.BigEndian if big else Writer.LittleEndian)
    writer.SetHeaderType(Writer.UInt64 if header else Writer.UInt32)
    if packed: writer.SetCompressorTypeToZLib()
    else: writer.SetCompressorTypeToNone()
    assert writer.Write() == 1
)";

TEST_F(ForeignGrid, IsReadAsVtkWritesIt) {
  if (!has_module("vtkmodules.vtkIOXML")) GTEST_SKIP() << "no VTK here";
  run_python(kWriteByVtk);
  for (int n = 0; n < 32; ++n) {
    const std::string name = std::string("a").append(std::to_string(n)).append(".vtu");
    const GridFile grid = read_grid(folder_ / name);
    expect_example(grid, name);
    expect_values(grid, name);
    EXPECT_EQ(grid.patches, (std::vector<int>{1, -1})) << name;
  }
}

constexpr const char* kGeo = R"(
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 1};
Rectangle(2) = {1, 0, 0, 1, 1};
Coherence;
Physical Surface("left side", 7) = {1};
Physical Surface("both", 8) = {1, 2};
Physical Curve("rim", 9) = {1, 2};
Mesh.CharacteristicLengthMax = 0.7;
)";

class GmshGrid : public ForeignGrid {
 protected:
  bool writes(const std::string& name, const std::string& options) {
    write_text(folder_ / "a.geo", kGeo);
    return runs("cd '" + folder_.path().string() + "' && gmsh -2 a.geo -o " + name + " " + options);
  }
};

/// Faces of a patch, and their area in the plane.
std::pair<std::size_t, double> area_of(const GridFile& grid, int patch) {
  double area = 0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < grid.faces.size(); ++f) {
    if (grid.patches[f] != patch) continue;
    ++count;
    const auto point = [&](std::size_t k) {
      return grid.points[static_cast<std::size_t>(grid.faces[f][k])];
    };
    area += 0.5 * (point(1) - point(0)).cross(point(2) - point(0)).z();
  }
  return {count, area};
}

TEST_F(GmshGrid, HasPatchesGroupsAndContours) {
  if (!runs("gmsh --version")) GTEST_SKIP() << "no Gmsh here";
  for (const std::string options :
       {"-format msh22", "-format msh22 -bin", "-format msh41", "-format msh41 -bin"}) {
    ASSERT_TRUE(writes("a.msh", options)) << options;
    const GridFile grid = read_grid(folder_ / "a.msh");
    EXPECT_NEAR(area_of(grid, 0).second, 1, 1e-9) << options;
    EXPECT_NEAR(area_of(grid, 1).second, 1, 1e-9) << options;
    EXPECT_EQ(grid.faces.size(), area_of(grid, 0).first + area_of(grid, 1).first) << options;
    const std::vector<Group> groups = {{"left side", {0}}, {"both", {0, 1}}};
    EXPECT_EQ(grid.names.groups, groups) << options;
    EXPECT_EQ(grid.names.contours, std::vector<std::string>{"rim"}) << options;
    const auto sides = std::count(grid.contours.begin(), grid.contours.end(), 0);
    // Curve 1 is a side of one patch, curve 2 of both.
    EXPECT_EQ(sides, 15) << options;
  }
}

TEST_F(GmshGrid, GivesTheCornersOfElementsOfHigherOrder) {
  if (!runs("gmsh --version")) GTEST_SKIP() << "no Gmsh here";
  ASSERT_TRUE(writes("a.msh", "-format msh41"));
  ASSERT_TRUE(writes("b.msh", "-format msh41 -bin -order 2"));
  const MeshArraysFile one = mesh_of(read_grid(folder_ / "a.msh"));
  const MeshArraysFile two = mesh_of(read_grid(folder_ / "b.msh"));
  EXPECT_EQ(one.mesh.points.size(), two.mesh.points.size());
  EXPECT_EQ(one.mesh.faces.size(), two.mesh.faces.size());
  EXPECT_EQ(two.unread.front(),
            std::to_string(two.mesh.faces.size()) + " nodes on sides of elements of higher order");
}

TEST_F(GmshGrid, IsReadFromVtkAndMeditToo) {
  if (!runs("gmsh --version")) GTEST_SKIP() << "no Gmsh here";
  ASSERT_TRUE(writes("a.msh", "-format msh41"));
  ASSERT_TRUE(writes("a.mesh", "-format mesh"));
  const GridFile msh = read_grid(folder_ / "a.msh"), medit = read_grid(folder_ / "a.mesh");
  EXPECT_EQ(msh.points.size(), medit.points.size());
  EXPECT_EQ(msh.faces.size(), medit.faces.size());
  EXPECT_EQ(msh.patches, medit.patches);
}

/// A list-based view becomes one at nodes.
TEST_F(GmshGrid, HasTheViewsOfAPostProcessor) {
  if (!runs("gmsh --version")) GTEST_SKIP() << "no Gmsh here";
  write_text(folder_ / "v.geo", R"(
View "h" {
  ST(0,0,0, 1,0,0, 0,1,0){0.1,0.2,0.3};
  ST(1,0,0, 1,1,0, 0,1,0){0.2,0.4,0.3};
};
Save View[0] "v.msh";
)");
  ASSERT_TRUE(runs("cd '" + folder_.path().string() + "' && gmsh - v.geo"));
  const GridFile grid = read_grid(folder_ / "v.msh");
  EXPECT_EQ(grid.faces.size(), 2u);
  ASSERT_EQ(grid.at_points.size(), 1u);
  EXPECT_EQ(grid.at_points[0].name, "h");
  for (std::size_t v = 0; v < grid.points.size(); ++v) {
    const Vec3& p = grid.points[v];
    EXPECT_NEAR(grid.at_points[0].numbers[v], 0.1 + 0.1 * p.x() + 0.2 * p.y(), 1e-12);
  }
}

}  // namespace
}  // namespace surfmesh
