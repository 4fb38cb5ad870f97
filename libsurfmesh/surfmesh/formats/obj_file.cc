// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/obj_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/shared_vertices.hh"
#include "surfmesh/formats/cage_text.hh"
#include "surfmesh/formats/obj_corners.hh"
#include "surfmesh/formats/obj_groups.hh"
#include "surfmesh/formats/obj_labels.hh"
#include "surfmesh/formats/obj_tags.hh"
#include "surfmesh/formats/obj_texture.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

/// Keywords without meaning for a cage.
constexpr std::array<std::string_view, 15> kIgnoredKeywords = {
    "vn",  "vp",    "s",      "l",        "p",        "mtllib",     "maplib",   "mg",
    "lod", "bevel", "usemap", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name, ReadFor purpose)
      : purpose_(purpose),
        text_(text, name, TextScanner::Joining::Backslash, purpose),
        scanner_(text_.scanner) {}

  /// The cage without its groups, which the labels are.
  Cage read();

  const ObjLabels& labels() const { return labels_; }
  std::vector<std::size_t> left_out() const { return text_.left_out_of_mesh(); }

  /// What the file has at its corners, which is not read.
  std::vector<std::string> unread() const;

 private:
  void read_statement(std::string_view keyword);
  void read_vertex();
  void read_face();
  int read_corner(std::string_view word);
  void check_more_indices(std::string_view indices) const;
  void read_group_names();
  std::string read_name();
  void check_references() const;
  bool takes_texture() const { return purpose_ == ReadFor::Cage; }

  ReadFor purpose_;
  CageText text_;
  TextScanner& scanner_;
  ObjLabels labels_;
  ObjTexture texture_{text_};
  std::vector<int> corners_;  ///< of the face that is being read
  std::vector<LaterReference> later_vertices_;
  ObjTags tags_{text_, later_vertices_};
  bool has_normals_ = false;
  bool has_texture_ = false;
};

Cage ObjReader::read() {
  text_.begin();
  do {
    read_statement(scanner_.next_word());
  } while (scanner_.next_line());
  text_.check_not_empty();
  check_references();
  tags_.number_holes();
  tags_.drop_creases_without_edge();
  if (takes_texture()) texture_.finish();
  return text_.finish();
}

std::vector<std::string> ObjReader::unread() const {
  std::vector<std::string> words;
  if (has_normals_) words.push_back("normals (vn)");
  if (has_texture_) words.push_back("texture coordinates (vt)");
  return words;
}

void ObjReader::read_statement(std::string_view keyword) {
  if (keyword == "v") return read_vertex();
  if (keyword == "f") return read_face();
  if (keyword == "g") return read_group_names();
  if (keyword == "o") return labels_.set_object(read_name());
  if (keyword == "usemtl") return labels_.set_material(read_name());
  if (keyword == "t") return tags_.read();
  has_normals_ |= keyword == "vn";
  if (keyword == "vt") {
    has_texture_ = true;
    if (takes_texture()) texture_.read_point();
    return;
  }
  if (std::find(kIgnoredKeywords.begin(), kIgnoredKeywords.end(), keyword) !=
      kIgnoredKeywords.end()) {
    return;
  }
  text_.warnings.add(scanner_.line(), fmt::format("unknown keyword {} is ignored", quoted(keyword)),
                     "unknown keyword");
}

/// Coordinates, with a weight and a colour of three values behind them or either of these.
void ObjReader::read_vertex() {
  Vec3 point = scanner_.next_point();
  std::array<std::string_view, 5> more;
  std::size_t count = 0;
  for (auto word = scanner_.next_word(); !word.empty(); word = scanner_.next_word()) {
    if (count < more.size()) more[count] = word;
    ++count;
  }
  if (count == 1 || count == 4) {
    point = text_.divided(point, scanner_.to_number(more[0], "the weight of a vertex"));
  } else if (count != 0 && count != 3) {
    text_.warnings.add(scanner_.line(), "values after the coordinates are ignored");
  }
  text_.cage.points.push_back(point);
}

void ObjReader::read_face() {
  corners_.clear();
  texture_.begin_face();
  for (auto word = scanner_.next_word(); !word.empty(); word = scanner_.next_word()) {
    corners_.push_back(read_corner(word));
  }
  if (!text_.add_face(corners_)) return;
  labels_.add_face();
  if (takes_texture()) texture_.end_face();
}

int ObjReader::read_corner(std::string_view word) {
  const std::size_t slash = word.find('/');
  const int index = scanner_.to_integer(word.substr(0, slash), "a vertex index");
  if (slash != std::string_view::npos) check_more_indices(word.substr(slash));
  if (takes_texture()) texture_.add_corner(word.substr(std::min(slash, word.size())));
  const int count = static_cast<int>(text_.cage.points.size());
  if (index == 0) scanner_.fail("vertex index 0, they count from 1");
  if (index < 0) {
    // Not -index, which does not exist for the least integer.
    if (index < -count) {
      scanner_.fail(fmt::format("vertex index {}, but {} vertices before it", index, count));
    }
    return count + index;
  }
  if (index > count) later_vertices_.push_back({scanner_.line(), index - 1, index});
  return index - 1;
}

void ObjReader::check_more_indices(std::string_view indices) const {
  if (indices.find_first_not_of("/-+0123456789") != std::string_view::npos ||
      std::count(indices.begin(), indices.end(), '/') > 2) {
    scanner_.fail(
        fmt::format("{} after a vertex index, which is not /vt, //vn or /vt/vn", quoted(indices)));
  }
}

void ObjReader::read_group_names() {
  std::vector<std::string> words;
  for (auto word = scanner_.next_word(); !word.empty(); word = scanner_.next_word()) {
    words.emplace_back(word);
  }
  labels_.set_groups(std::move(words));
}

/// The words of the rest of the line: names of objects and materials may have blanks.
std::string ObjReader::read_name() {
  std::string name(scanner_.next_word());
  for (auto word = scanner_.next_word(); !word.empty(); word = scanner_.next_word()) {
    name.append(" ").append(word);
  }
  return name;
}

void ObjReader::check_references() const {
  const int vertex_count = static_cast<int>(text_.cage.points.size());
  for (const LaterReference& vertex : later_vertices_) {
    if (vertex.index < vertex_count) continue;
    scanner_.fail_at(vertex.line, fmt::format("vertex index {}, but there are {} vertices",
                                              vertex.written, vertex_count));
  }
}

MeshArraysFile parse_obj_mesh(std::string text, const std::string& name) {
  ObjReader reader(text, name, ReadFor::Mesh);
  MeshArraysFile file = arrays_of(reader.read());
  file.degenerate_faces = reader.left_out();
  file.mesh.patches = reader.labels().patches(file.mesh.names);
  file.unread = reader.unread();
  return file;
}

/// The lines of groups between the faces of a mesh.
class GroupLines {
 public:
  GroupLines(const PolyMesh& mesh, const MeshNames& names, FileWriter& writer)
      : mesh_(mesh), patch_of_(find(mesh, keys::face_patch)) {
    if (!patch_of_.is_valid()) return;
    const std::vector<int>& patches = mesh.property(patch_of_).data_vector();
    groups_.emplace(patches, names);
    writer.text(groups_->before_faces(patches));
  }

  /// The lines between a face and the one before it.
  std::string_view before(FaceHandle fh) const {
    if (!groups_) return {};
    const int patch = mesh_.property(patch_of_, fh);
    const bool is_first = fh.idx() == 0;
    if (!is_first && patch == mesh_.property(patch_of_, FaceHandle(fh.idx() - 1))) return {};
    return groups_->of_patch(patch);
  }

 private:
  const PolyMesh& mesh_;
  decltype(keys::face_patch)::Handle patch_of_;
  std::optional<ObjGroups> groups_;
};

void write_obj(const PolyMesh& mesh, const MeshNames& names, const OutputOptions& options,
               OutputFile& file) {
  FileWriter writer(file);
  writer.text("# surfmesh");
  const SharedVertices vertices(mesh);
  write_points(mesh, "v", writer);
  const bool has_texture = options.texture && find(mesh, keys::corner_texture).is_valid();
  CornerWriter uvs(mesh, has_texture ? keys::corner_texture : keys::corner_uv,
                   has_texture || options.uv, has_texture ? Unset::HasNoNumber : Unset::IsFault);
  CornerWriter normals(mesh, keys::corner_normal, options.normals);
  uvs.write_values("\nvt", writer);
  normals.write_values("\nvn", writer);
  const GroupLines groups(mesh, names, writer);
  writer.pieces(mesh.n_faces(), [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
    for (std::size_t f = first; f < end; ++f) {
      const FaceHandle fh(static_cast<int>(f));
      buffer.text(groups.before(fh));
      buffer.text("\nf");
      for_each_corner(mesh, fh, [&](HalfedgeHandle heh) {
        buffer.number(' ', vertices.number(mesh.to_vertex_handle(heh).idx()) + 1);
        const int uv = uvs.number(heh);
        if (uv > 0) buffer.number('/', uv);
        if (!normals.has_values()) return;
        if (uv == 0) buffer.text("/");
        buffer.number('/', normals.number(heh));
      });
    }
  });
  writer.text("\n");
  writer.flush();
}

/// Names that are other words in an OBJ file.
std::vector<ChangedName> changed_in_obj(const PolyMesh& mesh, const MeshNames& names) {
  std::vector<ChangedName> changed;
  if (!find(mesh, keys::face_patch).is_valid()) return changed;
  const ObjWords words(names, names.patches.size());
  const auto compare = [&](const std::string& name, const std::string& word) {
    if (name != word) changed.push_back({name, word});
  };
  for (std::size_t p = 0; p < names.patches.size(); ++p) {
    if (!names.patches[p].empty()) compare(names.patches[p], words.patches[p]);
  }
  for (std::size_t g = 0; g < names.groups.size(); ++g) {
    compare(names.groups[g].name, words.groups[g]);
  }
  return changed;
}

std::vector<std::string> lost_in_obj(const PolyMesh& mesh, const MeshNames& names,
                                     const OutputOptions& options) {
  const bool has_texture = options.texture && find(mesh, keys::corner_texture).is_valid();
  std::vector<std::string> lost = lost_properties(
      mesh, {.normals = options.normals, .uv = options.uv && !has_texture, .texture = has_texture});
  const std::size_t count = changed_in_obj(mesh, names).size();
  if (count > 0) {
    lost.insert(lost.begin(), fmt::format("{} names of patches and groups, which are changed to be "
                                          "words of their own",
                                          count));
  }
  return lost;
}

}  // namespace

Cage parse_obj(std::string_view text, const std::string& name) {
  ObjReader reader(text, name, ReadFor::Cage);
  Cage cage = reader.read();
  cage.groups = reader.labels().cage_groups();
  return cage;
}

MeshFormat obj_format() {
  return {.ending = ".obj",
          .parse = parse_obj_mesh,
          .parse_cage = parse_obj,
          .write = write_obj,
          .has_corner_values = true,
          .what_is_lost = lost_in_obj,
          .changed_names = changed_in_obj};
}

}  // namespace surfmesh
