// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vtu_file.hh"

#include <gtest/gtest.h>

#include "support/errors.hh"
#include "support/folders.hh"

namespace surfmesh {
namespace {

/// A triangle, a quad and a pentagon.
VtkGrid three_cells() {
  VtkGrid grid;
  grid.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 2, 0}};
  for (const std::vector<int>& cell :
       std::vector<std::vector<int>>{{0, 1, 2}, {0, 1, 2, 3}, {0, 1, 2, 4, 3}}) {
    grid.cells.add(cell);
  }
  return grid;
}

std::string written(const VtkGrid& grid) {
  const TestFolder folder;
  OutputFile file(folder / "a.vtu");
  write_vtu(grid, VtuNumbers::Text, file);
  file.commit();
  return read_text(folder / "a.vtu");
}

TEST(VtuFile, HoldsCellsOfAllSizes) {
  const std::string text = written(three_cells());
  EXPECT_NE(text.find("NumberOfPoints=\"5\" NumberOfCells=\"3\""), std::string::npos);
  EXPECT_NE(text.find(">\n 0 1 2 0 1 2 3 0 1 2 4 3\n</DataArray>"), std::string::npos);
  EXPECT_NE(text.find("Name=\"offsets\" NumberOfComponents=\"1\" format=\"ascii\">\n 3 7 12\n"),
            std::string::npos);
  EXPECT_NE(text.find("Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">\n 5 9 7\n"),
            std::string::npos);
}

TEST(VtuFile, HoldsValues) {
  VtkGrid grid = three_cells();
  grid.at_points = {{"uv", 2, std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1, 0.5, 2}}};
  grid.at_cells = {{"patch", 1, std::vector<int>{0, 0, -1}}};
  grid.tensors = std::string("size");
  const std::string text = written(grid);
  EXPECT_NE(text.find("<PointData Tensors=\"size\">\n<DataArray type=\"Float64\" Name=\"uv\" "
                      "NumberOfComponents=\"2\" format=\"ascii\">\n 0 0\n 1 0\n"),
            std::string::npos);
  EXPECT_NE(text.find("<DataArray type=\"Int32\" Name=\"patch\" NumberOfComponents=\"1\" "
                      "format=\"ascii\">\n 0 0 -1\n"),
            std::string::npos);
}

TEST(VtuFile, HasNamesOfAnyBytes) {
  VtkGrid grid = three_cells();
  grid.at_cells = {{"caf\xE9\x01<&\">", 1, std::vector<int>{0, 0, -1}}};
  EXPECT_NE(written(grid).find(" Name=\"caf\xEF\xBF\xBD\xEF\xBF\xBD&lt;&amp;&quot;>\" "),
            std::string::npos);
}

TEST(VtuFile, RefusesPositionsThatAreNotFinite) {
  VtkGrid grid = three_cells();
  grid.points[3] = Vec3::Constant(kUnset);
  EXPECT_EQ(error_of([&] { written(grid); }),
            "geometry: the position of vertex 3 is (nan, nan, nan)");
}

}  // namespace
}  // namespace surfmesh
