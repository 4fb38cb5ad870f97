// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/stl_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/formats/cage_of_arrays.hh"
#include "surfmesh/formats/split_face.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/io/byte_scanner.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh {
namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kTriangleSize = 50;  // twelve floats and two bytes

/// Gives points their numbers: equal coordinates are one vertex. Open addressing with linear
/// steps, at most half full.
class PointTable {
 public:
  explicit PointTable(std::vector<Vec3>& points) : points_(points), slots_(kFirstSize, -1) {}

  int number_of(Vec3 point) {
    point += Vec3::Zero();  // -0 is 0
    if (2 * (points_.size() + 1) > slots_.size()) grow();
    int& slot = slot_of(point);
    if (slot < 0) {
      slot = static_cast<int>(points_.size());
      points_.push_back(point);
    }
    return slot;
  }

 private:
  static constexpr std::size_t kFirstSize = 1024;

  static std::uint64_t hash(const Vec3& point) {
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k) {
      h = (h ^ std::bit_cast<std::uint64_t>(point[k])) * 0x9E3779B97F4A7C15u;
      h ^= h >> 32;
    }
    return h;
  }

  int& slot_of(const Vec3& point) {
    std::size_t i = hash(point) & (slots_.size() - 1);
    while (slots_[i] >= 0 && points_[static_cast<std::size_t>(slots_[i])] != point) {
      i = (i + 1) & (slots_.size() - 1);
    }
    return slots_[i];
  }

  void grow() {
    slots_.assign(2 * slots_.size(), -1);
    for (std::size_t v = 0; v < points_.size(); ++v) slot_of(points_[v]) = static_cast<int>(v);
  }

  std::vector<Vec3>& points_;
  std::vector<int> slots_;
};

/// Makes faces of triangles, whichever way they are written.
class TriangleCollector {
 public:
  void add(const std::array<Vec3, 3>& points) {
    std::array<int, 3> t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = table_.number_of(points[k]);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      file_.degenerate_faces.push_back(count_);
    } else {
      file_.mesh.faces.add(t);
      file_.mesh.patches.push_back(static_cast<int>(file_.mesh.names.patches.size()) - 1);
    }
    ++count_;
  }

  void begin_solid(std::string name) { file_.mesh.names.patches.push_back(std::move(name)); }

  /// `name` is that of the file, for messages.
  MeshArraysFile finish(const std::string& name) {
    if (file_.mesh.names.patches.size() < 2) {
      file_.mesh.names.patches.clear();
      file_.mesh.patches.clear();
    }
    if (!file_.degenerate_faces.empty()) {
      file_.notices.push_back(warning_at(
          name, NoticeKind::IgnoredInput,
          fmt::format("{} triangles with two equal corners are left out, the first is number {}",
                      file_.degenerate_faces.size(), file_.degenerate_faces.front())));
    }
    return std::move(file_);
  }

 private:
  MeshArraysFile file_;
  PointTable table_{file_.mesh.points};
  std::size_t count_ = 0;
};

MeshArraysFile parse_binary(std::string_view bytes, const std::string& name) {
  ByteScanner scanner(bytes, std::min(kHeaderSize, bytes.size()), name);
  const auto count = scanner.take<std::uint32_t>();
  if (scanner.rest() / kTriangleSize < count) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: the file ends after {} of {} triangles (byte {}), or it is not an "
                            "STL file",
                            name, scanner.rest() / kTriangleSize, count, bytes.size()));
  }
  TriangleCollector triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    scanner.skip(3 * sizeof(float));
    std::array<Vec3, 3> points;
    for (Vec3& point : points) {
      for (int k = 0; k < 3; ++k) {
        const std::size_t place = scanner.offset();
        point[k] = static_cast<double>(scanner.take<float>());
        if (!std::isfinite(point[k])) {
          scanner.fail_at(place, fmt::format("a coordinate is {}, which is not finite", point[k]));
        }
      }
    }
    scanner.skip(sizeof(std::uint16_t));
    triangles.add(points);
  }
  MeshArraysFile file = triangles.finish(name);
  if (scanner.rest() > 0) {
    file.notices.push_back(
        warning_at(name, NoticeKind::IgnoredInput,
                   fmt::format("{} bytes after the last triangle are ignored", scanner.rest())));
  }
  return file;
}

std::string lower_case(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

class TextReader {
 public:
  TextReader(std::string_view text, const std::string& name)
      : scanner_(text, name, TextScanner::Joining::Off) {}

  MeshArraysFile read() {
    while (scanner_.next_line()) {
      const std::string word = next_keyword();
      if (word == "solid" && !is_in_solid_) {
        begin_solid();
      } else if (word == "endsolid" && is_in_solid_) {
        is_in_solid_ = false;
      } else if (word == "facet" && is_in_solid_) {
        read_facet();
      } else {
        scanner_.fail(
            fmt::format("{} is not what comes next in an STL file", surfmesh::quoted(word)));
      }
    }
    if (is_in_solid_) scanner_.fail("the file ends before endsolid");
    return triangles_.finish(scanner_.name());
  }

 private:
  /// Some write "end loop" for endloop.
  std::string next_keyword() {
    std::string word = lower_case(scanner_.next_word());
    if (word == "end") word += lower_case(scanner_.next_word());
    return word;
  }

  void begin_solid() {
    is_in_solid_ = true;
    triangles_.begin_solid(std::string(scanner_.next_word()));
  }

  void expect_line(std::string_view keyword) {
    if (!scanner_.next_line()) scanner_.fail("the file ends in a triangle");
    const std::string word = next_keyword();
    if (word != keyword) {
      scanner_.fail(fmt::format("{} instead of {}", surfmesh::quoted(word), keyword));
    }
  }

  void read_facet() {
    expect_line("outer");
    std::array<Vec3, 3> points;
    for (Vec3& point : points) {
      expect_line("vertex");
      point = scanner_.next_point();
    }
    expect_line("endloop");
    expect_line("endfacet");
    triangles_.add(points);
  }

  TextScanner scanner_;
  TriangleCollector triangles_;
  bool is_in_solid_ = false;
};

/// A binary file may begin with "solid", too: its size tells. Text may have blanks before it.
bool is_binary(std::string_view bytes) {
  const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  if (lower_case(bytes.substr(start, 5)) != "solid") return true;
  if (bytes.size() < kHeaderSize + sizeof(std::uint32_t)) return false;
  const auto count = ByteScanner(bytes, kHeaderSize, {}).take<std::uint32_t>();
  return bytes.size() == kHeaderSize + sizeof(std::uint32_t) + kTriangleSize * std::size_t{count};
}

using Triangles = std::vector<std::array<int, 3>>;

std::size_t count_triangles(const PolyMesh& mesh) {
  return sum_of_ranges(mesh.n_faces(), [&](std::size_t first, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t f = first; f < end; ++f) {
      count += mesh.valence(FaceHandle(static_cast<int>(f))) - 2;
    }
    return count;
  });
}

void write_vector(const OpenMesh::Vec3d& vector, TextBuffer& buffer) {
  for (std::size_t k = 0; k < 3; ++k) buffer.bytes(static_cast<float>(vector[k]));
}

void write_triangle(const PolyMesh& mesh, const std::array<int, 3>& t, TextBuffer& buffer) {
  const auto& a = mesh.point(VertexHandle(t[0]));
  const auto& b = mesh.point(VertexHandle(t[1]));
  const auto& c = mesh.point(VertexHandle(t[2]));
  OpenMesh::Vec3d normal = OpenMesh::cross(b - a, c - a);
  const double length = normal.norm();
  if (length > 0 && std::isfinite(length)) {
    normal /= length;
  } else {
    normal = {0, 0, 0};
  }
  for (const auto& vector : {normal, a, b, c}) write_vector(vector, buffer);
  buffer.bytes(std::uint16_t{0});
}

/// Faces of more than three corners are split: quads at their shorter diagonal, others into the fan
/// of their first corner.
void write_stl(const PolyMesh& mesh, const MeshNames&, const OutputOptions&, OutputFile& file) {
  check_single_precision(mesh, ".stl");
  FileWriter writer(file);
  std::string header = "surfmesh";
  header.resize(kHeaderSize, ' ');
  writer.text(header);
  writer.bytes(static_cast<std::uint32_t>(count_triangles(mesh)));
  writer.pieces(mesh.n_faces(), [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
    std::vector<int> face;
    Triangles triangles;
    for (std::size_t f = first; f < end; ++f) {
      face.clear();
      triangles.clear();
      for_each_vertex_of(mesh, FaceHandle(static_cast<int>(f)),
                         [&face](int vertex) { face.push_back(vertex); });
      split_face(mesh, face, triangles);
      for (const auto& triangle : triangles) write_triangle(mesh, triangle, buffer);
    }
  });
  writer.flush();
}

std::vector<std::string> lost_in_stl(const PolyMesh& mesh, const MeshNames& names,
                                     const OutputOptions&) {
  std::vector<std::string> lost;
  add_lost_digits(mesh, lost);
  add_split_faces(mesh, 3, lost);
  for (std::string& more : lost_patches_and_properties(mesh, names)) {
    lost.push_back(std::move(more));
  }
  return lost;
}

MeshArraysFile parse_stl_bytes(std::string bytes, const std::string& name) {
  return parse_stl(bytes, name);
}

Cage parse_stl_cage(std::string_view bytes, const std::string& name) {
  return cage_of(parse_stl(bytes, name));
}

}  // namespace

MeshArraysFile parse_stl(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw Error(ErrorCode::InvalidInput, name + ": the file is empty");
  return is_binary(bytes) ? parse_binary(bytes, name) : TextReader(bytes, name).read();
}

MeshFormat stl_format() {
  return {.ending = ".stl",
          .parse = parse_stl_bytes,
          .parse_cage = parse_stl_cage,
          .write = write_stl,
          .is_single_precision = true,
          .what_is_lost = lost_in_stl};
}

}  // namespace surfmesh
