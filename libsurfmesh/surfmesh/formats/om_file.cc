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
#include <mutex>
#include <sstream>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/io/input_file.hh"

// Lets OpenMesh's reader make the properties that it finds in a file.
OM_REGISTER_PROPERTY_TYPE(surfmesh::Uv)
OM_REGISTER_PROPERTY_TYPE(surfmesh::Metric)
OM_REGISTER_PROPERTY_TYPE(surfmesh::SizeTensor)

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

bool is_index(std::int64_t i, std::size_t count) {
  return i >= 0 && static_cast<std::size_t>(i) < count;
}

/// Checks that the bytes of an .om file are what write_om() makes, before OpenMesh reads them: it
/// trusts its input, and stops the program, writes outside of its arrays or reads on beyond the end
/// where that is wrong.
///
/// A file is a header of 16 bytes and chunks, each with a head of 16 bits; see OMFormat.hh.
class OmCheck {
 public:
  explicit OmCheck(std::string_view bytes) : rest_(bytes) {}

  bool has_header();
  bool are_chunks_sound();

  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;

 private:
  // Entities and types, as in OMFormat.hh.
  static constexpr unsigned kVertex = 0, kFace = 2, kHalfedge = 6;
  static constexpr unsigned kPosition = 0, kCustom = 6, kTopology = 7;
  static constexpr unsigned kEndMark = 7u << 2;

  std::uint64_t take_unsigned(std::size_t size);
  std::int64_t take_signed(std::size_t size);
  bool skip(std::uint64_t size);
  bool skip_custom();
  bool check_topology(unsigned entity, unsigned dimensions, std::size_t size);

  std::string_view rest_;
};

/// Take a little-endian number; 0 beyond the end.
std::uint64_t OmCheck::take_unsigned(std::size_t size) {
  std::uint64_t value = 0;
  size = std::min(size, rest_.size());
  for (std::size_t i = 0; i < size; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << (8 * i);
  }
  rest_.remove_prefix(size);
  return value;
}

std::int64_t OmCheck::take_signed(std::size_t size) {
  const std::uint64_t value = take_unsigned(size);
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
  if (take_unsigned(1) != OpenMesh::IO::_OMWriter_::get_version()) return false;
  vertices = take_unsigned(4);
  faces = take_unsigned(4);
  edges = take_unsigned(4);
  return true;
}

/// A custom chunk has a name, the name of its type and a size before its values.
bool OmCheck::skip_custom() {
  return skip(take_unsigned(1)) && skip(take_unsigned(1)) && rest_.size() >= 4 &&
         skip(take_unsigned(4));
}

/// A halfedge has its next halfedge, the vertex at its tip and its face; a vertex or a face has a
/// halfedge. Whether they fit together is seen when the mesh is read.
bool OmCheck::check_topology(unsigned entity, unsigned dimensions, std::size_t size) {
  const bool is_halfedge = entity == kHalfedge;
  const std::size_t count = is_halfedge ? 2 * edges : entity == kFace ? faces : vertices;
  if (entity != kVertex && entity != kFace && !is_halfedge) return false;
  if (dimensions != (is_halfedge ? 3u : 1u) || count * dimensions * size > rest_.size())
    return false;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t halfedge = take_signed(size);
    if (!is_index(halfedge, 2 * edges) && (halfedge != -1 || entity != kVertex)) return false;
    if (!is_halfedge) continue;
    if (!is_index(take_signed(size), vertices)) return false;
    const std::int64_t face = take_signed(size);
    if (!is_index(face, faces) && face != -1) return false;
  }
  return true;
}

bool OmCheck::are_chunks_sound() {
  while (rest_.size() >= 2) {
    const auto head = static_cast<unsigned>(take_unsigned(2));
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
      is_good = has_name && skip_custom();
    } else if (type == kPosition) {
      is_good = !has_name && entity == kVertex && is_float && dimensions == 3 && bits < 2 &&
                skip(std::uint64_t{vertices} * 3 * (4u << bits));
    } else if (type == kTopology) {
      // The flag of floats means nothing here: the writer sets it although these are integers.
      is_good = !has_name && is_signed && bits < 3 &&
                check_topology(entity, dimensions, std::size_t{1} << bits);
    }
    if (!is_good) return false;
  }
  return false;
}

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

}  // namespace

void write_om(const PolyMesh& mesh, OutputFile& file) {
  const Silence silence;
  // A failed stream is reported by the file's commit().
  OpenMesh::IO::write_mesh(mesh, file.stream(), ".om", with_properties());
}

PolyMesh read_om(const std::filesystem::path& path) {
  if (lower_case_ending(path) != ".om") fail(path.string(), "the ending of this format is .om");
  return parse_om(read_file(path), path.string());
}

PolyMesh parse_om(std::string bytes, const std::string& name) {
  OmCheck check(bytes);
  if (!check.has_header()) fail(name, "this is not an .om file of a version that is read");
  if (!check.are_chunks_sound()) fail(name, "the file is cut short or damaged");
  std::istringstream stream(std::move(bytes));
  PolyMesh mesh;
  bool is_read = false;
  try {
    const Silence silence;
    OpenMesh::IO::Options options = with_properties();
    is_read = OpenMesh::IO::read_mesh(mesh, stream, ".om", options);
  } catch (const std::exception& error) {
    fail(name, error.what());
  }
  if (!is_read || mesh.n_vertices() != check.vertices || mesh.n_faces() != check.faces ||
      mesh.n_edges() != check.edges || !is_sound(mesh)) {
    fail(name, "the file is cut short or damaged");
  }
  make_persistent(mesh.vprops_begin(), mesh.vprops_end());
  make_persistent(mesh.hprops_begin(), mesh.hprops_end());
  make_persistent(mesh.eprops_begin(), mesh.eprops_end());
  make_persistent(mesh.fprops_begin(), mesh.fprops_end());
  return mesh;
}

}  // namespace surfmesh
