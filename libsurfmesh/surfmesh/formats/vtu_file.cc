// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vtu_file.hh"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/formats/file_words.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/formats/vtu_reader.hh"
#include "surfmesh/formats/vtu_text.hh"
#include "surfmesh/io/base64.hh"
#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

/// Cells with one value each that stand in one line.
constexpr std::size_t kCellsPerLine = 20;

using vtu::escaped;
using vtu::kType;

class VtuWriter {
 public:
  VtuWriter(const VtkGrid& grid, VtuNumbers numbers, OutputFile& file)
      : grid_(grid), is_binary_(numbers == VtuNumbers::Binary), writer_(file) {}

  void write() {
    write_head();
    write_values("PointData", grid_.at_points, grid_.tensors);
    writer_.text("<Cells>\n");
    write_cells();
    writer_.text("</Cells>\n");
    write_values("CellData", grid_.at_cells, {});
    writer_.text("</Piece>\n</UnstructuredGrid>\n");
    if (is_binary_) append();
    writer_.text("</VTKFile>\n");
    writer_.flush();
  }

 private:
  /// Numbers in memory that stand behind the XML.
  using Bytes = std::span<const std::byte>;

  void write_head() {
    writer_.text(
        fmt::format("<?xml version=\"1.0\"?>\n"
                    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\"{}>\n"
                    "<UnstructuredGrid>\n",
                    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian",
                    is_binary_ ? " header_type=\"UInt64\"" : ""));
    if (!grid_.whole.empty()) {
      writer_.text("<FieldData>\n");
      for (const VtkValues& values : grid_.whole) write_array(values, true);
      writer_.text("</FieldData>\n");
    }
    writer_.text(fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
                             grid_.points.size(), grid_.cells.size()));
    const double* first = grid_.points.empty() ? nullptr : grid_.points.front().data();
    write_array<double>("points", 3, {first, 3 * grid_.points.size()}, 3);
    writer_.text("</Points>\n");
  }

  void write_values(std::string_view tag, const std::vector<VtkValues>& all,
                    std::string_view tensors) {
    writer_.text(tensors.empty() ? fmt::format("<{}>\n", tag)
                                 : fmt::format("<{} Tensors=\"{}\">\n", tag, escaped(tensors)));
    for (const VtkValues& values : all) write_array(values, false);
    writer_.text(fmt::format("</{}>\n", tag));
  }

  void write_array(const VtkValues& values, bool is_whole) {
    const auto components = static_cast<std::size_t>(values.components);
    const std::size_t per_line = components > 1 ? components : kCellsPerLine;
    std::visit(
        [&](const auto& numbers) {
          using Number = typename std::decay_t<decltype(numbers)>::value_type;
          write_array<Number>(values.name, values.components, numbers, per_line, is_whole);
        },
        values.values);
  }

  /// The grid as a whole tells how many values an array has.
  template <class Number>
  void write_array(std::string_view name, int components, std::span<const Number> numbers,
                   std::size_t per_line, bool is_whole = false) {
    writer_.text(
        fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"{}\"",
                    kType<Number>, escaped(name), components,
                    is_whole ? fmt::format(" NumberOfTuples=\"{}\"", numbers.size()) : "",
                    is_binary_ ? "appended" : "ascii"));
    if (is_binary_) {
      writer_.text(fmt::format(" offset=\"{}\"/>\n", offset_));
      appended_.push_back(std::as_bytes(numbers));
      offset_ += base64_size(sizeof(std::uint64_t) + appended_.back().size());
      return;
    }
    writer_.text(">\n");
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      writer_.number(' ', numbers[i]);
      if ((i + 1) % per_line == 0 || i + 1 == numbers.size()) writer_.text("\n");
    }
    writer_.text("</DataArray>\n");
  }

  void write_cells() {
    const FaceList& cells = grid_.cells;
    write_array("connectivity", 1, cells.vertices(), kCellsPerLine);
    write_array("offsets", 1, cells.offsets().subspan(1), kCellsPerLine);
    types_.resize(cells.size());
    share_ranges(cells.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t f = first; f < end; ++f) types_[f] = vtk_cell_type(cells[f].size());
    });
    write_array<std::uint8_t>("types", 1, types_, kCellsPerLine);
  }

  void append() {
    writer_.text("<AppendedData encoding=\"base64\">\n_");
    Base64Writer base64(writer_);
    for (const Bytes bytes : appended_) {
      const std::uint64_t size = bytes.size();
      base64.add(std::as_bytes(std::span(&size, 1)));
      base64.add(bytes);
      base64.finish();
    }
    writer_.text("\n</AppendedData>\n");
  }

  const VtkGrid& grid_;
  bool is_binary_;
  FileWriter writer_;
  std::vector<std::uint8_t> types_;
  std::vector<Bytes> appended_;
  std::size_t offset_ = 0;
};

void write_mesh_as_vtu(const PolyMesh& mesh, const MeshNames& names, const OutputOptions&,
                       OutputFile& file) {
  write_vtu(vtk_grid(mesh, names), VtuNumbers::Binary, file);
}

std::vector<std::string> lost_in_vtu(const PolyMesh& mesh, const MeshNames& names,
                                     const OutputOptions&) {
  std::vector<std::string> lost = lost_in_grid(mesh);
  add_changed(changed_in_vtk(mesh, names), lost);
  return lost;
}

}  // namespace

void write_vtu(const VtkGrid& grid, VtuNumbers numbers, OutputFile& file) {
  check_points(grid);
  VtuWriter(grid, numbers, file).write();
}

MeshFormat vtu_format() {
  return {.ending = ".vtu",
          .parse = parse_vtu,
          .write = write_mesh_as_vtu,
          .what_is_lost = lost_in_vtu,
          .changed_names = changed_in_vtk};
}

}  // namespace surfmesh
