// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "surfmesh/formats/parse_cage.hh"
#include "surfmesh/formats/read_cage.hh"

namespace surfmesh {
namespace {

/// Keywords without meaning for a cage.
constexpr std::array<std::string_view, 17> kIgnoredKeywords = {
    "vt", "vn",  "vp",    "o",      "s",        "l",        "p",          "mtllib",   "maplib",
    "mg", "lod", "bevel", "usemap", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

/// Tags of OpenSubdiv's suite that a limit surface's shape does not depend on, or that only old
/// renderers know.
constexpr std::array<std::string_view, 6> kIgnoredTags = {"facevaryinginterpolateboundary",
                                                          "facevaryingpropagatecorners",
                                                          "vertexedit",
                                                          "edgeedit",
                                                          "faceedit",
                                                          "edit"};

/// An undirected edge as a key.
std::uint64_t edge_key(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name, ReadFor purpose)
      : scanner_(text, name, TextScanner::Joining::Backslash), warnings_(name), purpose_(purpose) {}

  Cage read();

 private:
  /// An index that is checked at the end, for what it names may come later.
  struct Reference {
    int line = 0;
    int index = 0;    ///< from 0
    int written = 0;  ///< as it stands in the file
  };
  /// The two or three parts of a tag's values: `t name ints/reals/words ...`.
  struct TagValues {
    std::vector<int> ints;
    std::vector<double> reals;
    std::vector<std::string_view> words;
  };

  void read_statement(std::string_view keyword);
  void read_vertex();
  void read_face();
  int read_corner(std::string_view word);
  void check_ignored_indices(std::string_view indices) const;
  void read_group_names();
  void read_material();
  std::size_t group_named(const std::string& name, bool is_material);
  void add_face_to_groups();

  void read_tag();
  TagValues read_tag_values();
  void read_crease(const TagValues& values);
  void read_corner_tag(const TagValues& values);
  void read_boundary_rule(const TagValues& values);
  bool read_choice(const TagValues& values, std::string_view off, std::string_view on);
  int vertex_of_tag(int index);
  double sharpness_of(const TagValues& values, std::size_t i, std::size_t count) const;

  void check_references() const;
  void drop_creases_without_edge();

  TextScanner scanner_;
  WarningList warnings_;
  ReadFor purpose_;
  Cage cage_;
  std::vector<int> corners_;  ///< of the face that is being read
  std::vector<Reference> later_vertices_;
  std::vector<Reference> hole_faces_;
  std::vector<int> crease_lines_;           ///< parallel to cage_.creases
  std::vector<std::string> group_names_;    ///< of the last `g`
  std::string material_;                    ///< of the last `usemtl`
  std::vector<std::size_t> active_groups_;  ///< of both, once a face has come
  bool are_groups_current_ = true;          ///< false after a change of names
  std::unordered_map<std::string, std::size_t> group_of_name_;
};

Cage ObjReader::read() {
  if (!scanner_.next_line()) scanner_.fail_whole("the file is empty");
  do {
    read_statement(scanner_.next_word());
  } while (scanner_.next_line());
  check_not_empty(cage_, scanner_);
  check_references();
  drop_creases_without_edge();
  cage_.warnings = warnings_.texts();
  return std::move(cage_);
}

void ObjReader::read_statement(std::string_view keyword) {
  if (keyword == "v") return read_vertex();
  if (keyword == "f") return read_face();
  if (keyword == "g") return read_group_names();
  if (keyword == "usemtl") return read_material();
  if (keyword == "t") return read_tag();
  if (std::find(kIgnoredKeywords.begin(), kIgnoredKeywords.end(), keyword) !=
      kIgnoredKeywords.end()) {
    return;
  }
  warnings_.add(scanner_.line(), fmt::format("unknown keyword {} is ignored", quoted(keyword)),
                "unknown keyword");
}

void ObjReader::read_vertex() {
  Vec3 point;
  for (int k = 0; k < 3; ++k) {
    const std::string_view word = scanner_.next_word();
    if (word.empty()) scanner_.fail("a vertex needs three coordinates");
    point[k] = scanner_.to_number(word, "a coordinate");
  }
  cage_.points.push_back(point);
}

void ObjReader::read_face() {
  corners_.clear();
  for (auto word = scanner_.next_word(); !word.empty(); word = scanner_.next_word()) {
    corners_.push_back(read_corner(word));
  }
  add_face(cage_, corners_, purpose_, scanner_, warnings_);
  add_face_to_groups();
}

int ObjReader::read_corner(std::string_view word) {
  const std::size_t slash = word.find('/');
  const int index = scanner_.to_integer(word.substr(0, slash), "a vertex index");
  if (slash != std::string_view::npos) check_ignored_indices(word.substr(slash));
  const int count = static_cast<int>(cage_.points.size());
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

void ObjReader::check_ignored_indices(std::string_view indices) const {
  if (indices.find_first_not_of("/-+0123456789") != std::string_view::npos ||
      std::count(indices.begin(), indices.end(), '/') > 2) {
    scanner_.fail(
        fmt::format("{} after a vertex index, which is not /vt, //vn or /vt/vn", quoted(indices)));
  }
}

void ObjReader::read_group_names() {
  group_names_.clear();
  for (auto word = scanner_.next_word(); !word.empty(); word = scanner_.next_word()) {
    group_names_.emplace_back(word);
  }
  if (group_names_.empty()) group_names_.emplace_back("default");
  are_groups_current_ = false;
  if (purpose_ == ReadFor::Cage) return;
  for (const std::string& name : group_names_) group_named(name, false);
}

void ObjReader::read_material() {
  material_ = scanner_.next_word();
  are_groups_current_ = false;
  if (purpose_ == ReadFor::Mesh && !material_.empty()) group_named(material_, true);
}

/// The group of a name, made if there is none. A group of `g` and of `usemtl` is no material.
std::size_t ObjReader::group_named(const std::string& name, bool is_material) {
  const auto [entry, is_new] = group_of_name_.try_emplace(name, cage_.groups.size());
  if (is_new) cage_.groups.push_back({name, {}, is_material});
  if (!is_material) cage_.groups[entry->second].is_material = false;
  return entry->second;
}

void ObjReader::add_face_to_groups() {
  if (!are_groups_current_) {
    active_groups_.clear();
    const auto activate = [this](std::size_t group) {
      if (std::find(active_groups_.begin(), active_groups_.end(), group) == active_groups_.end()) {
        active_groups_.push_back(group);
      }
    };
    for (const std::string& name : group_names_) activate(group_named(name, false));
    if (!material_.empty()) activate(group_named(material_, true));
    are_groups_current_ = true;
  }
  const int face = static_cast<int>(cage_.faces.size()) - 1;
  for (const std::size_t group : active_groups_) cage_.groups[group].faces.push_back(face);
}

void ObjReader::read_tag() {
  const std::string_view tag = scanner_.next_word();
  if (tag == "crease") return read_crease(read_tag_values());
  if (tag == "corner") return read_corner_tag(read_tag_values());
  if (tag == "interpolateboundary") return read_boundary_rule(read_tag_values());
  if (tag == "hole") {
    for (const int face : read_tag_values().ints) {
      hole_faces_.push_back({scanner_.line(), face, face});
      cage_.holes.push_back(face);
    }
  } else if (tag == "creasemethod") {
    cage_.is_chaikin = read_choice(read_tag_values(), "normal", "chaikin");
  } else if (tag == "smoothtriangles") {
    cage_.is_smooth_triangles = read_choice(read_tag_values(), "catmark", "smooth");
  } else if (std::find(kIgnoredTags.begin(), kIgnoredTags.end(), tag) != kIgnoredTags.end()) {
    warnings_.add(scanner_.line(), fmt::format("the tag {} is ignored", tag));
  } else {
    warnings_.add(scanner_.line(), fmt::format("unknown tag {} is ignored", quoted(tag)),
                  "unknown tag");
  }
}

ObjReader::TagValues ObjReader::read_tag_values() {
  const std::string_view counts = scanner_.next_word();
  const std::size_t first = counts.find('/');
  const std::size_t second = first == counts.npos ? first : counts.find('/', first + 1);
  if (second == counts.npos) {
    scanner_.fail(fmt::format("the counts of a tag are {}, not like 2/1/0", quoted(counts)));
  }
  const auto next = [this] {
    const std::string_view word = scanner_.next_word();
    if (word.empty()) scanner_.fail("a tag has fewer values than its counts tell");
    return word;
  };
  const int ints = scanner_.to_integer(counts.substr(0, first), "a count");
  const int reals = scanner_.to_integer(counts.substr(first + 1, second - first - 1), "a count");
  const int words = scanner_.to_integer(counts.substr(second + 1), "a count");
  TagValues values;
  for (int i = 0; i < ints; ++i) values.ints.push_back(scanner_.to_integer(next(), "an index"));
  for (int i = 0; i < reals; ++i) {
    values.reals.push_back(scanner_.to_number(next(), "a value of a tag"));
  }
  for (int i = 0; i < words; ++i) values.words.push_back(next());
  if (!scanner_.next_word().empty()) {
    warnings_.add(scanner_.line(), "a tag has more values than its counts tell, they are ignored");
  }
  return values;
}

/// One sharpness for all, or one for each of `count`.
double ObjReader::sharpness_of(const TagValues& values, std::size_t i, std::size_t count) const {
  if (values.reals.empty() || (values.reals.size() > 1 && values.reals.size() < count)) {
    scanner_.fail("a crease or corner has too few values of sharpness");
  }
  const double sharpness = values.reals.size() > 1 ? values.reals[i] : values.reals[0];
  if (sharpness < 0) scanner_.fail("a sharpness is negative");
  return sharpness;
}

int ObjReader::vertex_of_tag(int index) {
  if (index < 0) scanner_.fail(fmt::format("vertex index {} of a tag is negative", index));
  later_vertices_.push_back({scanner_.line(), index, index});
  return index;
}

void ObjReader::read_crease(const TagValues& values) {
  if (values.ints.size() < 2) scanner_.fail("a crease needs two vertices");
  for (const int vertex : values.ints) vertex_of_tag(vertex);
  for (std::size_t i = 0; i + 1 < values.ints.size(); ++i) {
    const double sharpness = sharpness_of(values, i, values.ints.size() - 1);
    cage_.creases.push_back({{values.ints[i], values.ints[i + 1]}, sharpness});
    crease_lines_.push_back(scanner_.line());
  }
}

void ObjReader::read_corner_tag(const TagValues& values) {
  if (values.ints.empty()) scanner_.fail("a corner needs a vertex");
  for (std::size_t i = 0; i < values.ints.size(); ++i) {
    const double sharpness = sharpness_of(values, i, values.ints.size());
    cage_.corners.push_back({vertex_of_tag(values.ints[i]), sharpness});
  }
}

void ObjReader::read_boundary_rule(const TagValues& values) {
  constexpr std::array rules = {BoundaryRule::None, BoundaryRule::EdgeAndCorner,
                                BoundaryRule::EdgeOnly};
  if (values.ints.size() != 1 || values.ints[0] < 0 || values.ints[0] > 2) {
    scanner_.fail("interpolateboundary needs one value: 0 none, 1 edge and corner, 2 edge only");
  }
  cage_.boundary = rules[static_cast<std::size_t>(values.ints[0])];
}

bool ObjReader::read_choice(const TagValues& values, std::string_view off, std::string_view on) {
  if (values.words.size() == 1 && values.words[0] == off) return false;
  if (values.words.size() == 1 && values.words[0] == on) return true;
  scanner_.fail(fmt::format("the value of this tag is neither {} nor {}", off, on));
}

void ObjReader::check_references() const {
  const int vertex_count = static_cast<int>(cage_.points.size());
  for (const Reference& vertex : later_vertices_) {
    if (vertex.index < vertex_count) continue;
    scanner_.fail_at(vertex.line, fmt::format("vertex index {}, but there are {} vertices",
                                              vertex.written, vertex_count));
  }
  const int face_count = static_cast<int>(cage_.faces.size());
  for (const Reference& face : hole_faces_) {
    if (face.index >= 0 && face.index < face_count) continue;
    scanner_.fail_at(face.line, fmt::format("face index {} of a hole, but there are {} faces",
                                            face.written, face_count));
  }
}

/// Leave out creases that name no edge of a face, with a warning that knows the line.
void ObjReader::drop_creases_without_edge() {
  if (cage_.creases.empty()) return;
  std::unordered_set<std::uint64_t> edges;
  for (const std::vector<int>& face : cage_.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i], b = face[(i + 1) % face.size()];
      if (a != b) edges.insert(edge_key(a, b));
    }
  }
  std::vector<Cage::Crease> kept;
  for (std::size_t i = 0; i < cage_.creases.size(); ++i) {
    const auto [a, b] = cage_.creases[i].edge;
    if (edges.contains(edge_key(a, b))) {
      kept.push_back(cage_.creases[i]);
      continue;
    }
    warnings_.add(crease_lines_[i],
                  fmt::format("crease: {} and {} (counted from 0) are not an edge of a face", a, b),
                  "crease without edge");
  }
  cage_.creases = std::move(kept);
}

}  // namespace

Cage parse_obj(std::string_view text, const std::string& name, ReadFor purpose) {
  return ObjReader(text, name, purpose).read();
}

Cage parse_obj(std::string_view text, const std::string& name) {
  return parse_obj(text, name, ReadFor::Cage);
}

}  // namespace surfmesh
