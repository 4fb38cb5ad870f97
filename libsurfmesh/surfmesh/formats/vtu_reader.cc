// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vtu_reader.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/grid_builder.hh"
#include "surfmesh/formats/patch_numbers.hh"
#include "surfmesh/formats/vtu_document.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh {
namespace {

using vtu::DataArray;
using vtu::Document;
using vtu::Piece;

/// The types of cells that are read: VTK's file formats, figures 2 and 3.
enum class CellType {
  Line = 3,
  PolyLine = 4,
  Triangle = 5,
  Polygon = 7,
  Pixel = 8,
  Quad = 9,
  Tetrahedron = 10,
  QuadraticEdge = 21,
  QuadraticTriangle = 22,
  QuadraticQuad = 23,
  QuadraticTetrahedron = 24,
  BiquadraticQuad = 28,
  BiquadraticTriangle = 34
};

/// Numbers at cells that tell patches: ours first, which are taken as they are.
constexpr std::array<std::string_view, 6> kPatchNames = {
    "patch", "gmsh:geometrical", "gmsh:physical", "medit:ref", "CellEntityIds", "ref"};

/// What names of arrays of patches begin with.
constexpr std::string_view kPatchPrefix = "patch:";
constexpr std::string_view kGroupPrefix = "group:";

/// Corners of a cell of a type: 0 for all of its points, -1 for a cell that is not read.
int corners_of(CellType type) {
  switch (type) {
    case CellType::Line:
    case CellType::QuadraticEdge:
      return 2;
    case CellType::Triangle:
    case CellType::QuadraticTriangle:
    case CellType::BiquadraticTriangle:
      return 3;
    case CellType::Pixel:
    case CellType::Quad:
    case CellType::QuadraticQuad:
    case CellType::BiquadraticQuad:
    case CellType::Tetrahedron:
    case CellType::QuadraticTetrahedron:
      return 4;
    case CellType::PolyLine:
    case CellType::Polygon:
      return 0;
  }
  return -1;
}

class VtuReader {
 public:
  VtuReader(std::string_view bytes, const std::string& name)
      : document_(vtu::read_document(bytes, name)), builder_(name) {}

  GridFile run() {
    for (const Piece& piece : document_.pieces) add_piece(piece);
    finish_patches();
    std::erase_if(builder_.grid.at_points, [&](const GridValues& values) {
      const bool is_whole =
          values.numbers.size() ==
          builder_.grid.points.size() * static_cast<std::size_t>(values.components);
      if (!is_whole) builder_.leave_out("arrays at points of only some pieces");
      return !is_whole;
    });
    return builder_.finish();
  }

 private:
  [[noreturn]] void fail(std::size_t line, std::string_view reason) const {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}:{}: {}", document_.form.name, line, reason));
  }

  void check_size(const DataArray& array, std::size_t size, std::size_t count,
                  std::string_view of) const {
    const auto components = static_cast<std::size_t>(array.components);
    if (size / components == count && size % components == 0) return;
    fail(array.line, fmt::format("array {} has {} numbers, but there are {} {} with {} each",
                                 surfmesh::quoted(array.name), size, count, of, components));
  }

  void add_piece(const Piece& piece) {
    first_point_ = builder_.grid.points.size();
    if (piece.points > 0 || piece.cells > 0) {
      add_points(piece);
      add_cells(piece);
    }
  }

  void add_points(const Piece& piece) {
    if (piece.coordinates.size() != 1) fail(piece.line, "a piece without one array of points");
    const DataArray& array = piece.coordinates.front();
    if (array.components != 3) fail(array.line, "points do not have three coordinates");
    const std::vector<double> numbers = numbers_of(array, document_.form);
    check_size(array, numbers.size(), piece.points, "points");
    std::vector<Vec3>& points = builder_.grid.points;
    points.reserve(points.size() + piece.points);
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
      points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
      if (!points.back().allFinite()) {
        fail(array.line, fmt::format("point {}, from 0, is not finite", i / 3));
      }
    }
    for (const DataArray& values : piece.at_points) add_values(values, piece.points);
  }

  void add_values(const DataArray& array, std::size_t count) {
    const std::vector<double> numbers = numbers_of(array, document_.form);
    check_size(array, numbers.size(), count, "points");
    std::vector<GridValues>& all = builder_.grid.at_points;
    auto known = std::find_if(all.begin(), all.end(), [&](const GridValues& values) {
      return values.name == array.name && values.components == array.components;
    });
    if (known == all.end()) {
      all.push_back({array.name, array.components, {}, false});
      known = all.end() - 1;
    }
    // A piece before has not this array, or this one has it twice: it is told as not whole.
    const auto components = static_cast<std::size_t>(array.components);
    if (known->numbers.size() != first_point_ * components) return;
    known->numbers.insert(known->numbers.end(), numbers.begin(), numbers.end());
  }

  std::vector<std::int64_t> topology(const Piece& piece, std::string_view name) const {
    for (const DataArray& array : piece.topology) {
      if (array.name == name) return integers_of(array, document_.form);
    }
    fail(piece.line, fmt::format("the cells of a piece have no {}", name));
  }

  /// The numbers of patches by cell, -1 for none.
  std::vector<std::int64_t> patches_of(const Piece& piece) {
    for (const std::string_view name : kPatchNames) {
      for (const DataArray& array : piece.at_cells) {
        if (array.name != name || array.components != 1 || !is_integer(array.type)) continue;
        std::vector<std::int64_t> numbers = integers_of(array, document_.form);
        check_size(array, numbers.size(), piece.cells, "cells");
        if (!patch_name_.empty() && patch_name_ != name) {
          fail(array.line, fmt::format("patches are {} here, but {} in a piece before",
                                       surfmesh::quoted(name), surfmesh::quoted(patch_name_)));
        }
        patch_name_ = name;
        return numbers;
      }
    }
    return std::vector<std::int64_t>(piece.cells, -1);
  }

  void add_cells(const Piece& piece) {
    const std::vector<std::int64_t> vertices = topology(piece, "connectivity");
    const std::vector<std::int64_t> offsets = topology(piece, "offsets");
    const std::vector<std::int64_t> types = topology(piece, "types");
    if (offsets.size() != piece.cells || types.size() != piece.cells) {
      fail(piece.line, fmt::format("{} cells with {} offsets and {} types", piece.cells,
                                   offsets.size(), types.size()));
    }
    const std::vector<std::int64_t> patches = patches_of(piece);
    std::int64_t before = 0;
    for (std::size_t c = 0; c < offsets.size(); ++c) {
      if (offsets[c] < before || offsets[c] > static_cast<std::int64_t>(vertices.size())) {
        fail(piece.line, fmt::format("cell {}, from 0, ends at {} of {} vertices", c, offsets[c],
                                     vertices.size()));
      }
      const auto first = static_cast<std::size_t>(before);
      const std::span all(vertices);
      take_vertices(piece, c, all.subspan(first, static_cast<std::size_t>(offsets[c] - before)));
      add_cell(piece, c, types[c], patches[c]);
      before = offsets[c];
    }
  }

  void take_vertices(const Piece& piece, std::size_t cell, std::span<const std::int64_t> vertices) {
    cell_.clear();
    for (const std::int64_t vertex : vertices) {
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(piece.points)) {
        fail(piece.line, fmt::format("cell {}, from 0, has the vertex {}, but there are {} points",
                                     cell, vertex, piece.points));
      }
      cell_.push_back(static_cast<int>(first_point_ + static_cast<std::size_t>(vertex)));
    }
  }

  void add_cell(const Piece& piece, std::size_t number, std::int64_t type, std::int64_t patch) {
    const auto kind = static_cast<CellType>(type);
    const int corners = corners_of(kind);
    if (corners < 0) return builder_.leave_out(fmt::format("cells of the type {}", type));
    if (cell_.size() < static_cast<std::size_t>(corners)) {
      fail(piece.line, fmt::format("cell {}, from 0, has {} vertices, too few for the type {}",
                                   number, cell_.size(), type));
    }
    if (corners > 0 && cell_.size() > static_cast<std::size_t>(corners)) {
      cell_.resize(static_cast<std::size_t>(corners));
      builder_.leave_out_middles();
    }
    if (kind == CellType::Line || kind == CellType::PolyLine || kind == CellType::QuadraticEdge) {
      for (std::size_t k = 1; k < cell_.size(); ++k) {
        builder_.add_side(cell_[k - 1], cell_[k], patch);
      }
    } else if (kind == CellType::Tetrahedron || kind == CellType::QuadraticTetrahedron) {
      builder_.add_tetrahedron({cell_[0], cell_[1], cell_[2], cell_[3]});
    } else {
      if (kind == CellType::Pixel) std::swap(cell_[2], cell_[3]);
      builder_.add_face(cell_, patch);
    }
  }

  void finish_patches() {
    builder_.number_contours();
    if (patch_name_.empty()) return;
    if (patch_name_ != kPatchNames.front()) {
      builder_.number_patches(-1);
      return;
    }
    for (const std::int64_t patch : builder_.references()) {
      if (patch < -1 || patch > kMostPatches) {
        throw Error(ErrorCode::InvalidInput,
                    fmt::format("{}: patch {} is not a number from 0 to {}, or -1 for none",
                                document_.form.name, patch, kMostPatches));
      }
      builder_.grid.patches.push_back(static_cast<int>(patch));
    }
    add_names();
  }

  /// The names that write_mesh keeps in the field data: "patch:NAME" and "group:NAME" are arrays of
  /// the patches of a name, or of a group.
  void add_names() {
    const auto most = std::max_element(builder_.grid.patches.begin(), builder_.grid.patches.end());
    const std::int64_t count = most == builder_.grid.patches.end() ? 0 : std::int64_t{*most} + 1;
    MeshNames& names = builder_.grid.names;
    for (const DataArray& array : document_.whole) {
      const bool is_patch = array.name.starts_with(kPatchPrefix);
      if (!(is_patch || array.name.starts_with(kGroupPrefix)) || !is_integer(array.type)) continue;
      std::vector<std::int64_t> patches = integers_of(array, document_.form);
      // Of patches without faces no more than a name is left.
      std::erase_if(patches, [&](std::int64_t patch) { return patch < 0 || patch >= count; });
      if (is_patch) {
        for (const std::int64_t patch : patches) {
          const auto p = static_cast<std::size_t>(patch);
          if (p >= names.patches.size()) names.patches.resize(p + 1);
          names.patches[p] = array.name.substr(kPatchPrefix.size());
        }
      } else {
        names.groups.push_back({array.name.substr(kGroupPrefix.size()),
                                std::vector<int>(patches.begin(), patches.end())});
      }
    }
    put_in_order(names.groups);
  }

  Document document_;
  GridBuilder builder_;
  std::size_t first_point_ = 0;  ///< of the piece
  std::string_view patch_name_;  ///< of the arrays of patches, if there are any
  std::vector<int> cell_;
};

}  // namespace

GridFile parse_vtu_grid(std::string bytes, const std::string& name) {
  return VtuReader(bytes, name).run();
}

}  // namespace surfmesh
