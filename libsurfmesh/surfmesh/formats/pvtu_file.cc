// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/pvtu_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "surfmesh/formats/piece_points.hh"
#include "surfmesh/formats/vtk_grid.hh"
#include "surfmesh/formats/vtu_text.hh"
#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

constexpr std::string_view kIds = "GlobalNodeIds";

/// Without the last attribute, VTK does not take numbers for ids.
constexpr std::string_view kIdAttribute = " IdType=\"1\"";

/// The first group of each patch, -1 for none.
std::vector<int> first_groups(const MeshNames& names, const std::vector<int>& patches) {
  std::size_t count = 0;
  for (const int patch : patches) count = std::max(count, static_cast<std::size_t>(patch) + 1);
  std::vector<int> first;
  for (const auto& groups : groups_by_patch(names, count)) {
    first.push_back(groups.empty() ? -1 : groups.front());
  }
  return first;
}

class PieceWriter {
 public:
  PieceWriter(const MeshPiece& piece, const MeshNames& names, OutputFile& file)
      : piece_(piece), names_(names), writer_(file) {}

  void write() {
    writer_.text(
        fmt::format("<?xml version=\"1.0\"?>\n"
                    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
                    "<UnstructuredGrid>\n"));
    add_whole();
    writer_.text(fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
                             piece_.points.size(), piece_.faces.size()));
    add_points();
    add_cells();
    writer_.text("</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
    for (const auto& write_numbers : appended_) write_numbers();
    writer_.text("\n</AppendedData>\n</VTKFile>\n");
    writer_.flush();
  }

 private:
  /// An array whose numbers come behind the XML, in the order of these calls.
  template <class Number>
  void add_array(std::string_view name, std::string_view more, std::size_t count,
                 std::function<void()> write_numbers) {
    writer_.text(
        fmt::format("<DataArray type=\"{}\" Name=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n",
                    vtu::kType<Number>, vtu::escaped(name), more, offset_));
    const std::uint64_t size = count * sizeof(Number);
    appended_.push_back([this, size, write = std::move(write_numbers)] {
      writer_.bytes(size);
      write();
    });
    offset_ += sizeof(size) + size;
  }

  /// Numbers that stand in memory until the end.
  template <class Number>
  void add_array(std::string_view name, std::string_view more, std::span<const Number> numbers) {
    add_array<Number>(name, more, numbers.size(), [this, numbers] {
      if constexpr (std::endian::native == std::endian::little) {
        const auto bytes = std::as_bytes(numbers);
        writer_.text({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
      } else {
        for (const Number number : numbers) writer_.bytes(number);
      }
    });
  }

  /// Numbers that are found one by one.
  template <class Number, class NumberAt>
  void add_array(std::string_view name, std::size_t count, NumberAt number_at) {
    add_array<Number>(name, "", count, [this, count, number_at] {
      for (std::size_t i = 0; i < count; ++i) writer_.bytes(static_cast<Number>(number_at(i)));
    });
  }

  /// The piece does not tell how many numbers an array of the grid as a whole has.
  void add_whole_array(std::string_view name, std::span<const int> numbers) {
    add_array(name, fmt::format(" NumberOfTuples=\"{}\"", numbers.size()), numbers);
  }

  void add_whole() {
    whole_ = vtk_names(names_);
    writer_.text("<FieldData>\n");
    for (const VtkValues& values : whole_) {
      add_whole_array(values.name, std::get<std::vector<int>>(values.values));
    }
    for (const SharedWithPiece& shared : piece_.neighbours) {
      neighbours_.push_back(shared.piece);
      shared_vertices_.insert(shared_vertices_.end(), shared.vertices.begin(),
                              shared.vertices.end());
      neighbour_offsets_.push_back(static_cast<int>(shared_vertices_.size()));
    }
    add_whole_array("neighbour_pieces", neighbours_);
    add_whole_array("neighbour_offsets", neighbour_offsets_);
    add_whole_array("neighbour_vertices", shared_vertices_);
    writer_.text("</FieldData>\n");
  }

  void add_points() {
    writer_.text(fmt::format("<PointData GlobalIds=\"{}\">\n", kIds));
    add_array<std::int64_t>(kIds, kIdAttribute, piece_.ids);
    writer_.text("</PointData>\n<Points>\n");
    const double* first = piece_.points.empty() ? nullptr : piece_.points.front().data();
    add_array<double>("points", " NumberOfComponents=\"3\"", {first, 3 * piece_.points.size()});
    writer_.text("</Points>\n");
  }

  void add_cells() {
    const FaceList& faces = piece_.faces;
    writer_.text("<Cells>\n");
    add_array("connectivity", "", faces.vertices());
    add_array<int>("offsets", faces.size(),
                   [&faces](std::size_t f) { return faces.first_corner(f + 1); });
    add_array<std::uint8_t>("types", faces.size(),
                            [&faces](std::size_t f) { return vtk_cell_type(faces[f].size()); });
    writer_.text("</Cells>\n<CellData>\n");
    add_array<int>("patch", "", piece_.patches);
    if (!names_.groups.empty()) {
      add_array<int>("group", faces.size(),
                     [first = first_groups(names_, piece_.patches), this](std::size_t f) {
                       return first[static_cast<std::size_t>(piece_.patches[f])];
                     });
    }
    writer_.text("</CellData>\n");
  }

  const MeshPiece& piece_;
  const MeshNames& names_;
  FileWriter writer_;
  std::vector<VtkValues> whole_;
  std::vector<int> neighbours_, neighbour_offsets_ = {0}, shared_vertices_;
  std::vector<std::function<void()>> appended_;
  std::uint64_t offset_ = 0;
};

}  // namespace

void write_vtu_piece(const MeshPiece& piece, const MeshNames& names, OutputFile& file) {
  check_points(piece);
  PieceWriter(piece, names, file).write();
}

void write_pvtu(std::span<const std::string> pieces, const MeshNames& names, OutputFile& file) {
  file.write(fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "<PUnstructuredGrid GhostLevel=\"0\">\n"
      "<PPointData GlobalIds=\"{}\">\n<PDataArray type=\"Int64\" Name=\"{}\"{}/>\n</PPointData>\n"
      "<PCellData>\n<PDataArray type=\"Int32\" Name=\"patch\"/>\n{}</PCellData>\n"
      "<PPoints>\n<PDataArray type=\"Float64\" Name=\"points\" NumberOfComponents=\"3\"/>\n"
      "</PPoints>\n",
      kIds, kIds, kIdAttribute,
      names.groups.empty() ? "" : "<PDataArray type=\"Int32\" Name=\"group\"/>\n"));
  for (const std::string& piece : pieces) {
    file.write(fmt::format("<Piece Source=\"{}\"/>\n", vtu::escaped(piece)));
  }
  file.write("</PUnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace surfmesh
