// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/om_file.hh"

// OpenMesh wants this before any of its mesh types.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/IO/writer/OMWriter.hh>
#include <OpenMesh/Core/Utils/PropertyCreator.hh>
//
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <mutex>
#include <new>
#include <sstream>
#include <streambuf>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/cage_of_arrays.hh"
#include "surfmesh/formats/patch_numbers.hh"
#include "surfmesh/io/byte_scanner.hh"
#include "surfmesh/io/file_writer.hh"

// Lets OpenMesh's reader make the properties that it finds in a file.
OM_REGISTER_PROPERTY_TYPE(surfmesh::Uv)
OM_REGISTER_PROPERTY_TYPE(surfmesh::Metric)
OM_REGISTER_PROPERTY_TYPE(surfmesh::SizeTensor)
OM_REGISTER_PROPERTY_TYPE(surfmesh::Normal)

namespace surfmesh {
namespace {

/// Keeps OpenMesh from printing while it lives. One at a time, so that the streams, which are the
/// whole program's, are left as they were found.
class Silence {
 public:
  Silence() : lock_(mutex()) {
    for (std::size_t i = 0; i < streams().size(); ++i) {
      was_enabled_[i] = streams()[i]->is_enabled();
      streams()[i]->disable();
    }
  }
  ~Silence() {
    for (std::size_t i = 0; i < streams().size(); ++i) {
      // A line without its end would come out at the next one.
      streams()[i]->flush();
      if (was_enabled_[i]) streams()[i]->enable();
    }
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  using Streams = std::array<OpenMesh::mostream*, 3>;

  static Streams& streams() {
    static Streams streams = {&omlog(), &omout(), &omerr()};
    return streams;
  }
  static std::mutex& mutex() {
    static std::mutex mutex;
    return mutex;
  }

  std::scoped_lock<std::mutex> lock_;
  std::array<bool, 3> was_enabled_ = {};
};

OpenMesh::IO::Options with_properties() {
  OpenMesh::IO::Options options;
  options += OpenMesh::IO::Options::Binary;
  options += OpenMesh::IO::Options::Custom;
  return options;
}

[[noreturn]] void fail(const std::string& name, std::string_view reason) {
  throw Error(ErrorCode::InvalidInput, fmt::format("{}: {}", name, reason));
}

// Heads of chunks.
constexpr std::size_t kHeadSize = 2;
constexpr std::uint16_t kEndMark = 7u << 2;
constexpr std::uint16_t kNamesChunk = 1u << 1 | 1u << 2 | 6u << 5 | 3u << 14;

/// The type of the value of that chunk.
constexpr std::string_view kNamesType = "surfmesh::MeshNames";

bool is_index(std::int64_t i, std::size_t count) {
  return i >= 0 && static_cast<std::size_t>(i) < count;
}

/// Checks that the bytes of an .om file are what OpenMesh writes, before OpenMesh reads them: it
/// trusts its input, and stops the program, writes outside of its arrays or reads on beyond the end
/// where that is wrong.
///
/// A file is a header of 16 bytes and chunks, each with a head of 16 bits; see OMFormat.hh.
///
/// The names of patches and groups are a custom chunk of the mesh of our own, the last one:
/// OpenMesh itself, whose text values end at 64 KiB, skips it.
class OmCheck {
 public:
  explicit OmCheck(std::string_view bytes) : bytes_(bytes), rest_(bytes) {}

  bool has_header();
  bool are_chunks_sound();
  /// The bytes without the chunks to leave out.
  std::string bytes() const;

  /// A chunk of values of varying size. OpenMesh trusts the lengths in it, so a small file could
  /// ask for any amount of memory.
  struct LeftOut {
    std::string_view chunk;
    std::string_view name;  ///< of the property
    std::string_view type;
  };

  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::string_view names;  ///< the value of the chunk of names, empty if there is none
  std::vector<LeftOut> left_out;

 private:
  // Entities and types, as in OMFormat.hh.
  static constexpr unsigned kVertex = 0, kMesh = 1, kFace = 2, kEdge = 4, kHalfedge = 6;
  static constexpr unsigned kPosition = 0, kCustom = 6, kTopology = 7;

  std::uint64_t read_unsigned(std::size_t size);
  std::int64_t read_signed(std::size_t size);
  bool skip(std::uint64_t size);
  std::string_view take_word();
  bool skip_custom(unsigned entity);
  bool skip_positions(std::size_t size);
  bool check_topology(unsigned entity, unsigned dimensions, std::size_t size);
  bool are_made(unsigned entity) const;

  std::string_view bytes_;  ///< all
  std::string_view rest_;
  bool has_positions_ = false, has_halfedges_ = false, has_faces_ = false;  ///< read so far
};

bool is_of_varying_size(std::string_view type) {
  return type.starts_with("std::vector<") || type == "std::string";
}

/// Take a little-endian number; 0 beyond the end.
std::uint64_t OmCheck::read_unsigned(std::size_t size) {
  std::uint64_t value = 0;
  size = std::min(size, rest_.size());
  for (std::size_t i = 0; i < size; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << (8 * i);
  }
  rest_.remove_prefix(size);
  return value;
}

std::int64_t OmCheck::read_signed(std::size_t size) {
  const std::uint64_t value = read_unsigned(size);
  const std::uint64_t sign = std::uint64_t{1} << (8 * size - 1);
  return static_cast<std::int64_t>(value ^ sign) - static_cast<std::int64_t>(sign);
}

bool OmCheck::skip(std::uint64_t size) {
  if (size > rest_.size()) return false;
  rest_.remove_prefix(size);
  return true;
}

bool OmCheck::has_header() {
  if (rest_.size() < 16 || !rest_.starts_with("OM")) return false;
  rest_.remove_prefix(3);
  if (read_unsigned(1) != OpenMesh::IO::_OMWriter_::get_version()) return false;
  vertices = read_unsigned(4);
  faces = read_unsigned(4);
  edges = read_unsigned(4);
  return true;
}

/// A text with its length, a byte, before it; cut off at the end.
std::string_view OmCheck::take_word() {
  const std::uint64_t size = read_unsigned(1);
  const std::string_view word = rest_.substr(0, size);
  rest_.remove_prefix(word.size());
  return word;
}

/// A custom chunk has a name, the name of its type and a size before its values.
bool OmCheck::skip_custom(unsigned entity) {
  const std::size_t start = bytes_.size() - rest_.size() - kHeadSize;
  const std::string_view name = take_word(), type = take_word();
  if (!are_made(entity) || rest_.size() < 4) return false;
  const std::uint64_t size = read_unsigned(4);
  if (entity == kMesh && name == keys::mesh_names) names = rest_.substr(0, size);
  if (!skip(size)) return false;
  if (is_of_varying_size(type)) {
    left_out.push_back({bytes_.substr(start, bytes_.size() - rest_.size() - start), name, type});
  }
  return true;
}

std::string OmCheck::bytes() const {
  std::string result;
  result.reserve(bytes_.size());
  const char* from = bytes_.data();
  for (const LeftOut& one : left_out) {
    result.append(from, one.chunk.data());
    from = one.chunk.data() + one.chunk.size();
  }
  result.append(from, bytes_.data() + bytes_.size());
  return result;
}

/// OpenMesh makes the elements where these chunks stand, anew at each. It stops the program at
/// values of elements that are not made yet.
bool OmCheck::are_made(unsigned entity) const {
  switch (entity) {
    case kVertex:
      return has_positions_ || vertices == 0;
    case kEdge:
    case kHalfedge:
      return has_halfedges_ || edges == 0;
    case kFace:
      return has_faces_ || faces == 0;
    default:
      return true;
  }
}

bool OmCheck::skip_positions(std::size_t size) {
  if (has_positions_) return false;
  has_positions_ = true;
  return skip(std::uint64_t{vertices} * 3 * size);
}

/// A halfedge has its next halfedge, the vertex at its tip and its face; a vertex or a face has a
/// halfedge. Whether they fit together is seen when the mesh is read.
bool OmCheck::check_topology(unsigned entity, unsigned dimensions, std::size_t size) {
  const bool is_halfedge = entity == kHalfedge;
  const std::size_t count = is_halfedge ? 2 * edges : entity == kFace ? faces : vertices;
  if (entity != kVertex && entity != kFace && !is_halfedge) return false;
  if (dimensions != (is_halfedge ? 3u : 1u) || count * dimensions * size > rest_.size())
    return false;
  // Vertices exist by now; halfedges and faces are made here, once.
  if (are_made(entity) != (entity == kVertex) && count > 0) return false;
  (is_halfedge ? has_halfedges_ : entity == kFace ? has_faces_ : has_positions_) = true;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t halfedge = read_signed(size);
    if (!is_index(halfedge, 2 * edges) && (halfedge != -1 || entity != kVertex)) return false;
    if (!is_halfedge) continue;
    if (!is_index(read_signed(size), vertices)) return false;
    const std::int64_t face = read_signed(size);
    if (!is_index(face, faces) && face != -1) return false;
  }
  return true;
}

bool OmCheck::are_chunks_sound() {
  while (rest_.size() >= kHeadSize) {
    const auto head = static_cast<unsigned>(read_unsigned(kHeadSize));
    if (head == kEndMark) return rest_.empty();
    const bool has_name = (head >> 1 & 1) != 0;
    const unsigned entity = head >> 2 & 7;
    const unsigned type = head >> 5 & 15;
    const bool is_signed = (head >> 9 & 1) != 0;
    const bool is_float = (head >> 10 & 1) != 0;
    const unsigned dimensions = (head >> 11 & 7) + 1;
    const unsigned bits = head >> 14;
    bool is_good = false;
    if (type == kCustom) {
      is_good = has_name && skip_custom(entity);
    } else if (type == kPosition) {
      is_good = !has_name && entity == kVertex && is_float && dimensions == 3 && bits < 2 &&
                skip_positions(std::size_t{4} << bits);
    } else if (type == kTopology) {
      // The flag of floats means nothing here: the writer sets it although these are integers.
      is_good = !has_name && is_signed && bits < 3 &&
                check_topology(entity, dimensions, std::size_t{1} << bits);
    }
    if (!is_good) return false;
  }
  return false;
}

/// Takes names from the value of their chunk: counts and texts, with the lengths of these before
/// them, all counts of 32 bits.
class NamesReader {
 public:
  NamesReader(std::string_view bytes, const std::string& name)
      : bytes_(bytes), scanner_(bytes, 0, name) {}

  MeshNames read() {
    MeshNames names;
    for (std::size_t count = take_count(); count > 0; --count) names.patches.push_back(take_text());
    for (std::size_t count = take_count(); count > 0; --count) {
      Group& group = names.groups.emplace_back();
      group.name = take_text();
      for (std::size_t patches = take_count(); patches > 0; --patches) {
        group.patches.push_back(scanner_.take<std::int32_t>());
        if (group.patches.back() < 0) scanner_.fail("a patch of a group is negative");
      }
    }
    if (scanner_.rest() == 0) return names;  // of versions without names of contours
    for (std::size_t count = take_count(); count > 0; --count) {
      names.contours.push_back(take_text());
    }
    return names;
  }

 private:
  std::size_t take_count() { return scanner_.take<std::uint32_t>(); }

  std::string take_text() {
    const std::size_t size = take_count();
    const std::size_t start = scanner_.offset();
    scanner_.skip(size);
    return std::string(bytes_.substr(start, size));
  }

  std::string_view bytes_;
  ByteScanner scanner_;
};

void append_count(std::size_t count, std::string& bytes) {
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(count >> (8 * i) & 255);
}

void append_text(const std::string& text, std::string& bytes) {
  append_count(text.size(), bytes);
  bytes += text;
}

/// What NamesReader reads.
std::string names_value(const MeshNames& names) {
  std::string bytes;
  append_count(names.patches.size(), bytes);
  for (const std::string& name : names.patches) append_text(name, bytes);
  append_count(names.groups.size(), bytes);
  for (const Group& group : names.groups) {
    append_text(group.name, bytes);
    append_count(group.patches.size(), bytes);
    for (const int patch : group.patches) append_count(static_cast<std::uint32_t>(patch), bytes);
  }
  if (names.contours.empty()) return bytes;
  append_count(names.contours.size(), bytes);
  for (const std::string& name : names.contours) append_text(name, bytes);
  return bytes;
}

/// Hands all that is written on to a file but the last bytes, the end mark, so that a chunk can be
/// put before it: a mesh property would have to be added to the mesh, which is not ours.
///
/// OpenMesh stops the program where its stream takes fewer bytes than it is given. So an error is
/// kept until the end, and whatever comes after it is dropped.
class WithoutEndMark : public std::streambuf {
 public:
  explicit WithoutEndMark(FileWriter& writer) : writer_(writer) {}

  /// Throws   the first error of the file
  void finish() {
    if (error_) std::rethrow_exception(error_);
    hand_on();
  }

 protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    if (error_) return size;
    try {
      put({text, static_cast<std::size_t>(size)});
    } catch (...) {
      error_ = std::current_exception();
    }
    return size;
  }

  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    xsputn(&byte, 1);
    return traits_type::not_eof(c);
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 16;

  void put(std::string_view text) {
    if (held_.size() + text.size() > kPiece) {
      hand_on();
      if (text.size() > kPiece) text = hand_on_but_end(text);
    }
    held_ += text;
  }

  void hand_on() {
    const std::size_t size = held_.size() - std::min(held_.size(), sizeof(kEndMark));
    writer_.text(std::string_view(held_).substr(0, size));
    held_.erase(0, size);
  }

  /// Hand on what is held and all of a text but its last bytes, which are returned: whole
  /// properties come in one piece, of which no copy is wanted.
  std::string_view hand_on_but_end(std::string_view text) {
    writer_.text(held_);
    held_.clear();
    const std::size_t size = text.size() - sizeof(kEndMark);
    writer_.text(text.substr(0, size));
    return text.substr(size);
  }

  FileWriter& writer_;
  std::string held_;
  std::exception_ptr error_;
};

/// True if `heh` is one halfedge of a proper mesh, as far as its neighbours go.
bool is_halfedge_sound(const PolyMesh& mesh, HalfedgeHandle heh) {
  const HalfedgeHandle next = mesh.next_halfedge_handle(heh);
  const FaceHandle face = mesh.face_handle(heh);
  return is_index(next.idx(), mesh.n_halfedges()) &&
         is_index(mesh.to_vertex_handle(heh).idx(), mesh.n_vertices()) &&
         (face.idx() == -1 || is_index(face.idx(), mesh.n_faces())) &&
         mesh.prev_halfedge_handle(next) == heh && mesh.face_handle(next) == face &&
         mesh.from_vertex_handle(next) == mesh.to_vertex_handle(heh);
}

bool is_sound(const PolyMesh& mesh) {
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (!is_halfedge_sound(mesh, heh)) return false;
  }
  for (const FaceHandle fh : mesh.faces()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(fh);
    if (!is_index(heh.idx(), mesh.n_halfedges()) || mesh.face_handle(heh) != fh) return false;
  }
  for (const VertexHandle vh : mesh.vertices()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(vh);
    if (heh.idx() == -1) continue;
    if (!is_index(heh.idx(), mesh.n_halfedges()) || mesh.from_vertex_handle(heh) != vh)
      return false;
  }
  return true;
}

/// What was read is written again with the next file.
template <class Iterator>
void make_persistent(Iterator begin, Iterator end) {
  for (Iterator property = begin; property != end; ++property) {
    if (*property != nullptr && (*property)->name().starts_with(kPropertyPrefix)) {
      (*property)->set_persistent(true);
    }
  }
}

void write_om(const PolyMesh& mesh, const MeshNames& names, const OutputOptions&,
              OutputFile& file) {
  FileWriter writer(file);
  {
    const Silence silence;
    WithoutEndMark buffer(writer);
    std::ostream stream(&buffer);
    OpenMesh::IO::write_mesh(mesh, stream, ".om", with_properties());
    buffer.finish();
  }
  if (names != MeshNames()) {
    const std::string value = names_value(names);
    writer.bytes(kNamesChunk);
    for (const std::string_view word : {keys::mesh_names, kNamesType}) {
      writer.bytes(static_cast<std::uint8_t>(word.size()));
      writer.text(word);
    }
    writer.bytes(static_cast<std::uint32_t>(value.size()));
    writer.text(value);
  }
  writer.bytes(kEndMark);
  writer.flush();
}

void read_checked(std::string bytes, const OmCheck& check, const std::string& name,
                  PolyMesh& mesh) {
  std::istringstream stream(std::move(bytes));
  bool is_read = false;
  try {
    const Silence silence;
    OpenMesh::IO::Options options = with_properties();
    is_read = OpenMesh::IO::read_mesh(mesh, stream, ".om", options);
  } catch (const std::bad_alloc&) {
    throw;  // which is no fault of the file
  } catch (const std::exception& error) {
    fail(name, error.what());
  }
  if (!is_read || mesh.n_vertices() != check.vertices || mesh.n_faces() != check.faces ||
      mesh.n_edges() != check.edges || !is_sound(mesh)) {
    fail(name, "the file is cut short or damaged");
  }
}

/// Throws   InvalidInput for a face with a position that is not finite
void check_positions(const PolyMesh& mesh, const std::string& name) {
  for (const VertexHandle vh : mesh.vertices()) {
    const Vec3 point = to_eigen(mesh.point(vh));
    if (point.allFinite() || mesh.is_isolated(vh)) continue;
    fail(name, fmt::format("the position of vertex {} is {}, which is not finite", vh.idx(),
                           point_text(point)));
  }
}

/// Throws   InvalidInput for a patch that arrays by patch have no room for
void check_patches(const PolyMesh& mesh, const std::string& name) {
  const auto patch_of = find(mesh, keys::face_patch);
  if (!patch_of.is_valid()) return;
  for (const FaceHandle fh : mesh.faces()) {
    const int patch = mesh.property(patch_of, fh);
    if (patch <= kMostPatches) continue;
    fail(name, fmt::format("face {} is of patch {}, and patches are read up to {}", fh.idx(), patch,
                           kMostPatches));
  }
}

/// Tell of the properties that are left out, all at once: a file may have any number of them.
Notice notice_of(const std::vector<OmCheck::LeftOut>& left_out, const std::string& name) {
  const OmCheck::LeftOut& first = left_out.front();
  const std::size_t others = left_out.size() - 1;
  return warning_at(
      name, NoticeKind::IgnoredInput,
      fmt::format("the property {}{} is left out: values of varying size, as of {}, "
                  "are not read",
                  first.name, others > 0 ? fmt::format(" (and {} more)", others) : "", first.type));
}

/// The faces only. That there are none is told by whoever reads.
MeshArraysFile parse_om_faces(std::string bytes, const std::string& name) {
  const MeshFile file = parse_om(std::move(bytes), name);
  return {mesh_arrays(file.mesh, file.names, ArrayParts::Faces), file.notices, {}};
}

Cage parse_om_cage(std::string_view bytes, const std::string& name) {
  return cage_of(parse_om_faces(std::string(bytes), name));
}

std::vector<std::string> lost_in_om(const PolyMesh&, const MeshNames&, const OutputOptions&) {
  return {};
}

}  // namespace

MeshFile parse_om(std::string bytes, const std::string& name) {
  OmCheck check(bytes);
  if (!check.has_header()) fail(name, "this is not an .om file of a version that is read");
  if (!check.are_chunks_sound()) fail(name, "the file is cut short or damaged");
  MeshFile file;
  if (!check.names.empty()) file.names = NamesReader(check.names, name).read();
  if (!check.left_out.empty()) file.notices.push_back(notice_of(check.left_out, name));
  read_checked(check.left_out.empty() ? std::move(bytes) : check.bytes(), check, name, file.mesh);
  check_positions(file.mesh, name);
  check_patches(file.mesh, name);
  PolyMesh& mesh = file.mesh;
  make_persistent(mesh.vprops_begin(), mesh.vprops_end());
  make_persistent(mesh.hprops_begin(), mesh.hprops_end());
  make_persistent(mesh.eprops_begin(), mesh.eprops_end());
  make_persistent(mesh.fprops_begin(), mesh.fprops_end());
  return file;
}

MeshFormat om_format() {
  return {.ending = ".om",
          .parse = parse_om_faces,
          .parse_mesh = parse_om,
          .parse_cage = parse_om_cage,
          .write = write_om,
          .has_corner_values = true,
          .what_is_lost = lost_in_om};
}

}  // namespace surfmesh
