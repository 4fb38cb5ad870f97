// SPDX-License-Identifier: BSD-3-Clause
//
// Whether other programs read what is written. They are run where they are installed: Debian's
// python3-meshio, python3-vtk9, gmsh and admesh, which `tools/setup.sh --readers` installs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "formats/example_meshes.hh"
#include "formats/foreign_programs.hh"
#include "support/folders.hh"
#include "support/models.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/formats/vtu_file.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

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

  /// The same of triangles, in a.vtu.
  void write_example_as_vtu() const {
    const MeshArrays arrays = mesh_arrays(wavy_grid(4, 0));
    std::vector<int> patches(arrays.faces.size(), 1);
    std::fill_n(patches.begin(), 10, 0);
    OutputFile file(folder_ / "a.vtu");
    write_vtu({arrays.points, arrays.faces, {}, {{"patch", 1, patches}}, {}, {}}, VtuNumbers::Text,
              file);
    file.commit();
  }

  /// A closed mesh, whose vertices have one normal each.
  MeshResult write_torus(const std::string& name) const {
    PipelineOptions options;
    options.sizing.size = Length::units(0.5);
    options.output.normals = true;
    MeshResult result = mesh_model(testing::model_of({testing::whole_torus()}), {}, options);
    write_mesh(result, folder_ / name);
    return result;
  }

  /// What Gmsh makes of a file.
  std::string read_by_gmsh(const std::string& name) const {
    const std::string line = "cd '" + folder_.path().string() + "' && gmsh -0 ";
    EXPECT_TRUE(runs(line + name + " -o a.msh -format msh22")) << name;
    return read_text(folder_ / "a.msh");
  }

  TestFolder folder_;
};

std::string counts_of(const MeshResult& result) {
  return std::to_string(result.mesh.n_vertices()) + " " + std::to_string(result.mesh.n_faces()) +
         "\n";
}

constexpr const char* kCountByMeshio = R"(
import meshio
mesh = meshio.read("a.ply")
print(len(mesh.points), sum(len(c.data) for c in mesh.cells), mesh.points[7][1] == 1 / 7)
for values in mesh.cell_data.get("patch", []): print(sum(values))
)";

TEST_F(ForeignReader, MeshioReadsPlyWithPatches) {
  if (!has_module("meshio")) GTEST_SKIP() << "no meshio here";
  write_example("a.ply", 0);
  EXPECT_EQ(printed(kCountByMeshio), "25 32 True\n22\n");
  write_example("a.ply", 2);
  EXPECT_EQ(printed(kCountByMeshio), "25 24 True\n");
}

constexpr const char* kMeshioCounts = R"(
import meshio
for name in ["a.obj", "a.off", "a.ply", "a.stl", "a.vtu"]:
    mesh = meshio.read(name)
    print(name, len(mesh.points), sum(len(c.data) for c in mesh.cells))
)";

TEST_F(ForeignReader, MeshioReadsAllFormats) {
  if (!has_module("meshio")) GTEST_SKIP() << "no meshio here";
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl"}) write_example(name, 0);
  write_example_as_vtu();
  EXPECT_EQ(printed(kMeshioCounts),
            "a.obj 25 32\na.off 25 32\na.ply 25 32\na.stl 25 32\na.vtu 25 32\n");
}

/// It takes normals for those of the vertices, and fails where there are more.
TEST_F(ForeignReader, MeshioReadsNormalsOfASmoothMesh) {
  if (!has_module("meshio")) GTEST_SKIP() << "no meshio here";
  const MeshResult result = write_torus("a.obj");
  EXPECT_EQ(printed("import meshio\nmesh = meshio.read('a.obj')\n"
                    "print(len(mesh.point_data['obj:vn']), sum(len(c.data) for c in mesh.cells))"),
            counts_of(result));
}

constexpr const char* kCountByVtk = R"(
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
for Reader, name in [(vtkOBJReader, "a.obj"), (vtkSTLReader, "a.stl"), (vtkPLYReader, "a.ply")]:
    reader = Reader()
    reader.SetFileName(name)
    reader.Update()
    print(name, reader.GetOutput().GetNumberOfPoints(), reader.GetOutput().GetNumberOfPolys())
)";

TEST_F(ForeignReader, VtkReadsObjStlAndPly) {
  if (!has_module("vtkmodules.vtkIOPLY")) GTEST_SKIP() << "no VTK here";
  for (const char* name : {"a.obj", "a.ply", "a.stl"}) write_example(name, 0);
  EXPECT_EQ(printed(kCountByVtk), "a.obj 25 32\na.stl 25 32\na.ply 25 32\n");
  for (const char* name : {"a.obj", "a.ply", "a.stl"}) write_example(name, 2);
  EXPECT_EQ(printed(kCountByVtk), "a.obj 25 24\na.stl 25 32\na.ply 25 24\n");
}

constexpr const char* kVtkNormals = R"(
from vtkmodules.vtkIOGeometry import vtkOBJReader
reader = vtkOBJReader()
reader.SetFileName("a.obj")
reader.Update()
mesh = reader.GetOutput()
print(mesh.GetPointData().GetNormals().GetNumberOfTuples(), mesh.GetNumberOfPolys())
)";

/// It takes a vertex apart where its corners differ, so a smooth mesh must have one normal there.
TEST_F(ForeignReader, VtkReadsNormalsOfASmoothMesh) {
  if (!has_module("vtkmodules.vtkIOGeometry")) GTEST_SKIP() << "no VTK here";
  const MeshResult result = write_torus("a.obj");
  EXPECT_EQ(printed(kVtkNormals), counts_of(result));
}

constexpr const char* kVtu = R"(
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
reader = vtkXMLUnstructuredGridReader()
reader.SetFileName("a.vtu")
reader.Update()
grid = reader.GetOutput()
print(grid.GetNumberOfPoints(), grid.GetNumberOfCells(), grid.GetPoint(7)[1] == 1 / 7)
print(grid.GetCellData().GetArray("patch").GetRange())
)";

TEST_F(ForeignReader, VtkReadsVtu) {
  if (!has_module("vtkmodules.vtkIOXML")) GTEST_SKIP() << "no VTK here";
  write_example_as_vtu();
  EXPECT_EQ(printed(kVtu), "25 32 True\n(0.0, 1.0)\n");
}

/// Gmsh takes the first three corners of all faces: meshes are of triangles.
TEST_F(ForeignReader, GmshReadsPlyAndStl) {
  if (!runs("gmsh --version")) GTEST_SKIP() << "no gmsh here";
  for (const char* name : {"a.ply", "a.stl"}) {
    write_example(name, 0);
    const std::string text = read_by_gmsh(name);
    EXPECT_NE(text.find("$Nodes\n25\n"), std::string::npos) << name << text.substr(0, 200);
    EXPECT_NE(text.find("$Elements\n32\n"), std::string::npos) << name;
    // 1/7 in full, or in single precision.
    const char* seventh = name == std::string("a.ply") ? " 0.1428571428571428 " : " 0.142857149243";
    EXPECT_NE(text.find(seventh), std::string::npos) << name;
  }
}

/// The number after a title in the text of admesh.
int count_after(const std::string& text, const std::string& title) {
  const std::size_t place = text.find(title);
  const std::size_t colon = place == text.npos ? text.npos : text.find(':', place);
  return colon == text.npos ? -1 : std::stoi(text.substr(colon + 1));
}

TEST_F(ForeignReader, AdmeshFindsNothingToMendInStl) {
  if (!runs("admesh --version")) GTEST_SKIP() << "no admesh here";
  const MeshResult result = write_torus("a.stl");
  ASSERT_EQ(std::system(("cd '" + folder_.path().string() + "' && admesh a.stl >out").c_str()), 0);
  const std::string text = read_text(folder_ / "out");
  EXPECT_EQ(count_after(text, "Number of facets"), static_cast<int>(result.mesh.n_faces())) << text;
  EXPECT_EQ(count_after(text, "Number of parts"), 1) << text;
  for (const char* title :
       {"Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed",
        "Facets added", "Facets reversed", "Backwards edges", "Normals fixed"}) {
    EXPECT_EQ(count_after(text, title), 0) << title << "\n" << text;
  }
}

}  // namespace
}  // namespace surfmesh
