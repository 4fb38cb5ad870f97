// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vtu_file.hh"

#include <fmt/format.h>

#include <string_view>

#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

/// Cells with one value each that stand in one line.
constexpr std::size_t kCellsPerLine = 20;

/// What VTK calls a face of so many corners: triangle, quad or polygon.
int cell_type(std::size_t corners) { return corners == 3 ? 5 : corners == 4 ? 9 : 7; }

class VtuWriter {
 public:
  VtuWriter(const VtuGrid& grid, OutputFile& file) : grid_(grid), writer_(file) {}

  void write() {
    writer_.text(fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
        grid_.points.size(), grid_.cells.size()));
    write_points();
    writer_.text(grid_.tensors.empty()
                     ? "</Points>\n<PointData>\n"
                     : fmt::format("</Points>\n<PointData Tensors=\"{}\">\n", grid_.tensors));
    for (const VtuValues& values : grid_.at_points) write_values(values);
    writer_.text("</PointData>\n<Cells>\n");
    write_cells();
    writer_.text("</Cells>\n<CellData>\n");
    for (const VtuValues& values : grid_.at_cells) write_values(values);
    writer_.text("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    writer_.flush();
  }

 private:
  void begin_array(std::string_view type, std::string_view name, int components) {
    writer_.text(fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type,
        name, components));
  }

  void end_array() { writer_.text("</DataArray>\n"); }

  void write_points() {
    begin_array("Float64", "points", 3);
    for (std::size_t i = 0; i < grid_.points.size(); ++i) {
      check_finite(to_openmesh(grid_.points[i]), VertexHandle(static_cast<int>(i)));
      for (const double x : grid_.points[i]) writer_.number(' ', x);
      writer_.text("\n");
    }
    end_array();
  }

  /// `value_of` each of `count` numbers, `per_line` of them in a line.
  template <class ValueOf>
  void write_lines(std::size_t count, std::size_t per_line, ValueOf value_of) {
    for (std::size_t i = 0; i < count; ++i) {
      writer_.number(' ', value_of(i));
      if ((i + 1) % per_line == 0 || i + 1 == count) writer_.text("\n");
    }
  }

  void write_values(const VtuValues& values) {
    const bool is_int = std::holds_alternative<std::vector<int>>(values.values);
    begin_array(is_int ? "Int32" : "Float64", values.name, values.components);
    const auto components = static_cast<std::size_t>(values.components);
    std::visit(
        [&](const auto& numbers) {
          write_lines(numbers.size(), components > 1 ? components : kCellsPerLine,
                      [&](std::size_t i) { return numbers[i]; });
        },
        values.values);
    end_array();
  }

  void write_cells() {
    const FaceList& cells = grid_.cells;
    begin_array("Int64", "connectivity", 1);
    for (std::size_t f = 0; f < cells.size(); ++f) {
      for (const int vertex : cells[f]) writer_.number(' ', vertex);
      writer_.text("\n");
    }
    end_array();
    begin_array("Int64", "offsets", 1);
    write_lines(cells.size(), kCellsPerLine,
                [&](std::size_t f) { return cells.first_corner(f + 1); });
    end_array();
    begin_array("UInt8", "types", 1);
    write_lines(cells.size(), kCellsPerLine,
                [&](std::size_t f) { return cell_type(cells[f].size()); });
    end_array();
  }

  const VtuGrid& grid_;
  FileWriter writer_;
};

}  // namespace

void write_vtu(const VtuGrid& grid, OutputFile& file) { VtuWriter(grid, file).write(); }

}  // namespace surfmesh
