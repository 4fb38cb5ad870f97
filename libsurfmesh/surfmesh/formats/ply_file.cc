// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/ply_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/core/shared_vertices.hh"
#include "surfmesh/formats/cage_of_arrays.hh"
#include "surfmesh/formats/cage_text.hh"
#include "surfmesh/formats/patch_numbers.hh"
#include "surfmesh/formats/ply_head.hh"
#include "surfmesh/formats/ply_header.hh"
#include "surfmesh/io/byte_scanner.hh"
#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

using ply::Element;
using ply::Format;
using ply::Header;
using ply::PatchRun;
using ply::Property;
using ply::Type;

/// Values of a binary body.
class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, const Header& header, const std::string& name)
      : scanner_(bytes, header.size, name,
                 header.format == Format::Big ? std::endian::big : std::endian::little) {}

  void begin_element(std::string_view, std::size_t, std::size_t) { start_ = scanner_.offset(); }

  double number(Type type, std::string_view what) {
    const std::size_t place = scanner_.offset();
    const double value = take(type);
    if (!std::isfinite(value)) {
      scanner_.fail_at(place, fmt::format("{} is {}, which is not finite", what, value));
    }
    return value;
  }

  std::int64_t integer(Type type, std::string_view) {
    return static_cast<std::int64_t>(take(type));
  }
  void skip(Type type) { take(type); }

  /// At the beginning of the element.
  [[noreturn]] void fail(std::string_view reason) const { scanner_.fail_at(start_, reason); }

  void warn(const std::string& text) {
    if (warnings_.empty() || warnings_.back().second != text)
      warnings_.emplace_back(1, text);
    else
      ++warnings_.back().first;
  }

  Notices finish() {
    if (scanner_.rest() > 0) {
      warn(fmt::format("{} bytes after the last element are ignored", scanner_.rest()));
    }
    Notices notices;
    for (const auto& [count, text] : warnings_) {
      notices.push_back(warning_at(scanner_.name(), NoticeKind::IgnoredInput, text));
      notices.back().count = count;
    }
    return notices;
  }

  /// Counts may lie: room is made for no more numbers than the file can hold.
  std::size_t likely(std::size_t count) const { return std::min(count, scanner_.rest()); }

 private:
  double take(Type type) {
    switch (type) {
      case Type::Int8:
        return scanner_.take<std::int8_t>();
      case Type::Uint8:
        return scanner_.take<std::uint8_t>();
      case Type::Int16:
        return scanner_.take<std::int16_t>();
      case Type::Uint16:
        return scanner_.take<std::uint16_t>();
      case Type::Int32:
        return scanner_.take<std::int32_t>();
      case Type::Uint32:
        return scanner_.take<std::uint32_t>();
      case Type::Float32:
        return static_cast<double>(scanner_.take<float>());
      case Type::Float64:
        break;
    }
    return scanner_.take<double>();
  }

  ByteScanner scanner_;
  std::size_t start_ = 0;
  std::vector<std::pair<std::size_t, std::string>> warnings_;
};

/// Values of a body in text, one element a line.
class TextValues {
 public:
  TextValues(std::string_view bytes, const Header& header, const std::string& name)
      : size_(bytes.size()), scanner_(bytes, name, TextScanner::Joining::Off), warnings_(name) {
    while (scanner_.line() < header.lines && scanner_.next_line()) {
    }
  }

  void begin_element(std::string_view what, std::size_t done, std::size_t count) {
    if (scanner_.next_line()) return;
    scanner_.fail(
        fmt::format("the file ends after {} of {} elements {}", done, count, quoted(what)));
  }

  double number(Type, std::string_view what) { return scanner_.to_number(next_word(what), what); }

  std::int64_t integer(Type, std::string_view what) {
    return scanner_.to_integer(next_word(what), what);
  }

  void skip(Type) { next_word("a value"); }

  [[noreturn]] void fail(std::string_view reason) const { scanner_.fail(reason); }
  void warn(const std::string& text) { warnings_.add(scanner_.line(), text); }

  Notices finish() {
    if (scanner_.next_line()) {
      warnings_.add(scanner_.line(), "the lines after the last element are ignored");
    }
    return warnings_.notices();
  }

  std::size_t likely(std::size_t count) const { return std::min(count, size_); }

 private:
  std::string_view next_word(std::string_view what) {
    const std::string_view word = scanner_.next_word();
    if (word.empty()) scanner_.fail(fmt::format("{} is missing", what));
    return word;
  }

  std::size_t size_;
  TextScanner scanner_;
  WarningList warnings_;
};

/// Reads the elements of a body; Values is one of the two above.
template <class Values>
class BodyReader {
 public:
  BodyReader(const Header& header, Values values) : header_(header), values_(std::move(values)) {}

  MeshArraysFile read() {
    for (const Element& element : header_.elements) {
      if (element.name == "vertex") vertex_count_ = element.count;
    }
    for (const Element& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        skip_elements(element);
      }
    }
    file_.notices = values_.finish();
    return std::move(file_);
  }

 private:
  /// The number of the coordinate that a property is; 3 for none.
  static int axis_of(const Property& property) {
    if (property.count_type) return 3;
    return property.name == "x" ? 0 : property.name == "y" ? 1 : property.name == "z" ? 2 : 3;
  }

  void read_vertices(const Element& element) {
    std::array<int, 4> seen = {};
    for (const Property& property : element.properties)
      ++seen[static_cast<std::size_t>(axis_of(property))];
    if (seen[0] != 1 || seen[1] != 1 || seen[2] != 1) {
      values_.fail("the vertices do not have the properties x, y and z once each");
    }
    file_.mesh.points.reserve(values_.likely(element.count));
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.begin_element(element.name, i, element.count);
      Vec3 point;
      for (const Property& property : element.properties) {
        const int axis = axis_of(property);
        if (axis < 3) {
          point[axis] = values_.number(property.type, "a coordinate");
        } else {
          skip_property(property);
        }
      }
      file_.mesh.points.push_back(point);
    }
  }

  static bool has_corners(const Property& property) {
    return property.count_type && !is_float(property.type) &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  static bool has_patch(const Property& property) {
    return !property.count_type && !is_float(property.type) && property.name == "patch";
  }

  void read_faces(const Element& element) {
    const auto& properties = element.properties;
    if (std::count_if(properties.begin(), properties.end(), has_corners) != 1) {
      values_.fail("the faces do not have one list vertex_indices");
    }
    if (std::count_if(properties.begin(), properties.end(), has_patch) > 1) {
      values_.fail("the faces have the property patch twice");
    }
    file_.mesh.faces.reserve(values_.likely(element.count), values_.likely(3 * element.count));
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.begin_element(element.name, i, element.count);
      for (const Property& property : properties) {
        if (has_corners(property)) {
          read_corners(property);
        } else if (has_patch(property)) {
          read_patch(property);
        } else {
          skip_property(property);
        }
      }
      add_face();
    }
  }

  void read_corners(const Property& property) {
    const std::int64_t count = values_.integer(*property.count_type, "the vertex count of a face");
    if (count < 0) values_.fail("the vertex count of a face is negative");
    corners_.clear();
    for (std::int64_t k = 0; k < count; ++k) {
      const std::int64_t vertex = values_.integer(property.type, "a vertex index");
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertex_count_)) {
        values_.fail(fmt::format("vertex index {}, but there are {} vertices, from 0", vertex,
                                 vertex_count_));
      }
      corners_.push_back(static_cast<int>(vertex));
    }
  }

  void read_patch(const Property& property) {
    const std::int64_t patch = values_.integer(property.type, "a patch");
    if (patch < -1 || patch > kMostPatches) {
      values_.fail(fmt::format("patch {} is not a number from 0 to {}, or -1 for none", patch,
                               kMostPatches));
    }
    file_.mesh.patches.push_back(static_cast<int>(patch));
  }

  void add_face() {
    const std::size_t number = count_++;
    switch (mend_corners(corners_)) {
      case CornerFault::TooFew:
        values_.warn(text_of(CornerFault::TooFew));
        file_.degenerate_faces.push_back(number);
        if (!file_.mesh.patches.empty()) file_.mesh.patches.pop_back();
        return;
      case CornerFault::Twice:
        values_.fail(text_of(CornerFault::Twice));
      case CornerFault::TwiceInARow:
        values_.warn(text_of(CornerFault::TwiceInARow));
        break;
      case CornerFault::None:
        break;
    }
    file_.mesh.faces.add(corners_);
  }

  void skip_elements(const Element& element) {
    if (element.properties.empty()) return;
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.begin_element(element.name, i, element.count);
      for (const Property& property : element.properties) skip_property(property);
    }
  }

  void skip_property(const Property& property) {
    std::int64_t count = 1;
    if (property.count_type) count = values_.integer(*property.count_type, "the count of a list");
    for (std::int64_t k = 0; k < count; ++k) values_.skip(property.type);
  }

  const Header& header_;
  Values values_;
  MeshArraysFile file_;
  std::size_t count_ = 0;  ///< of the faces so far
  std::vector<int> corners_;
  std::size_t vertex_count_ = 0;
};

MeshArraysFile read_body(std::string_view bytes, const Header& header, const std::string& name) {
  if (header.format == Format::Ascii) {
    return BodyReader(header, TextValues(bytes, header, name)).read();
  }
  return BodyReader(header, BinaryValues(bytes, header, name)).read();
}

/// The patches of runs of faces, if these are as many as there are faces.
std::vector<int> patches_of_runs(const std::vector<PatchRun>& runs, std::size_t face_count) {
  std::size_t count = 0;
  for (const PatchRun& run : runs) count += run.count;
  std::vector<int> patches;
  if (count != face_count) return patches;
  for (const PatchRun& run : runs) patches.insert(patches.end(), run.count, run.patch);
  return patches;
}

struct FaceSizes {
  std::size_t least = std::numeric_limits<std::size_t>::max();
  std::size_t most = 0;

  FaceSizes& operator+=(const FaceSizes& other) {
    least = std::min(least, other.least);
    most = std::max(most, other.most);
    return *this;
  }
};

FaceSizes face_sizes(const PolyMesh& mesh) {
  return sum_of_ranges(mesh.n_faces(), [&](std::size_t first, std::size_t end) {
    FaceSizes own;
    for (std::size_t f = first; f < end; ++f) {
      const std::size_t size = mesh.valence(FaceHandle(static_cast<int>(f)));
      own += {size, size};
    }
    return own;
  });
}

/// ASCII, for Gmsh reads binary files with positions in single precision only.
void write_ply(const PolyMesh& mesh, const MeshNames& names, const OutputOptions&,
               OutputFile& file) {
  const auto patch_of = find(mesh, keys::face_patch);
  const FaceSizes sizes = face_sizes(mesh);
  const bool are_patches_values = patch_of.is_valid() && sizes.least >= sizes.most;
  FileWriter writer(file);
  const SharedVertices vertices(mesh);
  PlyHead head{.vertices = vertices.count(),
               .faces = mesh.n_faces(),
               .most_corners = sizes.most,
               .has_patch_values = are_patches_values};
  if (patch_of.is_valid()) head.names = &names;
  if (patch_of.is_valid() && !are_patches_values) {
    head.runs = mesh.property(patch_of).data_vector();
  }
  writer.text(ply_head(head));
  write_points(mesh, "", writer);
  writer.pieces(mesh.n_faces(), [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
    for (std::size_t f = first; f < end; ++f) {
      const FaceHandle fh(static_cast<int>(f));
      buffer.number('\n', mesh.valence(fh));
      for_each_vertex_of(mesh, fh,
                         [&](int vertex) { buffer.number(' ', vertices.number(vertex)); });
      if (are_patches_values) buffer.number(' ', mesh.property(patch_of, fh));
    }
  });
  writer.text("\n");
  writer.flush();
}

std::vector<std::string> lost_in_ply(const PolyMesh& mesh, const MeshNames& names,
                                     const OutputOptions&) {
  std::vector<std::string> lost = lost_properties(mesh);
  if (!find(mesh, keys::face_patch).is_valid()) return lost;
  const auto is_changed = [](const std::string& name) { return !can_be_in_ply(name); };
  auto count = std::count_if(names.patches.begin(), names.patches.end(), is_changed);
  for (const Group& group : names.groups) count += is_changed(group.name) ? 1 : 0;
  if (count > 0) {
    lost.insert(lost.begin(),
                fmt::format("the control characters in {} names of patches and groups", count));
  }
  return lost;
}

MeshArraysFile parse_ply_bytes(std::string bytes, const std::string& name) {
  return parse_ply(bytes, name);
}

Cage parse_ply_cage(std::string_view bytes, const std::string& name) {
  return cage_of(parse_ply(bytes, name));
}

}  // namespace

MeshArraysFile parse_ply(std::string_view bytes, const std::string& name) {
  Header header = ply::read_header(bytes, name);
  MeshArraysFile file = read_body(bytes, header, name);
  MeshArrays& mesh = file.mesh;
  if (mesh.patches.empty()) mesh.patches = patches_of_runs(header.runs, mesh.faces.size());
  if (!mesh.patches.empty()) mesh.names = std::move(header.names);
  return file;
}

MeshFormat ply_format() {
  return {.ending = ".ply",
          .parse = parse_ply_bytes,
          .parse_cage = parse_ply_cage,
          .write = write_ply,
          .what_is_lost = lost_in_ply};
}

}  // namespace surfmesh
