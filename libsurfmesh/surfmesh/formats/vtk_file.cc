// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vtk_file.hh"

#include <fmt/format.h>

#include <limits>
#include <span>
#include <string_view>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/file_words.hh"
#include "surfmesh/formats/vtk_grid.hh"
#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

/// A name as VTK reads it in legacy files: one word, other bytes as %20.
std::string encoded(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const bool is_plain = c > ' ' && c < '\x7f' && c != '"' && c != '%';
    text += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return text;
}

class VtkWriter {
 public:
  VtkWriter(const VtkGrid& grid, OutputFile& file) : grid_(grid), writer_(file) {}

  void write() {
    writer_.text(
        "# vtk DataFile Version 3.0\nsurfmesh\nBINARY\n"
        "DATASET UNSTRUCTURED_GRID\n");
    write_fields(grid_.whole);
    writer_.text(fmt::format("POINTS {} double\n", grid_.points.size()));
    const double* first = grid_.points.empty() ? nullptr : grid_.points.front().data();
    write_numbers(std::span(first, 3 * grid_.points.size()));
    write_cells();
    write_values("CELL_DATA", grid_.cells.size(), grid_.at_cells);
    write_values("POINT_DATA", grid_.points.size(), grid_.at_points);
    writer_.flush();
  }

 private:
  void write_cells() {
    const FaceList& cells = grid_.cells;
    writer_.text(fmt::format("\nCELLS {} {}\n", cells.size(), cells.size() + cells.corner_count()));
    writer_.pieces(cells.size(), [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
      for (std::size_t f = first; f < end; ++f) {
        buffer.big_endian(static_cast<int>(cells[f].size()));
        for (const int vertex : cells[f]) buffer.big_endian(vertex);
      }
    });
    writer_.text(fmt::format("\nCELL_TYPES {}\n", cells.size()));
    writer_.pieces(cells.size(), [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
      for (std::size_t f = first; f < end; ++f) {
        buffer.big_endian(int{vtk_cell_type(cells[f].size())});
      }
    });
    writer_.text("\n");
  }

  void write_values(std::string_view section, std::size_t count,
                    const std::vector<VtkValues>& values) {
    if (values.empty()) return;
    writer_.text(fmt::format("{} {}\n", section, count));
    write_fields(values);
  }

  void write_fields(const std::vector<VtkValues>& all) {
    if (all.empty()) return;
    writer_.text(fmt::format("FIELD FieldData {}\n", all.size()));
    for (const VtkValues& values : all) {
      std::visit([&](const auto& numbers) { write_array(values, numbers); }, values.values);
    }
  }

  template <class Number>
  void write_array(const VtkValues& values, const std::vector<Number>& numbers) {
    writer_.text(fmt::format("{} {} {} {}\n", encoded(values.name), values.components,
                             numbers.size() / static_cast<std::size_t>(values.components),
                             sizeof(Number) == sizeof(double) ? "double" : "int"));
    write_numbers(std::span(numbers));
    writer_.text("\n");
  }

  template <class Number>
  void write_numbers(std::span<const Number> numbers) {
    writer_.pieces(numbers.size(), [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
      for (std::size_t i = first; i < end; ++i) buffer.big_endian(numbers[i]);
    });
  }

  const VtkGrid& grid_;
  FileWriter writer_;
};

void write_vtk(const PolyMesh& mesh, const MeshNames& names, const OutputOptions&,
               OutputFile& file) {
  const VtkGrid grid = vtk_grid(mesh, names);
  check_points(grid);
  if (grid.cells.size() + grid.cells.corner_count() >
      static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw Error(ErrorCode::InvalidInput, ".vtk files hold up to 500 million triangles");
  }
  VtkWriter(grid, file).write();
}

std::vector<std::string> lost_in_vtk(const PolyMesh& mesh, const MeshNames& names,
                                     const OutputOptions&) {
  std::vector<std::string> lost = lost_in_grid(mesh);
  add_changed(changed_in_vtk(mesh, names), lost);
  return lost;
}

}  // namespace

MeshFormat vtk_format() {
  return {.ending = ".vtk",
          .write = write_vtk,
          .what_is_lost = lost_in_vtk,
          .changed_names = changed_in_vtk};
}

}  // namespace surfmesh
