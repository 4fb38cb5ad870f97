// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/obj_tags.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_set>
#include <utility>

namespace surfmesh {
namespace {

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

}  // namespace

void ObjTags::read() {
  const std::string_view tag = scanner_.next_word();
  if (tag == "crease") return read_crease(read_values());
  if (tag == "corner") return read_corner(read_values());
  if (tag == "interpolateboundary") return read_boundary_rule(read_values());
  if (tag == "hole") {
    for (const int face : read_values().ints) {
      hole_faces_.push_back({scanner_.line(), face, face});
    }
  } else if (tag == "creasemethod") {
    cage_.is_chaikin = read_choice(read_values(), "normal", "chaikin");
  } else if (tag == "smoothtriangles") {
    cage_.is_smooth_triangles = read_choice(read_values(), "catmark", "smooth");
  } else if (std::find(kIgnoredTags.begin(), kIgnoredTags.end(), tag) != kIgnoredTags.end()) {
    warnings_.add(scanner_.line(), fmt::format("the tag {} is ignored", tag));
  } else {
    warnings_.add(scanner_.line(), fmt::format("unknown tag {} is ignored", quoted(tag)),
                  "unknown tag");
  }
}

ObjTags::Values ObjTags::read_values() {
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
  Values values;
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
double ObjTags::sharpness_of(const Values& values, std::size_t i, std::size_t count) const {
  if (values.reals.empty() || (values.reals.size() > 1 && values.reals.size() < count)) {
    scanner_.fail("a crease or corner has too few values of sharpness");
  }
  const double sharpness = values.reals.size() > 1 ? values.reals[i] : values.reals[0];
  if (sharpness < 0) scanner_.fail("a sharpness is negative");
  return sharpness;
}

int ObjTags::vertex_of_tag(int index) {
  if (index < 0) scanner_.fail(fmt::format("vertex index {} of a tag is negative", index));
  later_vertices_.push_back({scanner_.line(), index, index});
  return index;
}

void ObjTags::read_crease(const Values& values) {
  if (values.ints.size() < 2) scanner_.fail("a crease needs two vertices");
  for (const int vertex : values.ints) vertex_of_tag(vertex);
  for (std::size_t i = 0; i + 1 < values.ints.size(); ++i) {
    const double sharpness = sharpness_of(values, i, values.ints.size() - 1);
    cage_.creases.push_back({{values.ints[i], values.ints[i + 1]}, sharpness});
    crease_lines_.push_back(scanner_.line());
  }
}

void ObjTags::read_corner(const Values& values) {
  if (values.ints.empty()) scanner_.fail("a corner needs a vertex");
  for (std::size_t i = 0; i < values.ints.size(); ++i) {
    const double sharpness = sharpness_of(values, i, values.ints.size());
    cage_.corners.push_back({vertex_of_tag(values.ints[i]), sharpness});
  }
}

void ObjTags::read_boundary_rule(const Values& values) {
  constexpr std::array rules = {BoundaryRule::None, BoundaryRule::EdgeAndCorner,
                                BoundaryRule::EdgeOnly};
  if (values.ints.size() != 1 || values.ints[0] < 0 || values.ints[0] > 2) {
    scanner_.fail("interpolateboundary needs one value: 0 none, 1 edge and corner, 2 edge only");
  }
  cage_.boundary = rules[static_cast<std::size_t>(values.ints[0])];
}

bool ObjTags::read_choice(const Values& values, std::string_view off, std::string_view on) {
  if (values.words.size() == 1 && values.words[0] == off) return false;
  if (values.words.size() == 1 && values.words[0] == on) return true;
  scanner_.fail(fmt::format("the value of this tag is neither {} nor {}", off, on));
}

void ObjTags::drop_creases_without_edge() {
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

void ObjTags::number_holes() {
  const std::vector<int>& left_out = text_.left_out();
  const int face_count = static_cast<int>(cage_.faces.size() + left_out.size());
  for (const Reference& face : hole_faces_) {
    if (face.index < 0 || face.index >= face_count) {
      scanner_.fail_at(face.line, fmt::format("face index {} of a hole, but there are {} faces",
                                              face.written, face_count));
    }
    const auto next = std::lower_bound(left_out.begin(), left_out.end(), face.index);
    if (next != left_out.end() && *next == face.index) continue;
    cage_.holes.push_back(face.index - static_cast<int>(next - left_out.begin()));
  }
}

}  // namespace surfmesh
