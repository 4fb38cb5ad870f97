// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/obj_texture.hh"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace surfmesh {
namespace {

/// The number of a word; NaN if it is none.
double number_of(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_number = error == std::errc() && stop == word.data() + word.size();
  return is_number && std::isfinite(value) ? value : kUnset;
}

}  // namespace

/// The second number may be missing: a texture along a line.
void ObjTexture::read_point() {
  const std::string_view u = text_.scanner.next_word(), v = text_.scanner.next_word();
  Uv point{number_of(u), v.empty() ? 0 : number_of(v)};
  if (std::isnan(point.u) || std::isnan(point.v)) {
    point = {};
    text_.warnings.add(text_.scanner.line(), "texture coordinates that are no numbers are ignored");
  }
  texture().points.push_back(point);
}

void ObjTexture::add_corner(std::string_view indices) {
  corners_.push_back(-1);
  if (indices.empty()) return;
  indices.remove_prefix(1);
  const std::string_view word = indices.substr(0, indices.find('/'));
  if (word.empty()) return;
  const int index = text_.scanner.to_integer(word, "a texture index");
  const int count = static_cast<int>(texture().points.size());
  const int number = index > 0 ? index - 1 : count + index;
  if (index == 0 || number < 0) {
    text_.warnings.add(text_.scanner.line(),
                       fmt::format("texture index {}, but {} texture coordinates before it; it is "
                                   "ignored",
                                   index, count),
                       "texture index");
    return;
  }
  corners_.back() = number;
  if (number >= count) later_.push_back({text_.scanner.line(), number, index});
}

void ObjTexture::end_face() {
  std::vector<std::vector<int>>& faces = texture().faces;
  const bool has_any = std::any_of(corners_.begin(), corners_.end(), [](int c) { return c >= 0; });
  if (!has_any && faces.empty()) return;
  // Those before the first face with a texture have none.
  while (faces.size() + 1 < text_.cage.faces.size()) {
    faces.emplace_back(text_.cage.faces[faces.size()].size(), -1);
  }
  faces.push_back(corners_);
}

void ObjTexture::finish() {
  const auto count = static_cast<int>(texture().points.size());
  bool is_complete = true;
  for (const LaterReference& corner : later_) {
    if (corner.index < count) continue;
    is_complete = false;
    text_.warnings.add(corner.line,
                       fmt::format("texture index {}, but there are {} texture coordinates; it is "
                                   "ignored",
                                   corner.written, count),
                       "texture index");
  }
  if (!is_complete) {
    for (std::vector<int>& face : texture().faces) {
      for (int& corner : face) corner = corner < count ? corner : -1;
    }
  }
  if (texture().faces.empty()) texture().points.clear();
}

}  // namespace surfmesh
