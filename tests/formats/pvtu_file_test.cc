// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/pvtu_file.hh"

#include <gtest/gtest.h>

#include <cstdlib>

#include "formats/foreign_programs.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/mesh_pieces.hh"
#include "surfmesh/formats/grid_file.hh"
#include "surfmesh/formats/read_mesh.hh"

namespace surfmesh {
namespace {

void write_piece(const MeshPiece& piece, const MeshNames& names,
                 const std::filesystem::path& path) {
  OutputFile file(path);
  write_vtu_piece(piece, names, file);
  file.commit();
}

TEST(PvtuFile, HoldsPiecesThatOurReaderTakes) {
  const TestFolder folder;
  for (const MeshPiece& piece : testing::strip_in_pieces(12, 3)) {
    write_piece(piece, testing::kStripNames, folder / "a.vtu");
    const GridFile grid = read_grid(folder / "a.vtu");
    EXPECT_EQ(grid.points, piece.points);
    EXPECT_EQ(grid.faces, piece.faces);
    EXPECT_EQ(grid.patches, piece.patches);
    EXPECT_EQ(grid.names.patches, testing::kStripNames.patches);
    ASSERT_EQ(grid.at_points.size(), 1u);
    EXPECT_EQ(grid.at_points[0].name, "GlobalNodeIds");
    EXPECT_EQ(grid.at_points[0].numbers, std::vector<double>(piece.ids.begin(), piece.ids.end()));
  }
}

TEST(PvtuFile, HoldsQuads) {
  const TestFolder folder;
  MeshPiece piece;
  piece.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  piece.ids = {7, 8, 9, std::int64_t{1} << 40};
  piece.faces.add(std::vector{0, 1, 2, 3});
  piece.patches = {3};
  write_piece(piece, {}, folder / "a.vtu");
  const GridFile grid = read_grid(folder / "a.vtu");
  EXPECT_EQ(grid.faces, piece.faces);
  EXPECT_EQ(grid.patches, piece.patches);
  EXPECT_EQ(grid.at_points[0].numbers.back(), static_cast<double>(piece.ids.back()));
}

TEST(PvtuFile, TakesFewBytes) {
  const TestFolder folder;
  const MeshPiece piece = testing::strip_in_pieces(20000, 1).front();
  write_piece(piece, testing::kStripNames, folder / "a.vtu");
  const auto of_points = static_cast<double>(32 * piece.points.size());
  const auto of_faces = static_cast<double>(25 * piece.faces.size());
  EXPECT_NEAR(static_cast<double>(std::filesystem::file_size(folder / "a.vtu")),
              of_points + of_faces, 3000);
}

TEST(PvtuFile, RefusesPositionsThatAreNotFinite) {
  const TestFolder folder;
  MeshPiece piece = testing::strip_in_pieces(4, 1).front();
  piece.points[3] = Vec3::Constant(kUnset);
  piece.ids[3] = 77;
  EXPECT_EQ(error_of([&] { write_piece(piece, {}, folder / "a.vtu"); }),
            "geometry: the position of vertex 77 is (nan, nan, nan)");
}

constexpr const char* kReadPvtu = R"(
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader
from vtkmodules.util.numpy_support import vtk_to_numpy as numbers
reader = vtkXMLPUnstructuredGridReader()
reader.SetFileName("a.pvtu")
reader.Update()
grid = reader.GetOutput()
ids = numbers(grid.GetPointData().GetGlobalIds())
cells = grid.GetCellData()
print(grid.GetNumberOfPoints(), grid.GetNumberOfCells(), ids.min(), ids.max(), len(set(ids)))
print(numbers(cells.GetArray("patch")).sum(), numbers(cells.GetArray("group")).sum())
print(numbers(grid.GetPoints().GetData())[:, 0].sum())
lists = []
for name in ["a_0.vtu", "a_1.vtu", "a_2.vtu"]:
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    ids = numbers(grid.GetPointData().GetGlobalIds())
    field = grid.GetFieldData()
    pieces, offsets, vertices = [
        numbers(field.GetArray("neighbour_" + name)) for name in ["pieces", "offsets", "vertices"]]
    lists.append({piece: list(ids[vertices[offsets[k]:offsets[k + 1]]])
                  for k, piece in enumerate(pieces)})
    print(numbers(field.GetArray("group:first")), numbers(field.GetArray("patch:upper")))
agree = all(lists[a][b] == lists[b][a] for a in range(3) for b in lists[a])
print([sorted(l) for l in lists], agree)
)";

TEST(PvtuFile, IsReadByVtkWithItsGlobalIdsAndSharedVertices) {
  const std::string python = kPython;
  if (std::system((python + " -c 'import vtkmodules.vtkIOXML, numpy' 2>/dev/null").c_str()) != 0) {
    GTEST_SKIP() << "no VTK here; tools/setup.sh --readers installs it";
  }
  const TestFolder folder;
  std::vector<std::string> names;
  for (const MeshPiece& piece : testing::strip_in_pieces(12, 3)) {
    names.push_back("a_" + std::to_string(names.size()) + ".vtu");
    write_piece(piece, testing::kStripNames, folder / names.back());
  }
  OutputFile file(folder / "a.pvtu");
  write_pvtu(names, testing::kStripNames, file);
  file.commit();
  write_text(folder / "read.py", kReadPvtu);
  const std::string run =
      "cd '" + folder.path().string() + "' && " + python + " read.py >out 2>err";
  EXPECT_EQ(std::system(run.c_str()), 0) << read_text(folder / "err");
  EXPECT_EQ(read_text(folder / "err"), "");
  EXPECT_EQ(read_text(folder / "out"),
            "45 48 0 38 39\n"
            "24 24\n"
            "270.0\n"
            "[1] [1]\n[1] [1]\n[1] [1]\n"
            "[[1], [0, 2], [1]] True\n");
}

}  // namespace
}  // namespace surfmesh
